// Do two solids overlap? Where, and how much volume do they share?
//
// Before it: two fields, f > 0 inside.
// After it: a designer who moves one of them; clearance.h says how far apart they are if they are.
//
// Turk & O'Brien 2002 name interference detection (abstract, section 1) as what implicit surfaces are good
// for: a point is in both solids when both functions are positive there. Points prove that there is an
// overlap, never that there is none; the fields' bounds do. In a cell of half diagonal R around m
//     f(m) - R sup |grad f| > 0 proves all of it inside,   f(m) + R sup |grad f| < 0 all of it outside.
// A cell of which neither is proven is halved in each direction, until the volume left open is small. A bound
// costs an interpolant as much as tens of values, and is loose for large cells; so a cell inherits the
// bound of the one it was cut from, and asks for one of its own every second time. Where there are too many
// cells for that, one far from a surface for its slope is *presumed* inside or outside. Hence three numbers:
//
//     low, high   the true volume lies between them; what is only presumed counts for neither side
//     volume      the estimate: presumptions hold, and a cell left open counts by the share of it that lies
//                 inside both if the functions are linear there
//     error       how much the estimate changed when the cells were last halved: no proof, but what to expect
//
// Spheres, blobbies and booleans of them are proven all over, interpolants of some hundred centers nearly so;
// for a model of 1,600 centers [low, high] is some ten percent either side of the volume after seconds. The
// estimate is good long before.
//
//     const Interference found = interference(a, b);
//     if (found.overlap) use(found.volume, found.where);      // low <= true volume <= high
//     else if (found.certain) use(clearance(a, b).distance);  // proven apart
#pragma once

#include <optional>

#include "core/base/progress.h"
#include "core/implicit/field.h"

namespace seesaw {

struct InterferenceOptions {
  /// Stop when the volume left open is at most this fraction of the volume inside both.
  double width = 0.05;
  /// Stop rather than evaluate each function at more points than this: the interval is then wider.
  Index evaluations = 2'000'000;
  /// Ask for no more bounds than this; then presume.
  Index bounds = 300'000;
  /// Where to look. None: what the two bounding boxes have in common; what sticks out of them is not seen.
  std::optional<Box<3>> box = std::nullopt;
};

struct Interference {
  /// A point was found where both functions are positive.
  bool overlap = false;
  /// Whether that is proven: always for an overlap, but for rounding. Without one, false means that the work
  /// ended before the solids could be told apart everywhere.
  bool certain = false;
  double volume = 0;         ///< the estimate, cubed scene units
  double error = 0;          ///< of the estimate, estimated
  double low = 0, high = 0;  ///< the true volume within the box lies between these
  /// Around all cells that hold some of the estimated volume; empty for none.
  Box<3> where;
  /// The deepest point found: where the smaller of the two functions is largest nearby. Only for an overlap.
  Point<3> deepest = Point<3>::Zero();
  Index evaluations = 0;  ///< points at which each function was evaluated at most
  Index bounds = 0;       ///< bounds of either function that were asked for
};

/// Throws Cancelled. The same result for any number of threads.
Interference interference(const Field<3>& a, const Field<3>& b, const InterferenceOptions& options = {},
                          const Progress& progress = {});

}  // namespace seesaw
