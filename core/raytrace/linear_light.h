// Inside core/raytrace: amounts of light, and the way to and from sRGB.
//
// Light adds up; sRGB numbers do not (128 is a fifth of the light of 255). So everything between camera.h and
// the finished pixel is in these.
#pragma once

#include <cmath>

#include "core/base/types.h"
#include "core/image/color.h"

namespace seesaw {

/// Red, green and blue as amounts of light; 1 is a white pixel's.
using Light3 = Eigen::Array3d;

inline double linear_part(double part) {
  return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
}

inline double srgb_part(double light) {
  const double clamped = light < 0 ? 0 : light > 1 ? 1 : light;
  return clamped <= 0.0031308 ? 12.92 * clamped : 1.055 * std::pow(clamped, 1 / 2.4) - 0.055;
}

inline Light3 light_of(const Color& color) {
  return {linear_part(color.r), linear_part(color.g), linear_part(color.b)};
}

inline Color color_of_light(const Light3& light, double alpha = 1) {
  return {srgb_part(light[0]), srgb_part(light[1]), srgb_part(light[2]), alpha};
}

/// Surfaces brighter than `knee` bend toward white with the same slope, and reach it never: no flat white
/// spots.
inline Light3 softened(const Light3& light) {
  constexpr double knee = 0.75;
  return light.unaryExpr(
      [](double x) { return x <= knee ? x : knee + (1 - knee) * (1 - std::exp(-(x - knee) / (1 - knee))); });
}

}  // namespace seesaw
