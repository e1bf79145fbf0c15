// What surfaces look like: a matt color, a soft highlight, a mirror; and the colors that the house uses.
//
// Colors are sRGB, as everywhere in Seesaw (core/image/color.h); the tracer converts them to amounts of
// light, adds light up there, and converts back once (linear_light.h).
//
// Before it: core/image/theme.h, whose hues these are, lightened for shaded surfaces. After it: scene.h.
#pragma once

#include <optional>

#include "core/image/color.h"

namespace seesaw {

/// Surface colors that stay apart for color-blind readers and in gray prints, light enough that shading
/// shows.
namespace surface {
inline constexpr Color clay = hex("#D9D4C9");          ///< the neutral one: what a surface has unless told
inline constexpr Color blue = hex("#7FA8D1");          ///< the first of several objects
inline constexpr Color orange = hex("#E8A35C");        ///< the second
inline constexpr Color teal = hex("#6DB5A0");          ///< the third
inline constexpr Color rose = hex("#D39BB8");          ///< the fourth
inline constexpr Color sand = hex("#E3C878");          ///< the fifth
inline constexpr Color slate = hex("#8A94A3");         ///< the sixth
inline constexpr Color marker = hex("#C8371B");        ///< constraints and what was moved: the papers' red
inline constexpr Color polygon_edge = hex("#3A3F47");  ///< edges of polygon models
inline constexpr Color floor_light = hex("#F4F3F1");
inline constexpr Color floor_dark = hex("#C3C7CD");

/// The color of object number `i`, counted from 0; after seven they begin again.
constexpr Color of_object(int i) {
  constexpr Color all[] = {blue, orange, teal, rose, sand, slate, clay};
  return all[i % 7];
}
}  // namespace surface

struct Material {
  Color color = surface::clay;
  /// The side that an outward normal does not leave by: the inside of an open mesh. Nothing for a darker,
  /// warmer tint of `color`.
  std::optional<Color> back_color = {};
  double highlight = 0.12;  ///< strength of the lights' highlights, 0 for none
  double gloss = 40;        ///< exponent of the highlight: larger is smaller and sharper
  double mirror = 0;        ///< fraction of the light that is reflected as by a mirror, 0 .. 1
};

}  // namespace seesaw
