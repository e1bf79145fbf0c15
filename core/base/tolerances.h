// Every tolerance of Seesaw, named, in one place. Each is a pure number: lengths are this times the extent of
// the scene (the longest side of the box around its constraints), values this times the largest |value| asked
// for.
#pragma once

namespace seesaw::tolerance {

/// Centers nearer than this, relative to the extent, are one center. Doubles resolve coordinates to 1e-16 of
/// their size; at 1e-12 the rows of two thin-plate centers still differ by more than rounding.
inline constexpr double coincident = 1e-12;

/// Values at one position that differ by less than this, relative to the largest |value|, are the same value.
inline constexpr double same_value = 1e-12;

/// Points count as on one line or plane when they stray from it by less than this, relative to the extent.
inline constexpr double degenerate = 1e-10;

/// A vertex is on the curve when it is this near, relative to the extent of the box that is contoured.
inline constexpr double on_curve = 1e-12;

}  // namespace seesaw::tolerance
