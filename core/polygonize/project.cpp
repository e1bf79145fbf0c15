#include "core/polygonize/project.h"

#include <cmath>
#include <limits>

namespace seesaw {

namespace {

// Near a zero Newton's steps make |f| much smaller, unless rounding in f has set a floor. A floor further
// from the zero than this many tolerances is no rounding, but a hard field.
constexpr int stalls_allowed = 2;
constexpr double floor_reach = 1e3;

struct Walk {
  Index point;
  double least = std::numeric_limits<double>::infinity();  // smallest |f| / |g| met
  int stalls = 0;
};

}  // namespace

Projected project(Sampler& sampler, const Points<3>& start, const std::vector<std::uint8_t>& fixed,
                  const ProjectOptions& options) {
  const Index n = start.cols();
  Projected result{start, Points<3>::Zero(3, n), std::vector<bool>(static_cast<std::size_t>(n), false)};
  Points<3> at = start, points, gradients;
  std::vector<Walk> open;
  open.reserve(static_cast<std::size_t>(n));
  for (Index i = 0; i < n; ++i) {
    open.emplace_back();
    open.back().point = i;
  }
  for (int step = 0; step < options.steps && !open.empty(); ++step) {
    points.resize(3, static_cast<Index>(open.size()));
    for (std::size_t k = 0; k < open.size(); ++k) points.col(static_cast<Index>(k)) = at.col(open[k].point);
    const Values values = sampler.values(points, gradients);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < open.size(); ++k) {
      Walk walk = open[k];
      const Index i = walk.point;
      const double f = values[static_cast<Index>(k)];
      Point<3> g = gradients.col(static_cast<Index>(k));
      const Point<3> whole = g;
      if (!fixed.empty())
        for (int d = 0; d < 3; ++d)
          if (fixed[static_cast<std::size_t>(i)] >> d & 1u) g[d] = 0;
      const double away = f == 0 ? 0.0 : std::abs(f) / g.norm();  // infinite or NaN without a gradient
      if (away < walk.least) {
        // The nearest so far.
        if (away > 0.5 * walk.least) ++walk.stalls;
        walk.least = away;
        result.positions.col(i) = at.col(i);
        result.gradients.col(i) = whole;
      } else {
        ++walk.stalls;
      }
      if (walk.least <= options.tolerance) {
        result.good[static_cast<std::size_t>(i)] = true;
        continue;
      }
      const Point<3> next = at.col(i) - (f / g.squaredNorm()) * g;
      const bool leashed = (next - start.col(i)).norm() <= options.leash;  // false for NaN
      if (options.steps == 1) {
        result.good[static_cast<std::size_t>(i)] = leashed;
        if (leashed) result.positions.col(i) = next;
        continue;
      }
      if (!leashed || walk.stalls > stalls_allowed) {
        result.good[static_cast<std::size_t>(i)] = walk.least <= floor_reach * options.tolerance;
        continue;
      }
      at.col(i) = next;
      open[kept++] = walk;
    }
    open.resize(kept);
  }
  for (Index i = 0; i < n; ++i)
    if (!result.good[static_cast<std::size_t>(i)]) result.positions.col(i) = start.col(i);
  return result;
}

}  // namespace seesaw
