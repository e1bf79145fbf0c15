#include "core/contour/roots.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace seesaw {
namespace {

// One segment's search. t runs from 0 at the inside end to 1 at the outside end.
struct Search {
  Index segment;
  double low = 0, high = 1;  // f(low) >= 0 > f(high)
  double t = 0.5;
  double length = 0;
  double step = infinity;   // the last step taken, in t
  bool newton = false;      // and whether it was Newton's
  double size = infinity;   // |f| before it
  double least = infinity;  // the smallest |f| met
  int stalled = 0;          // Newton steps after which |f| had not halved
};

// Near a root Newton's steps make |f| much smaller, unless rounding in f has set a floor; more steps there
// would only roll dice. A floor further from the root than this many tolerances is no rounding, but a hard
// field.
constexpr int stalls_allowed = 2;
constexpr double floor_reach = 1e3;
constexpr int most_steps = 120;

}  // namespace

Roots find_roots(Sampler& sampler, const Points<2>& inside, const Points<2>& outside,
                 const Values& inside_values, const Values& outside_values, double tolerance) {
  const Index n = inside.cols();
  Roots roots{inside, Points<2>::Zero(2, n), inside_values};
  std::vector<Search> open(static_cast<std::size_t>(n));
  for (Index i = 0; i < n; ++i) {
    Search& search = open[static_cast<std::size_t>(i)];
    search.segment = i;
    search.length = (outside.col(i) - inside.col(i)).norm();
    const double f0 = inside_values[i], f1 = outside_values[i];
    if (f0 == 0)
      search.t = 0;
    else if (std::isfinite(f1))
      search.t = std::clamp(f0 / (f0 - f1), 1e-6, 1 - 1e-6);
  }
  Points<2> at;
  Values f;
  Points<2> gradient;
  for (int step = 0; step < most_steps && !open.empty(); ++step) {
    at.resize(2, static_cast<Index>(open.size()));
    for (std::size_t k = 0; k < open.size(); ++k) {
      const Index i = open[k].segment;
      at.col(static_cast<Index>(k)) = inside.col(i) + open[k].t * (outside.col(i) - inside.col(i));
    }
    sampler.evaluate(at, f, gradient);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < open.size(); ++k) {
      Search search = open[k];
      const Index column = static_cast<Index>(k), i = search.segment;
      const double value = f[column], size = std::abs(value);
      const auto take = [&] {
        roots.positions.col(i) = at.col(column);
        roots.gradients.col(i) = gradient.col(column);
        roots.values[i] = value;
      };
      if (search.newton && size > 0.5 * search.size) ++search.stalled;
      search.size = size;
      if (size < search.least) {
        search.least = size;
        take();
      }
      (is_inside(value) ? search.low : search.high) = search.t;
      const double slope = gradient.col(column).dot(outside.col(i) - inside.col(i));
      const double newton = slope < 0 ? search.t - value / slope : -1;
      const double newton_step = std::abs(newton - search.t);
      const double width = search.high - search.low;
      if (value == 0 || (slope < 0 && newton_step * search.length <= tolerance) ||
          width * search.length <= 0.5 * tolerance) {
        take();
        continue;
      }
      if (search.stalled >= stalls_allowed && slope < 0 &&
          newton_step * search.length <= floor_reach * tolerance)
        continue;  // with the least |f| met
      const double old = search.t;
      const bool trust = newton > search.low && newton < search.high && newton_step < 0.5 * search.step;
      search.t = trust ? newton : 0.5 * (search.low + search.high);
      search.step = trust ? newton_step : width;
      search.newton = trust;
      if (search.t == old || search.t == search.low || search.t == search.high) {
        take();  // Neighboring doubles: nothing lies between.
        continue;
      }
      open[kept++] = search;
    }
    open.resize(kept);
  }
  return roots;
}

}  // namespace seesaw
