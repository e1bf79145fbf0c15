// Turk & O'Brien 2002, Figure 4: a cage of exterior constraints closes whatever curve passes through the
// boundary constraints within.
#include <Eigen/Eigenvalues>
#include <cmath>

#include "figures/signs.h"

namespace seesaw {

namespace {

// Longest width over shortest, each the curve's extent along a direction.
double axis_ratio(const Polyline& curve) {
  double longest = 0, shortest = infinity;
  for (int k = 0; k < 720; ++k) {
    const Point<2> u(std::cos(M_PI * k / 720), std::sin(M_PI * k / 720));
    const auto along = (u.transpose() * curve.vertices).eval();
    const double width = along.maxCoeff() - along.minCoeff();
    longest = std::max(longest, width);
    shortest = std::min(shortest, width);
  }
  return longest / shortest;
}

// How far the curve strays from the ellipse with its own center and second moments, as a fraction of its
// radius: in coordinates in which that ellipse is the unit circle, the largest | |x| - 1 |.
double stray_from_ellipse(const Polyline& curve) {
  // Moments of the region by triangles fanned from the first vertex.
  const Index n = curve.vertices.cols();
  double area = 0;
  Point<2> first = Point<2>::Zero();
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
  const Point<2> origin = curve.vertices.col(0);
  for (Index i = 1; i + 1 < n; ++i) {
    const Point<2> a = curve.vertices.col(i) - origin, b = curve.vertices.col(i + 1) - origin;
    const double t = 0.5 * (a.x() * b.y() - a.y() * b.x());
    area += t;
    first += t * (a + b) / 3;
    second += t / 12 * ((a + b) * (a + b).transpose() + a * a.transpose() + b * b.transpose());
  }
  const Point<2> center = first / area;
  const Eigen::Matrix2d spread = second / area - center * center.transpose();  // r^2 / 4 for an ellipse
  const Eigen::Matrix2d to_circle =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(4 * spread).operatorInverseSqrt();
  const Points<2> unit = to_circle * (curve.vertices.colwise() - (origin + center));
  return (unit.colwise().norm().array() - 1).abs().maxCoeff();
}

// The number of inflections: how often the polyline stops turning one way and turns the other.
int inflections(const Polyline& curve) {
  const Index n = curve.vertices.cols();
  int changes = 0;
  double last = 0;
  for (Index i = 0; i <= n; ++i) {
    const Point<2> a = curve.vertices.col(i % n), b = curve.vertices.col((i + 1) % n),
                   c = curve.vertices.col((i + 2) % n);
    const Point<2> u = b - a, v = c - b;
    const double turn = std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v));
    if (std::abs(turn) < 1e-5) continue;
    if (last * turn < 0) ++changes;
    last = turn;
  }
  return changes;
}

}  // namespace

Figure turk2002_fig04(const FigureContext& context) {
  Figure figure{
      .id = "turk2002-fig04",
      .paper = "Turk & O\u2019Brien 2002, Figure 4",
      .title = "Curves inside a cage of exterior constraints",
      .shows =
          "Curves defined using surrounding exterior constraints. Just two zero-valued constraints yield "
          "an ellipse-like curve (on the left). More constraints create a more complex curve (at right)."};
  const char* const names[] = {"left", "right"};
  const char* const titles[] = {"two boundary constraints in a cage of eight",
                                "eight boundary constraints in the same cage"};
  double ratio = 0;
  for (int side = 0; side < 2; ++side) {
    const std::string name = names[side];
    const ScenePointer scene = fit_scene_file(context, "turk2002-fig04-" + name);
    Panel panel = scene_panel(scene, name, titles[side]);
    const auto& report = scene->fitted.report;
    figure.checks.push_back(residual_check(name, report));
    figure.checks.push_back(equal(name + ": exterior constraints", static_cast<double>(report.exterior), 8));
    figure.checks.push_back(equal(name + ": curves", static_cast<double>(scene->curve.components), 1));
    figure.checks.push_back(equal(name + ": closed curves", static_cast<double>(scene->curve.closed), 1));
    figure.checks.push_back(equal(name + ": boundary constraints on the curve",
                                  static_cast<double>(scene->curve.seeds_on_curve),
                                  static_cast<double>(report.boundary)));
    const Polyline& curve = scene->curve.polylines.front();
    panel.facts["inflections"] = inflections(curve);
    if (side == 0) {
      ratio = axis_ratio(curve);
      const double stray = stray_from_ellipse(curve);
      panel.facts["axis_ratio"] = ratio;
      panel.facts["stray_from_ellipse"] = stray;
      figure.checks.push_back(equal("left: boundary constraints", static_cast<double>(report.boundary), 2));
      figure.checks.push_back(at_most("left: stray from the ellipse of the same moments", stray, 0.05));
      figure.checks.push_back(equal("left: inflections", inflections(curve), 0));
    } else {
      figure.checks.push_back(at_least("right: inflections", inflections(curve), 2));
    }
    add_signs(measure_signs(*scene), panel, figure);
    figure.panels.push_back(std::move(panel));
  }
  figure.caption =
      "Minus signs: exterior constraints, f = \u22121, on a circle. Nothing positive is asked for anywhere: "
      "the function of "
      "least bending rises through zero at the boundary constraints by itself. Left, the ratio of the "
      "ellipse-like "
      "curve\u2019s axes is " +
      in_words(ratio, 3) + ".";
  return figure;
}

}  // namespace seesaw
