#include "core/scene/picture.h"

#include <cmath>

#include "core/base/text.h"
#include "core/image/colormap.h"
#include "core/scene/constraint_layer.h"
#include "core/scene/field_layer.h"
#include "core/scene/inside_rings.h"

namespace seesaw {

namespace {

void stroke_polyline(Canvas& canvas, const PlanView& view, const Polyline& polyline, const Stroke& stroke) {
  const Points<2> line = view.page_from_scene(polyline.vertices);
  polyline.closed ? canvas.polygon(line, stroke) : canvas.polyline(line, stroke);
}

// The tint of what is inside, also where the view cuts it.
void tint_inside(Canvas& canvas, const PlanView& view, const std::vector<Polyline>& polylines) {
  std::vector<Points<2>> rings;
  for (const Points<2>& ring : inside_rings(polylines, view.scene))
    rings.push_back(view.page_from_scene(ring));
  if (!rings.empty()) canvas.fill_rings(rings, diverging_color(0.22), FillRule::even_odd);
}

void draw_grid(Canvas& canvas, const PlanView& view) {
  // Lines at 1, 2 or 5 times a power of ten, some 40 points apart.
  double step = std::pow(10.0, std::ceil(std::log10(40 / view.scale)));
  for (const double finer : {0.5, 0.2})
    if (finer * step * view.scale >= 40) step *= finer;
  const Stroke stroke{.color = theme::grid, .width = 0.6};
  for (int axis = 0; axis < 2; ++axis)
    for (double k = std::ceil(view.scene.min()[axis] / step); k * step <= view.scene.max()[axis]; ++k) {
      Point<2> from = view.scene.min(), to = view.scene.max();
      from[axis] = to[axis] = k * step;
      canvas.line(view.page_from_scene(from), view.page_from_scene(to), stroke);
    }
}

// A bar of 1, 2 or 5 times a power of ten, about a sixth of the view, in its lower left corner.
struct ScaleBar {
  double length = 0;  // scene units
  Point<2> from = Point<2>::Zero(), to = Point<2>::Zero();
};

ScaleBar scale_bar(const PlanView& view) {
  const double wanted = view.scene.sizes().x() / 6;
  double length = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double longer : {5.0, 2.0})
    if (longer * length <= wanted * 1.2) {
      length *= longer;
      break;
    }
  const Point<2> from(view.page.left() + 10, view.page.bottom() - 9);
  return {length, from, from + Point<2>(length * view.scale, 0)};
}

void draw_scale_bar(Canvas& canvas, const PlanView& view, double text_size) {
  const auto [length, from, to] = scale_bar(view);
  canvas.line(from, to, {.color = theme::paper, .width = 4.5});
  canvas.line(from, to, {.color = theme::ink, .width = 2, .cap = Cap::butt});
  canvas.text((from + to) / 2 - Point<2>(0, 5), to_text(length, 3),
              {.size = text_size, .align = Align::center, .halo = 2.5});
}

// Arrows along grad f on a coarse grid: they point inward, and longer where f is steeper.
void draw_gradient(Canvas& canvas, const PlanView& view, const Field<2>& field) {
  constexpr double spacing = 30;
  std::vector<Point<2>> places;
  for (double y = view.page.top() + spacing / 2; y < view.page.bottom(); y += spacing)
    for (double x = view.page.left() + spacing / 2; x < view.page.right(); x += spacing)
      places.push_back({x, y});
  Points<2> points(2, static_cast<Index>(places.size()));
  for (Index i = 0; i < points.cols(); ++i)
    points.col(i) = view.scene_from_page(places[static_cast<std::size_t>(i)]);
  Values values(points.cols());
  Points<2> gradients(2, points.cols());
  field.evaluate(points, values, gradients);
  const double steepest = gradients.colwise().norm().maxCoeff();
  // Of a function that is constant but for rounding there is none.
  if (!(steepest * view.scene.sizes().maxCoeff() > 1e-12 * values.cwiseAbs().maxCoeff())) return;
  for (Index i = 0; i < points.cols(); ++i) {
    const double depth = std::sqrt(gradients.col(i).norm() / steepest);
    if (!(depth > 0.1)) continue;
    const Point<2> half = Point<2>(gradients(0, i), -gradients(1, i)).normalized() * (0.42 * spacing * depth);
    const Point<2> at = places[static_cast<std::size_t>(i)];
    canvas.arrow(at - half, at + half, {.color = theme::soft_ink, .width = 0.8}, 4);
  }
}

}  // namespace

Contour contour(const Document<2>& document, const Field<2>& field, const Box<2>& box,
                const ContourOptions& options) {
  return contour(field, box, PointsRef<2>(boundary_points(document)), options);
}

DrawnPicture draw_document(Canvas& canvas, const Rect& region, const Document<2>& document,
                           const Field<2>& field, const PictureOptions& options) {
  const Display<2>& display = document.display;
  const PlanView view = plan_view(view_box(document, field), region);
  const PictureDetail& detail = options.detail;
  Contour curve = detail.every_component
                      ? contour(document, field, view.scene,
                                {.cells = detail.curve_cells, .max_refined_vertices = detail.most_vertices})
                      : contour(field, view.scene,
                                {.cells = detail.curve_cells,
                                 .find_hidden = false,
                                 .max_refined_vertices = detail.most_vertices});
  auto clip = canvas.clip(region);
  if (display.field || display.isolines) {
    const SampledField sampled =
        sample(field, view, std::max(2, static_cast<int>(std::lround(region.width * detail.field_samples))));
    const double range = options.color_range > 0 ? options.color_range : sampled.largest();
    if (display.field) draw_field_colors(canvas, view, sampled, range);
    if (!display.field && options.tint_inside) tint_inside(canvas, view, curve.polylines);
    if (display.grid) draw_grid(canvas, view);
    if (display.isolines) {
      std::vector<Point<2>> symbols = symbol_places(view, document);
      if (display.scale_bar) {
        const ScaleBar bar = scale_bar(view);
        symbols.insert(symbols.end(), {bar.from, (bar.from + bar.to) / 2 - Point<2>(0, 9), bar.to});
      }
      std::vector<Polyline> drawn = curve.polylines;
      drawn.insert(drawn.end(), options.ghosts.begin(), options.ghosts.end());
      draw_isolines(canvas, view, field, sampled,
                    {.range = range,
                     .on_colors = display.field,
                     .text_size = options.text_size,
                     .symbols = std::move(symbols),
                     .curves = std::move(drawn),
                     .cells = detail.isoline_cells,
                     .find_hidden = detail.every_component,
                     .most_vertices = detail.most_vertices});
    }
  } else {
    if (options.tint_inside) tint_inside(canvas, view, curve.polylines);
    if (display.grid) draw_grid(canvas, view);
  }
  if (display.gradient) draw_gradient(canvas, view, field);
  for (const Polyline& ghost : options.ghosts)
    stroke_polyline(canvas, view, ghost, {.color = theme::soft_ink, .width = 1.2, .dash = {5, 4}});
  for (const Polyline& polyline : curve.polylines)
    stroke_polyline(canvas, view, polyline, {.color = theme::curve, .width = options.curve_width});
  draw_constraints(canvas, view, document, options);
  if (display.scale_bar) draw_scale_bar(canvas, view, options.text_size);
  clip.close();
  return {view, std::move(curve)};
}

PlanView draw_plain_document(Canvas& canvas, const Rect& region, const Document<2>& document,
                             const PictureOptions& options) {
  Box<2> box = Box<2>(Point<2>(-1, -1), Point<2>(1, 1));
  if (document.display.view) box = *document.display.view;
  const PlanView view = plan_view(box, region);
  auto clip = canvas.clip(region);
  if (document.display.grid) draw_grid(canvas, view);
  draw_constraints(canvas, view, document, options);
  if (document.display.scale_bar) draw_scale_bar(canvas, view, options.text_size);
  clip.close();
  return view;
}

}  // namespace seesaw
