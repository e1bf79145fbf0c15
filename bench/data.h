// The same points in every contestant, C++ or Python, by a formula instead of a file.
//
// Point i has coordinate d = 2 frac((i + 1) g^-(d + 1)) - 1 with g the root of g^(n + 1) = g + 1 (Roberts'
// sequence, the golden ratio in n dimensions): irregular, spread evenly over [-1, 1]^n, no two points near
// each other. bench/scipy_side.py has the same formula.
#pragma once

#include <cmath>

#include "core/base/types.h"

namespace seesaw::bench {

/// `n` points in [-1, 1]^Dim, Dim x n, from the sequence's point `first` on.
template <int Dim>
Points<Dim> spread_points(Index n, Index first = 0) {
  double g = 2.0;
  for (int step = 0; step < 60; ++step) g = std::pow(1.0 + g, 1.0 / (Dim + 1));
  Points<Dim> points(Dim, n);
  for (Index i = 0; i < n; ++i)
    for (int d = 0; d < Dim; ++d) {
      const double turn = static_cast<double>(first + i + 1) * std::pow(g, -(d + 1));
      points(d, i) = 2.0 * (turn - std::floor(turn)) - 1.0;
    }
  return points;
}

/// A smooth function to fit, and weights that mix signs.
template <int Dim>
Values smooth_values(const Points<Dim>& points) {
  return (3.0 * points.row(0).array()).cos() * (2.0 * points.row(Dim - 1).array()).sin();
}
inline Values mixed_weights(Index n) {
  Values weights(n);
  for (Index i = 0; i < n; ++i)
    weights[i] = std::fmod(static_cast<double>(i + 1) * 0.6180339887498949, 1.0) - 0.5;
  return weights;
}

}  // namespace seesaw::bench
