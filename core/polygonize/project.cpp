#include "core/polygonize/project.h"

#include <cmath>

#include "core/base/parallel.h"

namespace seesaw {

namespace {

// Near a zero Newton's steps make |f| much smaller, unless rounding in f has set a floor. A floor further
// from the zero than this many tolerances is no rounding, but a hard field.
constexpr int stalls_allowed = 2;
constexpr double floor_reach = 1e3;

constexpr Index block = 2048;

struct Walk {
  Index point;
  double least = infinity;  // smallest |f| / |g| met
  int stalls = 0;
  bool ended = false;
};

}  // namespace

Projected project(Sampler& sampler, const Points<3>& start, const std::vector<std::uint8_t>& fixed,
                  const ProjectOptions& options) {
  const Index n = start.cols();
  Projected result{start, Points<3>::Zero(3, n), std::vector<char>(static_cast<std::size_t>(n), 0)};
  Points<3> at = start, points, gradients;
  std::vector<Walk> open(static_cast<std::size_t>(n));
  for (Index i = 0; i < n; ++i) open[static_cast<std::size_t>(i)].point = i;
  const auto walk_on = [&](Walk& walk, double f, const Point<3>& gradient) {
    const Index i = walk.point;
    char& good = result.good[static_cast<std::size_t>(i)];
    Point<3> g = gradient;
    if (!fixed.empty())
      for (int d = 0; d < 3; ++d)
        if (fixed[static_cast<std::size_t>(i)] >> d & 1u) g[d] = 0;
    const double away = f == 0 ? 0.0 : std::abs(f) / g.norm();  // infinite or NaN without a gradient
    if (away < walk.least) {
      // The nearest so far.
      if (away > 0.5 * walk.least) ++walk.stalls;
      walk.least = away;
      result.positions.col(i) = at.col(i);
      result.gradients.col(i) = gradient;
    } else {
      ++walk.stalls;
    }
    walk.ended = true;
    if (walk.least <= options.tolerance) {
      good = 1;
      return;
    }
    const Point<3> next = at.col(i) - (f / g.squaredNorm()) * g;
    const bool leashed = (next - start.col(i)).norm() <= options.leash;  // false for NaN
    if (options.steps == 1) {
      good = leashed;
      if (leashed) result.positions.col(i) = next;
    } else if (!leashed || walk.stalls > stalls_allowed) {
      good = walk.least <= floor_reach * options.tolerance;
    } else {
      at.col(i) = next;
      walk.ended = false;
    }
  };
  for (int step = 0; step < options.steps && !open.empty(); ++step) {
    points.resize(3, static_cast<Index>(open.size()));
    for (std::size_t k = 0; k < open.size(); ++k) points.col(static_cast<Index>(k)) = at.col(open[k].point);
    const Values values = sampler.values(points, gradients);
    parallel_blocks(points.cols(), block, [&](Index begin, Index end) {
      for (Index k = begin; k < end; ++k)
        walk_on(open[static_cast<std::size_t>(k)], values[k], gradients.col(k));
    });
    std::erase_if(open, [](const Walk& walk) { return walk.ended; });
  }
  for (Index i = 0; i < n; ++i)
    if (!result.good[static_cast<std::size_t>(i)]) result.positions.col(i) = start.col(i);
  return result;
}

}  // namespace seesaw
