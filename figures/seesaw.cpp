// T&O 2002, section 4.1: "Each boundary constraint acts much like a see-saw. If we pull the surface up on one
// side of a boundary constraint (using an interior constraint), then the other side tends to move down."
#include <cmath>

#include "core/image/chart.h"
#include "core/image/height_plot.h"
#include "core/scene/document_json.h"
#include "figures/scene_panel.h"

namespace seesaw {

namespace {

// The scene with every interior value set to `value`.
ScenePointer pulled_to(const Document<2>& scene, double value) {
  Document<2> document = scene;
  for (auto& each : document.constraints)
    if (each.constraint.kind == ConstraintKind::interior) each.constraint.value = value;
  return fit_scene(std::move(document));
}

HeightPlot plate_of(const FittedScene& scene) {
  HeightPlot plot;
  constexpr Index n = 97;
  Points<2> points(2, n * n);
  const Box<2> ground = scene.view;
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i)
      points.col(j * n + i) =
          ground.min() +
          ground.sizes().cwiseProduct(Point<2>(static_cast<double>(i), static_cast<double>(j)) / (n - 1.0));
  const Values values = scene.function().values(points);
  plot.field.heights = Eigen::Map<const Eigen::MatrixXd>(values.data(), n, n);
  plot.field.ground = ground;
  plot.mesh_every = 8;
  for (const Polyline& curve : scene.curve.polylines) {
    Points<2> ring = curve.vertices;
    if (curve.closed) {
      ring.conservativeResize(2, ring.cols() + 1);
      ring.col(ring.cols() - 1) = curve.vertices.col(0);
    }
    plot.zero_curves.push_back(ring);
  }
  for (const auto& each : scene.document.constraints) {
    const auto& c = each.constraint;
    plot.poles.push_back({.top = {c.at.x(), c.at.y(), c.value},
                          .head = c.kind == ConstraintKind::interior ? Symbol::plus : Symbol::circle,
                          .color = each.highlight ? theme::moved : theme::constraint});
  }
  return plot;
}

}  // namespace

Figure seesaw_figure(const FigureContext& context) {
  Figure figure{
      .id = "seesaw",
      .paper = "Companion to Turk & O\u2019Brien 2002, section 4.1",
      .title = "Each boundary constraint acts much like a see-saw",
      .shows =
          "If we pull the surface up on one side of a boundary constraint (using an interior constraint), "
          "then the other side tends to move down."};
  const Document<2> document = read_document<2>(context.scenes / "seesaw.json");
  const std::vector<double> pulls = {0.5, 1, 1.5, 2};
  std::vector<ScenePointer> scenes;
  for (const double pull : pulls) scenes.push_back(pulled_to(document, pull));
  const FittedScene& shown = *scenes[1];

  // The profile: from the interior constraint through the highlighted boundary constraint and as far beyond.
  Point<2> lever = Point<2>::Zero(), pivot = Point<2>::Zero();
  for (const auto& each : document.constraints) {
    if (each.constraint.kind == ConstraintKind::interior) lever = each.constraint.at;
    if (each.highlight) pivot = each.constraint.at;
  }
  const Point<2> outward = (pivot - lever).normalized();
  const double arm = (pivot - lever).norm();

  Panel plate{.name = "plate", .title = "f as a plate, its zero plane, and poles at the constraints"};
  plate.width = 470;
  plate.height = 360;
  const HeightPlot plot = plate_of(shown);
  plate.draw = [plot, pivot, outward, arm, f = scenes[1]](Canvas& canvas, const Rect& region) {
    const HeightProjection projection = draw_height_plot(canvas, region, plot);
    // The line of the profile, lying on the plate.
    constexpr Index n = 120;
    Points<2> line(2, n);
    for (Index i = 0; i < n; ++i) {
      const Point<2> p = pivot + (static_cast<double>(i) / (n - 1) * 2 - 1) * arm * outward;
      line.col(i) = projection.pixel_from_scene({p.x(), p.y(), f->function().value(p)});
    }
    canvas.polyline(line, {.color = theme::moved, .width = 1.6});
    draw_symbol(canvas, Symbol::circle, projection.pixel_from_scene({pivot.x(), pivot.y(), 0}), 8,
                theme::moved);
  };
  plate.facts = fit_facts(shown.fitted.report);
  add_curve_facts(plate.facts, shown.curve);

  Panel profiles{.name = "profiles",
                 .title = "profiles along the red line as the interior value is pulled up"};
  profiles.width = 430;
  profiles.height = 360;
  Chart chart{.x = {.label = "distance from the boundary constraint, outward"}, .y = {.label = "f"}};
  constexpr int samples = 161;
  double highest_pivot = 0;
  std::vector<double> inner, outer;  // half an arm to each side
  for (std::size_t k = 0; k < pulls.size(); ++k) {
    const auto& f = scenes[k]->function();
    Series series{.name = "interior value " + in_words(pulls[k], 2)};
    for (int i = 0; i < samples; ++i) {
      series.x.push_back((2.0 * i / (samples - 1) - 1) * arm);
      series.y.push_back(f.value(pivot + series.x.back() * outward));
    }
    chart.series.push_back(std::move(series));
    highest_pivot = std::max(highest_pivot, std::abs(f.value(pivot)));
    inner.push_back(f.value(pivot - 0.5 * arm * outward));
    outer.push_back(f.value(pivot + 0.5 * arm * outward));
    figure.checks.push_back(
        residual_check("interior value " + in_words(pulls[k], 2), scenes[k]->fitted.report));
  }
  chart.horizontal.push_back({.value = 0});
  chart.legend = Legend::top_right;
  profiles.draw = [chart](Canvas& canvas, const Rect& region) {
    const ChartFrame frame = draw_chart(canvas, region, chart);
    draw_symbol(canvas, Symbol::circle, frame.pixel_from_data({0, 0}), 10, theme::moved);
  };
  profiles.facts["interior_values"] = pulls;
  profiles.facts["half_an_arm_inside"] = inner;
  profiles.facts["half_an_arm_outside"] = outer;
  profiles.facts["largest_value_at_pivot"] = highest_pivot;
  double least_rise = 1e300, least_fall = 1e300;
  for (std::size_t k = 1; k < pulls.size(); ++k) {
    least_rise = std::min(least_rise, inner[k] - inner[k - 1]);
    least_fall = std::min(least_fall, outer[k - 1] - outer[k]);
  }
  figure.checks.push_back(at_most("all pass through zero at the constraint: |f|", highest_pivot, 1e-12));
  figure.checks.push_back(at_least("each pull raises the inside by", least_rise, 0.01));
  figure.checks.push_back(at_least("each pull lowers the outside by", least_fall, 0.01));
  // Only the interior value is not zero, so f scales with it and the curve stays.
  double moved = 0;
  for (Index i = 0; i < shown.curve.polylines[0].vertices.cols(); ++i)
    moved = std::max(moved, std::abs(scenes[3]->function().value(shown.curve.polylines[0].vertices.col(i))));
  figure.checks.push_back(at_most("the zero set stays: |f| of the steepest plate on it", moved, 1e-12));
  figure.panels = {std::move(plate), std::move(profiles)};
  figure.caption =
      "Left: the plate of Figure 1 bends through all poles; where it cuts the zero plane is the curve. "
      "Right: cut through "
      "one boundary constraint (red). Pulling the pole inside up lifts the plate on one side of the "
      "constraint and presses it "
      "down on the other, like a see-saw. All other values being zero, the plate only grows steeper and the "
      "curve stays.";
  return figure;
}

}  // namespace seesaw
