// Surfaces with few parameters, and control points on them.
#pragma once

#include "core/base/random.h"
#include "core/implicit/parametric_shapes.h"
#include "core/particles/adhesion.h"
#include "core/particles/control_points.h"
#include "core/rbf/parametric_interpolant.h"

namespace seesaw {

inline constexpr double paper_step = 0.03;  // the paper's

inline ParametricBlobbySpheres<3> three_blobs() {  // 13 parameters
  return ParametricBlobbySpheres<3>(
      BlobbySpheres<3>(0.5, Points<3>{{-0.8, 0, 0.8}, {0, 0.3, 0}, {0, 0, 0.2}}, Values{{0.9, 0.8, 0.9}}));
}

inline ParametricBlobbyCylinders<3> two_cylinders() {  // 15
  return ParametricBlobbyCylinders<3>(BlobbyCylinders<3>(
      0.5, Points<3>{{-1, 0}, {0, -1}, {0, 0}}, Points<3>{{1, 0}, {0, 1}, {0, 0.5}}, Values{{0.5, 0.6}}));
}

inline ParametricInterpolant<3> octahedron() {  // 28: six on the surface, one inside
  Constraints<3> shape = {interior<3>({0, 0, 0})};
  for (int d = 0; d < 3; ++d)
    for (const double side : {-1.0, 1.0}) shape.push_back(boundary<3>(side * Point<3>::Unit(d)));
  return ParametricInterpolant<3>(shape);
}

// Points of the surface, at random.
inline ControlPoints<3> some_points_on(const Field<3>& field, Index n, Random& random) {
  ControlPoints<3> points;
  while (points.size() < n) {
    const Point<3> start = random.points_in<3>(field.bounding_box(), 1).col(0);
    const PutOn put = put_on(field, start, Values::Constant(1, 2.0), Values::Constant(1, 1e-14));
    if (put.on[0]) points.add(put.positions.col(0));
  }
  return points;
}

}  // namespace seesaw
