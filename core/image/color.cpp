#include "core/image/color.h"

#include <algorithm>
#include <cmath>

namespace seesaw {
namespace {

// IEC 61966-2-1.
double linear_of(double part) {
  return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
}

double part_of(double linear) {
  const double clamped = std::clamp(linear, 0.0, 1.0);
  return clamped <= 0.0031308 ? 12.92 * clamped : 1.055 * std::pow(clamped, 1 / 2.4) - 0.055;
}

// The white point is the image of (1, 1, 1) under the matrix below, so that white is exactly a = b = 0.
constexpr double white_x = 0.4124564 + 0.3575761 + 0.1804375;
constexpr double white_y = 0.2126729 + 0.7151522 + 0.0721750;
constexpr double white_z = 0.0193339 + 0.1191920 + 0.9503041;

constexpr double bend = 6.0 / 29.0;  // below bend^3 the cube root is continued by its tangent

double bent(double t) { return t > bend * bend * bend ? std::cbrt(t) : t / (3 * bend * bend) + 4.0 / 29.0; }
double unbent(double t) { return t > bend ? t * t * t : 3 * bend * bend * (t - 4.0 / 29.0); }

}  // namespace

Color mix(const Color& a, const Color& b, double t) {
  t = std::clamp(t, 0.0, 1.0);
  const auto part = [t](double p, double q) { return p + (q - p) * t; };
  return {part(a.r, b.r), part(a.g, b.g), part(a.b, b.b), part(a.a, b.a)};
}

std::uint8_t byte_of(double part) {
  if (!(part > 0)) return 0;
  return static_cast<std::uint8_t>(std::min(part, 1.0) * 255 + 0.5);
}

Lab lab_of(const Color& color) {
  const double r = linear_of(color.r), g = linear_of(color.g), b = linear_of(color.b);
  const double x = bent((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / white_x);
  const double y = bent((0.2126729 * r + 0.7151522 * g + 0.0721750 * b) / white_y);
  const double z = bent((0.0193339 * r + 0.1191920 * g + 0.9503041 * b) / white_z);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Color color_of(const Lab& lab) {
  const double fy = (lab.L + 16) / 116;
  const double x = white_x * unbent(fy + lab.a / 500);
  const double y = white_y * unbent(fy);
  const double z = white_z * unbent(fy - lab.b / 200);
  return {part_of(3.2404542 * x - 1.5371385 * y - 0.4985314 * z),
          part_of(-0.9692660 * x + 1.8760108 * y + 0.0415560 * z),
          part_of(0.0556434 * x - 0.2040259 * y + 1.0572252 * z)};
}

double delta_e(const Lab& a, const Lab& b) { return std::hypot(a.L - b.L, a.a - b.a, a.b - b.b); }

Color seen_without_green_cones(const Color& color) {
  const double r = linear_of(color.r), g = linear_of(color.g), b = linear_of(color.b);
  return {part_of(0.367322 * r + 0.860646 * g - 0.227968 * b),
          part_of(0.280085 * r + 0.672501 * g + 0.047413 * b),
          part_of(-0.011820 * r + 0.042940 * g + 0.968881 * b), color.a};
}

}  // namespace seesaw
