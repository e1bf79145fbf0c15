// How good a triangle is: the squared sine of its smallest angle, which costs no root.
//
// Before it: corners.  After it: the moves (collapse.h, flip.h, slide.h), which make triangles better.
#pragma once

#include <algorithm>

#include "core/mesh/triangle_mesh.h"

namespace seesaw {

/// 37 degrees: a triangle better than this is left as it is. Most of a mesh is good from the start.
inline constexpr double good_as_it_is = 0.36;
/// 30 degrees: a triangle better than this may become worse, if others gain; what is worse in the end is a
/// needle.
inline constexpr double good_enough = 0.25;
/// The cosine of the largest turn that a move may give a triangle: 60 degrees.
inline constexpr double largest_turn = 0.5;

/// Twice the area long, toward the side from which a, b, c go counter-clockwise.
inline Point<3> normal_of(const Point<3>& a, const Point<3>& b, const Point<3>& c) {
  return (b - a).cross(c - a);
}

/// sin^2 of the smallest angle, 0 to 3/4: twice the area over the product of the two longer sides, squared.
/// `normal` is normal_of(a, b, c).
inline double quality_of(const Point<3>& a, const Point<3>& b, const Point<3>& c, const Point<3>& normal) {
  const double x = (b - a).squaredNorm(), y = (c - b).squaredNorm(), z = (a - c).squaredNorm();
  const double shortest = std::min({x, y, z});
  return shortest > 0 ? normal.squaredNorm() * shortest / (x * y * z) : 0.0;
}
inline double quality_of(const Point<3>& a, const Point<3>& b, const Point<3>& c) {
  return quality_of(a, b, c, normal_of(a, b, c));
}

/// Whether the angle between a and b has a cosine of `cosine` > 0 or more.
inline bool within(const Point<3>& a, const Point<3>& b, double cosine) {
  const double dot = a.dot(b);
  return dot > 0 && dot * dot >= cosine * cosine * a.squaredNorm() * b.squaredNorm();
}

/// The smallest angle of any triangle, degrees; 0 for no triangles.
double smallest_angle(const Points<3>& positions, const Faces& faces);

}  // namespace seesaw
