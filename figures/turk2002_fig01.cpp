// Turk & O'Brien 2002, Figure 1: four zeros and one interior constraint make a curve; three more zeros refine
// it.
#include <cmath>

#include "figures/scene_panel.h"

namespace seesaw {

namespace {

constexpr int directions = 360;

Point<2> direction(int k) {
  return {std::cos(2 * M_PI * k / directions), std::sin(2 * M_PI * k / directions)};
}

// The least distance from `center`, in units of `size`, at which f turns positive again outside the curve,
// looking along all directions out to 10^8 sizes; infinite if it never does.
double sign_returns_at(const Interpolant<2>& f, const Point<2>& center, double size) {
  constexpr int steps = 2000;
  double nearest = std::numeric_limits<double>::infinity();
  Points<2> points(2, steps);
  for (int k = 0; k < directions; ++k) {
    std::vector<double> distances;
    for (int i = 0; i < steps; ++i) distances.push_back(size * std::pow(1e8, (i + 1.0) / steps));
    for (int i = 0; i < steps; ++i)
      points.col(i) = center + distances[static_cast<std::size_t>(i)] * direction(k);
    const Values values = f.values(points);
    bool outside = false;  // the first negative value ends the inside
    for (int i = 0; i < steps; ++i) {
      outside = outside || values[i] < 0;
      if (outside && values[i] > 0) {
        nearest = std::min(nearest, distances[static_cast<std::size_t>(i)] / size);
        break;
      }
    }
  }
  return nearest;
}

// The largest f outside the curve within five times the shape's size: negative, says the paper.
double largest_outside(const FittedScene& scene, const Point<2>& center, double size) {
  double largest = -std::numeric_limits<double>::infinity();
  for (int ring = 1; ring <= 200; ++ring)
    for (int k = 0; k < directions; ++k) {
      const Point<2> p = center + (5.0 * size * ring / 200) * direction(k);
      if (winding_number(scene.curve.polylines, p) == 0)
        largest = std::max(largest, scene.function().value(p));
    }
  return largest;
}

double smallest_inside(const FittedScene& scene, const Box<2>& box) {
  double smallest = std::numeric_limits<double>::infinity();
  constexpr int n = 100;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Point<2> p = box.min() + box.sizes().cwiseProduct(Point<2>((i + 0.5) / n, (j + 0.5) / n));
      if (winding_number(scene.curve.polylines, p) == 1)
        smallest = std::min(smallest, scene.function().value(p));
    }
  return smallest;
}

}  // namespace

Figure turk2002_fig01(const FigureContext& context) {
  Figure figure{
      .id = "turk2002-fig01",
      .paper = "Turk & O\u2019Brien 2002, Figure 1",
      .title = "Curves from boundary constraints and one interior constraint",
      .shows =
          "The curve on the left is defined by four zero-valued and one positive constraint. This curve "
          "is refined by adding three new zero-valued constraints, shown in red at right."};
  const ScenePointer scenes[] = {fit_scene_file(context, "turk2002-fig01-left"),
                                 fit_scene_file(context, "turk2002-fig01-right")};
  const char* const names[] = {"left", "right"};
  std::string far_away;
  for (int side = 0; side < 2; ++side) {
    const FittedScene& scene = *scenes[side];
    const std::string name = names[side];
    PictureOptions options;
    if (side == 1) options.ghosts = scenes[0]->curve.polylines;
    Panel panel = scene_panel(
        scenes[side], name,
        side == 0 ? "four boundary constraints, one interior" : "three new boundary constraints", options);
    const Box<2> shape = bounding_box(scene.curve.polylines.front());
    const Point<2> center = shape.center();
    const double size = shape.sizes().maxCoeff();
    const double returns = sign_returns_at(scene.function(), center, size);
    const double outside = largest_outside(scene, center, size), inside = smallest_inside(scene, shape);
    panel.facts["shape_size"] = size;
    panel.facts["largest_value_outside_to_5_sizes"] = outside;
    panel.facts["smallest_value_inside"] = inside;
    if (std::isfinite(returns)) panel.facts["sign_returns_at_sizes"] = returns;
    figure.checks.push_back(residual_check(name, scene.fitted.report));
    figure.checks.push_back(equal(name + ": closed curves", static_cast<double>(scene.curve.closed), 1));
    figure.checks.push_back(equal(name + ": curves", static_cast<double>(scene.curve.components), 1));
    figure.checks.push_back(equal(name + ": boundary constraints on the curve",
                                  static_cast<double>(scene.curve.seeds_on_curve), side == 0 ? 4 : 7));
    figure.checks.push_back(at_most(name + ": largest f outside, to 5 sizes", outside, 0));
    figure.checks.push_back(at_least(name + ": smallest f inside", inside, 0));
    figure.checks.push_back(
        at_most(name + ": |f(plus) - 1|", std::abs(scene.function().value({0, 0}) - 1), 1e-12));
    figure.panels.push_back(std::move(panel));
    far_away += (side ? " and " : "") +
                (std::isfinite(returns) ? in_words(returns, 3) : std::string("more than 10\u2078"));
  }
  // The right side only adds to the left: its first five constraints are the same.
  double moved = 0;
  for (std::size_t i = 0; i < 5; ++i)
    moved +=
        (scenes[0]->document.constraints[i].constraint.at - scenes[1]->document.constraints[i].constraint.at)
            .norm();
  figure.checks.push_back(equal("right: how far the first five constraints moved", moved, 0));
  double change = 0;
  for (Index i = 0; i < scenes[0]->curve.polylines[0].vertices.cols(); ++i)
    change = std::max(change,
                      distance(scenes[1]->curve.polylines[0], scenes[0]->curve.polylines[0].vertices.col(i)));
  figure.panels[1].facts["greatest_distance_from_left_curve"] = change;
  figure.checks.push_back(at_least("right: greatest distance between the two curves", change, 0.1));
  figure.caption =
      "Circles: boundary constraints, f = 0. Plus sign: interior constraint, f = 1. The thin-plate function "
      "(r\u00b2 log r) "
      "is positive inside (orange) and negative outside (blue); its zero set is the curve. New constraints "
      "are red, the "
      "old curve dashed. Far away the linear term wins over the logarithm: the sign returns at " +
      far_away + " times the size of the shape (left and right).";
  return figure;
}

}  // namespace seesaw
