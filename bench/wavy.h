// A shape to edit: a wavy circle or ball of boundary constraints with their normals, and 40 interior ones.
#pragma once

#include <cmath>

#include "bench/data.h"
#include "core/rbf/constraints.h"

namespace seesaw::bench {

template <int Dim>
Point<Dim> direction_of(Index i, Index count) {
  if constexpr (Dim == 2) {
    const double angle = 2 * M_PI * static_cast<double>(i) / static_cast<double>(count);
    return {std::cos(angle), std::sin(angle)};
  } else {
    const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(count);
    const double angle = 2.399963229728653 * static_cast<double>(i), rho = std::sqrt(1 - z * z);
    return {rho * std::cos(angle), rho * std::sin(angle), z};
  }
}

inline constexpr Index inside = 40;

/// `inside` interior constraints, then the surface.
template <int Dim>
Constraints<Dim> wavy(Index rows) {
  const Points<Dim> middle = spread_points<Dim>(inside);
  Constraints<Dim> constraints;
  for (Index i = 0; i < inside; ++i)
    constraints.push_back(interior<Dim>(0.4 * middle.col(i), 1 + 0.3 * std::sin(static_cast<double>(i))));
  const Index count = (rows - inside) / 2;
  for (Index i = 0; i < count; ++i) {
    const Point<Dim> out = direction_of<Dim>(i, count);
    constraints.push_back(boundary<Dim>((1 + 0.1 * std::sin(5 * out[0])) * out, out, 0.01));
  }
  return constraints;
}

}  // namespace seesaw::bench
