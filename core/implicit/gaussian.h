// How steep and how curved is the Gaussian of a distance, where that distance lies between two numbers?
//
// Before it: the nearest and the farthest point of a box, seen from a blob.
// After it: the gradient bounds of blobby.h and blobby_cylinders.h.
//
// Let d be the distance to a convex set (a point, a segment) and g = exp(-d^2 / s^2). In units of s:
//   - |grad g| = 2 d exp(-d^2) rises to d = sqrt(1/2) and falls from there.
//   - Along the direction from the nearest point d grows like a coordinate, so the second derivative of g is
//     2 (2 u - 1) exp(-u) with u = d^2, largest at u = 3/2. Across it that of d^2 is between 0 and 2, so g's
//     is between -2 exp(-u) and 0, and falls in size. No mixed terms: these are bounds on eigenvalues.
//   - Where the nearest point passes an end of a segment the second derivatives jump; the gradient does not,
//     so it still changes by no more than their bound times the way.
#pragma once

#include <algorithm>
#include <cmath>

namespace seesaw {

struct GaussianBounds {
  double slope;    ///< |grad g| is at most this; per scene unit
  double hessian;  ///< and so is the size of every second derivative; per scene unit squared
};

/// For 0 <= `near` <= distance <= `far` in scene units and deviation s > 0.
inline GaussianBounds gaussian_bounds(double near, double far, double s) {
  near /= s;
  far /= s;
  const double steepest = std::clamp(std::sqrt(0.5), near, far);
  const double u = std::clamp(1.5, near * near, far * far);
  const double largest = std::max(std::exp(-near * near), (2 * u - 1) * std::exp(-u));
  return {2 * steepest * std::exp(-steepest * steepest) / s, 2 * largest / (s * s)};
}

}  // namespace seesaw
