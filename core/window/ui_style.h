// How panels and menus look: calm, close to the printed figures, light or dark, at any size.
//
// Colors come from the house palette (core/image/theme.h); the dark ones are its negative in lightness, not
// in hue. One number scales everything, letters, margins and handles: 1 at a desk, 1.5 to 2.5 on a projector,
// so that the back of a hall can read it.
//
// Letters are DejaVu Sans as in the figures, with Greek and mathematical signs. Where that font is not
// installed the built-in one of Dear ImGui stands in, which has Latin letters only.
//
// Before it: core/image/theme.h. After it: window.cpp, which sets it; ui.h, which draws with it.
#pragma once

#include "core/image/color.h"

struct ImFont;

namespace seesaw {

/// What a program that draws its own canvas needs to match the panels around it.
struct UiColors {
  Color background;  ///< behind everything
  Color panel;
  Color line;   ///< frames and separators, to be felt rather than seen
  Color field;  ///< buttons, sliders and text fields at rest
  Color ink;
  Color soft_ink;  ///< secondary text
  Color accent;    ///< what is chosen or under the pointer
  Color warning;   ///< what went wrong, and what is new or was moved
};

UiColors ui_colors(bool dark);

namespace detail {

struct UiFonts {
  ImFont* regular = nullptr;
  ImFont* bold = nullptr;
  ImFont* heading = nullptr;
};

/// The size of text at scale 1, logical pixels.
inline constexpr double text_size = 15;

/// Sets Dear ImGui's style of the present context.
void set_style(bool dark, double scale);
/// Builds the fonts anew for a scale and the real pixels of a logical one. The letters' texture must be made
/// again afterwards.
UiFonts build_fonts(double scale, double pixel_ratio);

}  // namespace detail
}  // namespace seesaw
