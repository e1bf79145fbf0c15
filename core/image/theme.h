// The house palette: every color that a Seesaw picture uses, decided once.
//
// Calm enough for a printed page, dark enough for a projector, and told apart by color-blind readers: no
// meaning hangs on red against green, and lightness differs wherever hue does. The papers draw what is new
// or was moved in red; ours is a vermilion-red that deuteranopes see as a dark yellow-brown, far from the
// navy curve.
//
// Before it: color.h. After it: every picture.
#pragma once

#include <array>
#include <cstddef>

#include "core/image/color.h"

namespace seesaw::theme {

inline constexpr Color paper = hex("#FFFFFF");
/// Text, axes and symbols: black, softened a little so that it does not glare on a projector.
inline constexpr Color ink = hex("#1B1F24");
/// Secondary text: tick labels, captions.
inline constexpr Color soft_ink = hex("#59616B");
/// Grid lines and frames that should be felt rather than seen.
inline constexpr Color grid = hex("#DDE1E6");
/// The implicit curve, f = 0.
inline constexpr Color curve = hex("#14213D");
/// Constraints where the curve must pass, and their interior and exterior companions.
inline constexpr Color constraint = ink;
/// What is new or was moved: the papers' red.
inline constexpr Color moved = hex("#CC3311");
/// Isolines of f other than zero.
inline constexpr Color isoline = hex("#7A8491");
/// Where there is no value to show (not a number).
inline constexpr Color missing = hex("#C9CDD2");

/// Okabe and Ito's palette (2008), ordered so that the first few differ most in lightness too. Its yellow
/// is left out: it vanishes on paper.
inline constexpr std::array<Color, 7> series = {hex("#0072B2"), hex("#D55E00"), hex("#009E73"),
                                                hex("#CC79A7"), hex("#E69F00"), hex("#56B4E9"),
                                                hex("#1B1F24")};

/// The color of chart series number `i`, counted from 0; after seven they begin again.
inline constexpr Color series_color(std::size_t i) { return series[i % series.size()]; }

}  // namespace seesaw::theme
