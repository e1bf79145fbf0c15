// Vertices onto f = 0, by Newton's method along the gradient, with a leash.
//
// Before it: slide.h, which slides vertices off the surface a little.  After it: the finished mesh.
//
//     p <- p - f(p) g / |g|^2,   g = grad f(p)
//
// is the step to the zero of f's linear part that is nearest to p. A vertex on the box's face uses only what
// of g lies in the face. Who strays farther than the leash, or stops getting nearer, has failed.
#pragma once

#include <cstdint>
#include <vector>

#include "core/polygonize/sampler.h"

namespace seesaw {

struct Projected {
  Points<3> positions;     ///< 3 x N; those that failed stand where they started
  Points<3> gradients;     ///< 3 x N: grad f at the positions; zero where there is none
  std::vector<char> good;  ///< 1 where |f| / |g| is within the tolerance, or as near as rounding lets it come
};

struct ProjectOptions {
  double leash = 0;      ///< farthest way from the start, scene units
  double tolerance = 0;  ///< |f| / |g| that is near enough, scene units
  int steps = 20;        ///< at most; with 1 there is a single step, which is good if it stays on the leash
};

/// `start` is 3 x N. Bit d of fixed[i] keeps coordinate d of point i as it is; empty: all are free.
Projected project(Sampler& sampler, const Points<3>& start, const std::vector<std::uint8_t>& fixed,
                  const ProjectOptions& options);

}  // namespace seesaw
