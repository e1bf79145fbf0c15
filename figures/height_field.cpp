// T&O 2002, section 8.1: thin-plate reconstruction makes height fields, and a height field cannot close.
#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/image/chart.h"
#include "core/image/height_plot.h"
#include "figures/scene_panel.h"

namespace seesaw {

namespace {

// Heights of a gentle landscape at scattered places of the unit square.
struct Scattered {
  Points<2> places;
  Values heights;
};
Scattered scattered_heights() {
  Random random(3);
  Scattered data{Points<2>(2, 0), {}};
  // Places that keep their distance, by throwing darts.
  while (data.places.cols() < 14) {
    const Point<2> dart(random.uniform(0.06, 0.94), random.uniform(0.06, 0.94));
    if (data.places.cols() > 0 && (data.places.colwise() - dart).colwise().norm().minCoeff() < 0.2) continue;
    data.places.conservativeResize(2, data.places.cols() + 1);
    data.places.col(data.places.cols() - 1) = dart;
  }
  data.heights.resize(data.places.cols());
  for (Index i = 0; i < data.heights.size(); ++i) {
    const double x = data.places(0, i), y = data.places(1, i);
    data.heights[i] = 0.28 + 0.22 * std::sin(5 * x + 0.5) * std::cos(4 * y) + 0.06 * random.normal();
  }
  return data;
}

Panel plate_panel(Figure& figure) {
  const Scattered data = scattered_heights();
  const Fit<2> fitted = fit_values<2>(data.places, data.heights);
  HeightPlot plot;
  constexpr Index n = 81;
  Points<2> points(2, n * n);
  for (Index k = 0; k < n * n; ++k)
    points.col(k) = Point<2>(static_cast<double>(k % n), static_cast<double>(k / n)) / (n - 1.0);
  const Values values = fitted.function.values(points);
  plot.field.heights = Eigen::Map<const Eigen::MatrixXd>(values.data(), n, n);
  plot.field.ground = Box<2>(Point<2>(0, 0), Point<2>(1, 1));
  plot.mesh_every = 8;
  plot.zero_plane = false;
  for (Index i = 0; i < data.heights.size(); ++i)
    plot.poles.push_back({.top = {data.places(0, i), data.places(1, i), data.heights[i]}, .size = 7});
  Panel panel{.name = "plate", .title = "a thin plate through scattered heights"};
  panel.width = 400;
  panel.height = 330;
  panel.draw = [plot](Canvas& canvas, const Rect& region) { draw_height_plot(canvas, region, plot); };
  panel.facts = fit_facts(fitted.report);
  figure.checks.push_back(residual_check("plate", fitted.report));
  return panel;
}

// A height field over a line: r^3 with centers on a line is the natural cubic spline, the thin plate of one
// dimension.
Fit<2> spline_through(const Points<2>& points) {
  Points<2> feet = points;
  feet.row(1).setZero();
  return fit_values<2>(feet, points.row(1).transpose().eval(), {.kernel = Kernel::cubic});
}

Panel spline_panel(Figure& figure, const FittedScene& scene) {
  const Points<2> points = boundary_points(scene.document);
  const Fit<2> spline = spline_through(points);
  Series curve{.name = "height field", .color = theme::curve, .line_width = 2.2};
  for (int i = 0; i <= 400; ++i) {
    curve.x.push_back(-1.7 + 3.4 * i / 400);
    curve.y.push_back(spline.function.value({curve.x.back(), 0}));
  }
  Panel panel{.name = "spline", .title = "as heights y(x): one y for each x"};
  panel.width = panel.height = 330;
  panel.draw = [curve, points](Canvas& canvas, const Rect& region) {
    const Chart chart{.x = {.label = "x", .low = -1.7, .high = 1.7},
                      .y = {.label = "y", .low = -1.7, .high = 1.7},
                      .series = {curve},
                      .legend = Legend::none};
    const ChartFrame frame = draw_chart(canvas, region, chart);
    for (Index i = 0; i < points.cols(); ++i)
      draw_symbol(canvas, Symbol::circle, frame.pixel_from_data(points.col(i)), 9);
  };
  panel.facts = fit_facts(spline.report);
  const double swing =
      *std::max_element(curve.y.begin(), curve.y.end()) - *std::min_element(curve.y.begin(), curve.y.end());
  panel.facts["swing"] = swing;

  // A ninth point of the circle straight below the first: two heights at one place.
  Points<2> nine(2, points.cols() + 1);
  nine << points, Point<2>(points(0, 0), -points(1, 0));
  Facts culprits = Facts::array();
  try {
    spline_through(nine);
  } catch (const ConstraintError& error) {
    for (const Index i : error.culprits()) culprits.push_back(i);
  }
  panel.facts["culprits_of_two_heights_at_one_place"] = culprits;
  figure.checks.push_back(residual_check("spline", spline.report));
  figure.checks.push_back(at_least("spline: its swing over the circle\u2019s height", swing / 2, 1.05));
  figure.checks.push_back(equal("spline: two heights at one place are refused, naming both",
                                culprits == Facts::array({0, points.cols()}), 1));
  return panel;
}

}  // namespace

Figure height_field(const FigureContext& context) {
  Figure figure{
      .id = "height-field",
      .paper = "Companion to Turk & O\u2019Brien 2002, section 8.1",
      .title = "A thin-plate height field, and why it cannot close",
      .shows =
          "The use of a height field is a barrier towards creating closed surfaces and surfaces of "
          "arbitrary topology. Both methods create a function based on variational methods, but they "
          "differ in the dimension of the scalar function that they create."};
  const ScenePointer scene = fit_scene_file(context, "height-field");
  figure.panels.push_back(plate_panel(figure));
  figure.panels.push_back(spline_panel(figure, *scene));
  Panel closed = scene_panel(scene, "implicit", "as zeros of f(x, y): closed");
  closed.width = closed.height = 330;
  figure.checks.push_back(residual_check("implicit", scene->fitted.report));
  figure.checks.push_back(equal("implicit: curves", static_cast<double>(scene->curve.components), 1));
  figure.checks.push_back(equal("implicit: closed curves", static_cast<double>(scene->curve.closed), 1));
  figure.checks.push_back(
      equal("implicit: points on the curve", static_cast<double>(scene->curve.seeds_on_curve), 8));
  figure.panels.push_back(std::move(closed));
  figure.caption =
      "Left: the classic use of the thin plate, one height over each point of the plane. Middle: eight "
      "points of a circle as "
      "heights over a line; the smoothest height field through them zigzags, and it cannot pass two points "
      "at one x at all. "
      "Right: the same points as zeros of a function of one dimension more, with one interior constraint: "
      "the curve closes.";
  return figure;
}

}  // namespace seesaw
