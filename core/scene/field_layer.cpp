#include "core/scene/field_layer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/text.h"
#include "core/contour/contour.h"
#include "core/image/colormap.h"

namespace seesaw {

SampledField sample(const Field<2>& field, const PlanView& view, int columns) {
  const int rows = std::max(1, static_cast<int>(std::lround(columns * view.page.height / view.page.width)));
  const Point<2> size = view.scene.sizes();
  Points<2> points(2, static_cast<Index>(rows) * columns);
  for (Index r = 0; r < rows; ++r)
    for (Index c = 0; c < columns; ++c)
      points.col(r * columns + c) =
          view.scene.min() + Point<2>((static_cast<double>(c) + 0.5) / columns * size.x(),
                                      (static_cast<double>(r) + 0.5) / rows * size.y());
  const Values values = field.values(points);
  SampledField sampled;
  sampled.values = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
      values.data(), rows, columns);
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    sampled.lowest = std::min(sampled.lowest, value);
    sampled.highest = std::max(sampled.highest, value);
  }
  return sampled;
}

double color_depth(double value, double range) {
  return std::copysign(std::sqrt(std::abs(value) / std::max(range, std::numeric_limits<double>::min())),
                       value);
}

void draw_field_colors(Canvas& canvas, const PlanView& view, const SampledField& sampled, double range) {
  const Index rows = sampled.values.rows(), columns = sampled.values.cols();
  Image image(static_cast<int>(columns), static_cast<int>(rows));
  for (Index r = 0; r < rows; ++r)
    for (Index c = 0; c < columns; ++c)
      image.set(static_cast<int>(c), static_cast<int>(rows - 1 - r),
                diverging_color(0.9 * color_depth(sampled.values(r, c), range)));
  canvas.picture(image, view.page);
}

std::vector<double> isoline_levels(double lowest, double highest) {
  const auto largest_under = [](double limit, std::size_t most) {
    std::vector<double> levels;
    if (!(limit > 0) || !std::isfinite(limit)) return levels;
    const int top = static_cast<int>(std::ceil(std::log10(limit)));
    for (int power = top; power > top - 3; --power)
      for (const double digit : {5.0, 2.0, 1.0}) {
        const double level = digit * std::pow(10.0, power);
        if (level < limit && level > limit / 20 && levels.size() < most) levels.push_back(level);
      }
    return levels;
  };
  std::vector<double> levels;
  for (const double level : largest_under(0.97 * -lowest, 5)) levels.push_back(-level);
  std::vector<double> inside = largest_under(0.97 * highest, 4);
  levels.insert(levels.end(), inside.rbegin(), inside.rend());
  return levels;
}

namespace {

// A minus sign as wide as the digits.
std::string label_of(double level) {
  std::string text = to_text(std::abs(level), 5);
  return level < 0 ? "\u2212" + text : text;
}

struct Place {
  Point<2> at;
  double angle = 0;      // degrees, counterclockwise on the page, within -90 .. 90
  double straight = -1;  // 1 where the line does not bend under the label
};

double clearance_of(const Point<2>& at, const std::vector<Point<2>>& others) {
  double clearance = infinity;
  for (const Point<2>& other : others) clearance = std::min(clearance, (other - at).norm());
  return clearance;
}

// The straightest stretch of the polyline (page coordinates) as long as the label, well inside the page, and
// clear of what is there already.
Place label_place(const Points<2>& line, bool closed, double width, const Rect& page,
                  const std::vector<Point<2>>& taken, const std::vector<Polyline>& curves, double height) {
  Place best;
  const Index n = line.cols();
  const Rect inner = page.inset(0.7 * width);
  for (Index i = 0; i < n; ++i) {
    const Point<2> at = line.col(i);
    if (!inner.contains(at)) continue;
    if (clearance_of(at, taken) < 0.9 * width) continue;
    if (std::any_of(curves.begin(), curves.end(),
                    [&](const Polyline& curve) { return distance(curve, at) < height; }))
      continue;
    const auto walk = [&](Index step) {
      double way = 0;
      Index j = i;
      while (way < 0.6 * width) {
        const Index next = closed ? (j + step + n) % n : j + step;
        if (next < 0 || next >= n || next == i) return Index{-1};
        way += (line.col(next) - line.col(j)).norm();
        j = next;
      }
      return j;
    };
    const Index before = walk(-1), after = walk(1);
    if (before < 0 || after < 0) continue;
    const Point<2> back = (at - line.col(before)).normalized(), ahead = (line.col(after) - at).normalized();
    const double straight = back.dot(ahead);
    if (straight <= best.straight) continue;
    double angle = -std::atan2(ahead.y() + back.y(), ahead.x() + back.x()) * 180 / M_PI;
    if (angle > 90) angle -= 180;
    if (angle < -90) angle += 180;
    best = {at, angle, straight};
  }
  return best;
}

}  // namespace

void draw_isolines(Canvas& canvas, const PlanView& view, const Field<2>& field, const SampledField& sampled,
                   const IsolineStyle& style) {
  const std::vector<double> levels = isoline_levels(sampled.lowest, sampled.highest);
  const std::vector<Contour> contours = isolines(
      field, view.scene, levels,
      {.cells = style.cells, .find_hidden = style.find_hidden, .max_refined_vertices = style.most_vertices});
  const Stroke stroke{.color = theme::isoline.with_alpha(style.on_colors ? 0.75 : 0.9), .width = 0.7};
  for (const Contour& each : contours)
    for (const Polyline& polyline : each.polylines) {
      const Points<2> line = view.page_from_scene(polyline.vertices);
      polyline.closed ? canvas.polygon(line, stroke) : canvas.polyline(line, stroke);
    }
  std::vector<Polyline> curves = style.curves;
  for (Polyline& curve : curves) curve.vertices = view.page_from_scene(curve.vertices);
  std::vector<Point<2>> taken = style.symbols;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    TextStyle text_style{.size = style.text_size,
                         .color = theme::soft_ink,
                         .align = Align::center,
                         .vertical = VerticalAlign::middle,
                         .halo = 2.5};
    if (style.on_colors) text_style.halo_color = diverging_color(0.9 * color_depth(levels[k], style.range));
    const std::string text = label_of(levels[k]);
    const double width = measure_text(text, text_style).width + 2 * style.text_size;
    // One label a level, on its longest piece that has room for it.
    std::vector<const Polyline*> pieces;
    for (const Polyline& polyline : contours[k].polylines) pieces.push_back(&polyline);
    std::stable_sort(pieces.begin(), pieces.end(),
                     [](const Polyline* a, const Polyline* b) { return length(*a) > length(*b); });
    for (const Polyline* piece : pieces) {
      const Place place = label_place(view.page_from_scene(piece->vertices), piece->closed, width, view.page,
                                      taken, curves, style.text_size);
      if (place.straight < 0.9) continue;
      text_style.rotation = place.angle;
      canvas.text(place.at, text, text_style);
      taken.push_back(place.at);
      break;
    }
  }
}

}  // namespace seesaw
