#include "core/polygonize/edge_roots.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace seesaw {

namespace {

// One edge's search. t runs from 0 at the inside end to 1 at the outside end.
struct Search {
  Index edge;
  double length;
  double low = 0, high = 1;  // f(low) >= 0 > f(high)
  double f_low, f_high;      // as the Illinois rule has them: an end that stayed put has its value halved
  double t = 0.5;
  int side = 0;      // which end moved last: -1 low, +1 high
  double width = 1;  // of the bracket, when it was last found to shrink
  int slow = 0;      // steps since

  double chord() const {
    if (!std::isfinite(f_high)) return 0.5 * (low + high);
    const double at = low + (high - low) * (f_low / (f_low - f_high));
    return at > low && at < high ? at : 0.5 * (low + high);
  }
};

constexpr int slow_steps_allowed = 3;
constexpr int most_steps = 120;

}  // namespace

EdgeRoots find_edge_roots(Sampler& sampler, const Segments& segments, double tolerance) {
  const Index n = segments.inside.cols();
  EdgeRoots roots{segments.inside, Values::Zero(n)};
  std::vector<Search> open;
  open.reserve(static_cast<std::size_t>(n));
  for (Index i = 0; i < n; ++i) {
    if (segments.inside_values[i] == 0) continue;  // the inside end is the root
    Search search;
    search.edge = i;
    search.length = (segments.outside.col(i) - segments.inside.col(i)).norm();
    search.f_low = segments.inside_values[i];
    search.f_high = segments.outside_values[i];
    search.t = search.chord();
    open.push_back(search);
  }
  const auto position = [&](const Search& s) -> Point<3> {
    return segments.inside.col(s.edge) + s.t * (segments.outside.col(s.edge) - segments.inside.col(s.edge));
  };
  for (int step = 0; step < most_steps && !open.empty(); ++step) {
    Points<3> points(3, static_cast<Index>(open.size()));
    for (std::size_t k = 0; k < open.size(); ++k) points.col(static_cast<Index>(k)) = position(open[k]);
    const Values values = sampler.values(points);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < open.size(); ++k) {
      Search s = open[k];
      const double value = values[static_cast<Index>(k)], before = s.t;
      double left = 0;
      if (value != 0) {
        if (is_inside(value)) {
          s.low = s.t;
          s.f_low = value;
          if (s.side < 0) s.f_high *= 0.5;
          s.side = -1;
        } else {
          s.high = s.t;
          s.f_high = value;
          if (s.side > 0) s.f_low *= 0.5;
          s.side = 1;
        }
        if (s.high - s.low <= 0.5 * s.width) {
          s.width = s.high - s.low;
          s.slow = 0;
        } else {
          ++s.slow;
        }
        const bool halve = s.slow > slow_steps_allowed;
        s.t = halve ? 0.5 * (s.low + s.high) : s.chord();
        // A chord's step that is small says that the zero is near: the chords converge faster than by halves.
        left = s.length * (halve ? s.high - s.low : std::abs(s.t - before));
        if (halve) {
          s.width = s.high - s.low;
          s.slow = 0;
        }
      }
      const bool exhausted = s.t <= s.low || s.t >= s.high;  // neighbors among doubles
      if (left <= tolerance || exhausted) {
        if (exhausted) s.t = std::abs(s.f_low) <= std::abs(s.f_high) ? s.low : s.high;
        roots.positions.col(s.edge) = position(s);
        roots.uncertainty[s.edge] = exhausted ? 0 : left;
      } else {
        open[kept++] = s;
      }
    }
    open.resize(kept);
  }
  for (const Search& s : open) {
    roots.positions.col(s.edge) = position(s);
    roots.uncertainty[s.edge] = (s.high - s.low) * s.length;
  }
  return roots;
}

}  // namespace seesaw
