// Eq. 3 of Turk & O'Brien 2002 two ways: from the weights, E = 8 pi w'h, and by quadrature of the Hessian
// over growing domains. They meet.
#include <cmath>

#include "core/image/chart.h"
#include "figures/scene_panel.h"

namespace seesaw {

namespace {

// The integral of f_xx^2 + 2 f_xy^2 + f_yy^2 over the square of half side `reach` about `center`, by Gauss's
// rule of 3 x 3 points on cells that halve toward the centers of the kernels: there the integrand has a peak
// of log^2 r.
class Quadrature {
 public:
  explicit Quadrature(const Interpolant<2>& f) : f_(f) {}

  /// `finest`: cells are not split further; what they miss is about finest^2.
  double over(const Point<2>& center, double reach, double finest) {
    cells_.clear();
    constexpr int n = 16;
    const double side = 2 * reach / n;
    for (int i = 0; i < n * n; ++i)
      split(center + Point<2>((i % n + 0.5) * side - reach, (i / n + 0.5) * side - reach), side, finest);
    const double nodes[] = {-std::sqrt(0.15), 0, std::sqrt(0.15)}, shares[] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
    Points<2> points(2, 9 * static_cast<Index>(cells_.size()));
    Index k = 0;
    for (const Cell& cell : cells_)
      for (const double x : nodes)
        for (const double y : nodes) points.col(k++) = cell.center + cell.side * Point<2>(x, y);
    Hessians<2> hessians(4, points.cols());
    f_.evaluate_hessians(points, hessians);
    double sum = 0;
    k = 0;
    for (const Cell& cell : cells_)
      for (const double x : shares)
        for (const double y : shares) sum += x * y * cell.side * cell.side * hessians.col(k++).squaredNorm();
    return sum;
  }

 private:
  struct Cell {
    Point<2> center;
    double side;
  };

  void split(const Point<2>& center, double side, double smallest) {
    const double distance = std::sqrt((f_.centers().colwise() - center).colwise().squaredNorm().minCoeff());
    if (side <= smallest || side < 0.5 * std::max(distance - 0.71 * side, 0.0)) {
      cells_.push_back({center, side});
      return;
    }
    for (const double x : {-0.25, 0.25})
      for (const double y : {-0.25, 0.25}) split(center + side * Point<2>(x, y), side / 2, smallest);
  }

  const Interpolant<2>& f_;
  std::vector<Cell> cells_;
};

}  // namespace

Figure energy_figure(const FigureContext& context) {
  Figure figure{
      .id = "energy",
      .paper = "Companion to Turk & O\u2019Brien 2002, equation 3",
      .title = "Bending energy from the weights and by quadrature",
      .shows =
          "The thin-plate solution satisfies all of the constraints and has the smallest possible value of "
          "E. The weights tell that value; integrating the squared second derivatives over larger and "
          "larger squares comes up to it."};
  const ScenePointer scene = fit_scene_file(context, "turk2002-fig01-left");
  const auto& f = scene->function();
  const double exact = scene->fitted.report.energy;
  const Box<2> shape = bounding_box(scene->curve.polylines[0]);
  const double size = shape.sizes().maxCoeff();
  std::vector<double> sides, integrals, shortfalls;
  Quadrature quadrature(f);
  for (double reach = 0.25; reach < 600; reach *= std::sqrt(2)) {
    sides.push_back(2 * reach);
    integrals.push_back(quadrature.over(shape.center(), reach * size, 1e-4 * size));
    shortfalls.push_back(1 - integrals.back() / exact);
  }

  Panel growth{.name = "growth", .title = "the integral over a square of growing side"};
  growth.width = growth.height = 330;
  const Chart chart{.x = {.label = "side of the square / size of the shape", .logarithmic = true},
                    .y = {.label = "bending energy", .low = 0.0},
                    .series = {{.name = "quadrature of equation 3",
                                .x = sides,
                                .y = integrals,
                                .marker = Marker::circle,
                                .marker_size = 5}},
                    .horizontal = {{.value = exact, .label = "8\u03c0 w\u00b7h = " + in_words(exact, 5)}},
                    .legend = Legend::none};
  growth.draw = [chart](Canvas& canvas, const Rect& region) { draw_chart(canvas, region, chart); };
  growth.facts = fit_facts(scene->fitted.report);
  growth.facts["side_over_size"] = sides;
  growth.facts["integral"] = integrals;

  Panel missing{.name = "shortfall", .title = "what is still missing"};
  missing.width = missing.height = 330;
  // Beyond the shape the integrand falls as r^-4, so the rest of the plane holds a part that falls as r^-2.
  std::vector<double> law;
  for (const double side : sides) law.push_back(shortfalls[9] * std::pow(sides[9] / side, 2));
  const Chart log_chart{
      .x = {.label = "side of the square / size of the shape", .logarithmic = true},
      .y = {.label = "missing part of the energy", .logarithmic = true, .low = 1e-7, .high = 1.0},
      .series = {{.name = "1 \u2212 quadrature / 8\u03c0 w\u00b7h",
                  .x = sides,
                  .y = shortfalls,
                  .marker = Marker::circle,
                  .marker_size = 5},
                 {.name = "side\u207b\u00b2",
                  .x = sides,
                  .y = law,
                  .color = theme::soft_ink,
                  .line_width = 1,
                  .dash = {4, 3}}},
      .legend = Legend::top_right};
  missing.draw = [log_chart](Canvas& canvas, const Rect& region) { draw_chart(canvas, region, log_chart); };
  missing.facts["shortfall"] = shortfalls;

  bool rises = true;
  for (std::size_t i = 1; i < integrals.size(); ++i) rises = rises && integrals[i] > integrals[i - 1];
  const double remaining = std::abs(shortfalls.back());
  const double slope = std::log(shortfalls[13] / shortfalls[7]) / std::log(sides[13] / sides[7]);
  missing.facts["slope"] = slope;
  figure.checks.push_back(residual_check("scene", scene->fitted.report));
  figure.checks.push_back(equal("the integral grows with the square", rises, 1));
  figure.checks.push_back(at_most("missing part over the largest square", remaining, 2e-6));
  figure.checks.push_back(at_most("slope of the missing part, from \u22122", std::abs(slope + 2), 0.1));
  figure.panels = {std::move(growth), std::move(missing)};
  figure.caption =
      "The function of Figure 1, left. Dots: equation 3, f_xx\u00b2 + 2 f_xy\u00b2 + f_yy\u00b2 integrated "
      "over a square about the "
      "shape. Line: the same energy from the weights, 8\u03c0 w\u00b7h, over the whole plane. Over " +
      in_words(sides.back(), 3) + " times the size of the shape they differ by " + in_words(remaining, 1) +
      " of the whole.";
  return figure;
}

}  // namespace seesaw
