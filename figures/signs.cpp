#include "figures/signs.h"

#include <cmath>

namespace seesaw {

namespace {

constexpr int directions = 360;
constexpr double searched = 1e8;  // sizes
constexpr double infinite = infinity;

Point<2> direction(int k) {
  return {std::cos(2 * M_PI * k / directions), std::sin(2 * M_PI * k / directions)};
}

double sign_returns_at(const Interpolant<2>& f, const Point<2>& center, double size) {
  constexpr int steps = 2000;
  double nearest = searched;
  std::vector<double> distances;
  for (int i = 0; i < steps; ++i) distances.push_back(size * std::pow(searched, (i + 1.0) / steps));
  Points<2> points(2, steps);
  for (int k = 0; k < directions; ++k) {
    for (int i = 0; i < steps; ++i)
      points.col(i) = center + distances[static_cast<std::size_t>(i)] * direction(k);
    const Values values = f.values(points);
    bool outside = false;  // the first negative value ends the inside
    for (int i = 0; i < steps; ++i) {
      outside = outside || values[i] < 0;
      if (!outside || values[i] <= 0) continue;
      nearest = std::min(nearest, distances[static_cast<std::size_t>(i)] / size);
      break;
    }
  }
  return nearest;
}

}  // namespace

Signs measure_signs(const FittedScene& scene) {
  const Box<2> box = bounding_box(scene.curve.polylines.front());
  const Point<2> center = box.center();
  const auto& f = scene.function();
  Signs signs{.size = box.sizes().maxCoeff(), .smallest_inside = infinite, .largest_outside = -infinite};
  constexpr int n = 100;
  for (int i = 0; i < n * n; ++i) {
    const Point<2> p = box.min() + box.sizes().cwiseProduct(Point<2>((i % n + 0.5) / n, (i / n + 0.5) / n));
    if (winding_number(scene.curve.polylines, p) == 1)
      signs.smallest_inside = std::min(signs.smallest_inside, f.value(p));
  }
  for (int ring = 1; ring <= 200; ++ring)
    for (int k = 0; k < directions; ++k) {
      const Point<2> p = center + (5 * signs.size * ring / 200) * direction(k);
      if (winding_number(scene.curve.polylines, p) == 0)
        signs.largest_outside = std::max(signs.largest_outside, f.value(p));
    }
  signs.returns_at_sizes = sign_returns_at(f, center, signs.size);
  return signs;
}

void add_signs(const Signs& signs, Panel& panel, Figure& figure) {
  panel.facts["shape_size"] = signs.size;
  panel.facts["smallest_value_inside"] = signs.smallest_inside;
  panel.facts["largest_value_outside_to_5_sizes"] = signs.largest_outside;
  panel.facts["sign_searched_to_sizes"] = searched;
  if (signs.returns_at_sizes < searched) panel.facts["sign_returns_at_sizes"] = signs.returns_at_sizes;
  figure.checks.push_back(at_least(panel.name + ": smallest f inside", signs.smallest_inside, 0));
  figure.checks.push_back(at_most(panel.name + ": largest f outside, to 5 sizes", signs.largest_outside, 0));
  figure.checks.push_back(
      at_least(panel.name + ": sizes at which the sign returns", signs.returns_at_sizes, 5));
}

}  // namespace seesaw
