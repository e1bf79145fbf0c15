// Inside core/raytrace: fixed patterns of sample points, so that the same scene always gives the same
// picture.
//
// The pattern is the R2 sequence (Roberts 2018, "The unreasonable effectiveness of quasirandom sequences"):
// point i is the fractional part of i * (1/p, 1/p^2), p the plastic number. It fills the square evenly for
// any number of points. Each pixel and purpose shifts it by a number of its own, a hash of its place, so that
// neighbors do not repeat each other's error as a visible pattern.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/base/types.h"

namespace seesaw {

/// Mixes all bits of `x` (Stafford's variant 13 of the 64-bit finalizer).
inline std::uint64_t mixed_bits(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

/// Point `i` of the pattern, shifted by the hash `shift`: both parts in [0, 1).
inline Point<2> pattern_point(std::uint64_t i, std::uint64_t shift = 0) {
  constexpr double a = 0.7548776662466927, b = 0.5698402909980532;
  const double n = static_cast<double>(i) + 0.5;
  const double x = n * a + static_cast<double>(shift >> 32) * 0x1p-32;
  const double y = n * b + static_cast<double>(shift & 0xffffffffULL) * 0x1p-32;
  return {x - std::floor(x), y - std::floor(y)};
}

/// A point of the unit disc for a point of the unit square, areas kept in proportion.
inline Point<2> disc_point(const Point<2>& square) {
  const double radius = std::sqrt(square.x()), angle = 2 * std::numbers::pi * square.y();
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// Two unit vectors across the unit vector `n` and each other (Duff et al. 2017).
inline void across(const Point<3>& n, Point<3>& u, Point<3>& v) {
  const double sign = std::copysign(1.0, n.z());
  const double a = -1.0 / (sign + n.z()), b = n.x() * n.y() * a;
  u = {1.0 + sign * n.x() * n.x() * a, sign * b, -sign * n.x()};
  v = {b, sign + n.y() * n.y() * a, -n.y()};
}

/// A direction of the hemisphere about the unit vector `n`, as likely as its cosine to n is large.
inline Point<3> cosine_direction(const Point<3>& n, const Point<2>& square) {
  Point<3> u, v;
  across(n, u, v);
  const Point<2> d = disc_point(square);
  return (d.x() * u + d.y() * v + std::sqrt(std::max(0.0, 1 - d.squaredNorm())) * n).normalized();
}

}  // namespace seesaw
