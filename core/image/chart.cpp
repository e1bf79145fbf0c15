// The ink of a chart, from back to front: grid, references, data, axes, words.
#include "core/image/chart.h"

#include <algorithm>
#include <cmath>

#include "core/image/chart_layout.h"

namespace seesaw {

using namespace chart_length;

namespace {

void draw_grid(Canvas& canvas, const ChartFrame& frame) {
  const Stroke stroke{.color = theme::grid, .width = 0.7, .cap = Cap::butt};
  const Rect& plot = frame.plot;
  for (const Tick& t : frame.x_ticks) {
    const double x = plot.left() + frame.x.fraction(t.value) * plot.width;
    if (t.major) canvas.line({x, plot.top()}, {x, plot.bottom()}, stroke);
  }
  for (const Tick& t : frame.y_ticks) {
    const double y = plot.bottom() - frame.y.fraction(t.value) * plot.height;
    if (t.major) canvas.line({plot.left(), y}, {plot.right(), y}, stroke);
  }
}

void draw_axes(Canvas& canvas, const ChartFrame& frame, const Chart& chart, const Rect& region) {
  const Stroke stroke{.color = theme::ink, .width = 0.9, .cap = Cap::butt};
  const Rect& plot = frame.plot;
  Points<2> corner(2, 3);
  corner << plot.left(), plot.left(), plot.right(), plot.top(), plot.bottom(), plot.bottom();
  canvas.polyline(corner, stroke);

  TextStyle words = tick_style(chart);
  words.align = Align::center;
  words.vertical = VerticalAlign::top;
  for (const Tick& t : frame.x_ticks) {
    const double x = plot.left() + frame.x.fraction(t.value) * plot.width;
    canvas.line({x, plot.bottom()}, {x, plot.bottom() + (t.major ? tick : minor_tick)}, stroke);
    canvas.text({x, plot.bottom() + tick + tick_gap}, t.label, words);
  }
  words.align = Align::right;
  words.vertical = VerticalAlign::middle;
  for (const Tick& t : frame.y_ticks) {
    const double y = plot.bottom() - frame.y.fraction(t.value) * plot.height;
    canvas.line({plot.left() - (t.major ? tick : minor_tick), y}, {plot.left(), y}, stroke);
    canvas.text({plot.left() - tick - tick_gap, y}, t.label, words);
  }

  TextStyle label = axis_label_style(chart);
  const TextSize size = measure_text("x", label);
  canvas.text({plot.center().x(), region.bottom() - size.descent}, chart.x.label, label);
  label.rotation = 90;
  canvas.text({region.left() + size.ascent, plot.center().y()}, chart.y.label, label);
  const TextStyle title = title_style(chart);
  canvas.text({plot.left(), region.top() + measure_text("x", title).ascent}, chart.title, title);
}

// Page position of a reference line; not a number when it lies outside the plot.
double place_of(const Reference& line, const ChartFrame& frame, bool horizontal) {
  const Rect& plot = frame.plot;
  const double t = (horizontal ? frame.y : frame.x).fraction(line.value);
  if (!(t >= -1e-6 && t <= 1 + 1e-6)) return std::nan("");
  return horizontal ? plot.bottom() - t * plot.height : plot.left() + t * plot.width;
}

void draw_reference_lines(Canvas& canvas, const ChartFrame& frame, const Chart& chart) {
  const Rect& plot = frame.plot;
  for (const Reference& line : chart.horizontal) {
    const double y = place_of(line, frame, true);
    canvas.line({plot.left(), y}, {plot.right(), y}, line.stroke);
  }
  for (const Reference& line : chart.vertical) {
    const double x = place_of(line, frame, false);
    canvas.line({x, plot.top()}, {x, plot.bottom()}, line.stroke);
  }
}

// Each label lies along its line where it hides the least data: at the right, left or middle of a
// horizontal line, above or below it; at the top or bottom of a vertical one, right or left of it.
void draw_reference_labels(Canvas& canvas, const ChartFrame& frame, const Chart& chart) {
  const Rect& plot = frame.plot;
  TextStyle style = tick_style(chart);
  style.halo = 1.5;
  style.vertical = VerticalAlign::top;
  const auto place = [&](const Reference& line, const std::vector<Point<2>>& places, const TextSize& size) {
    const Point<2>* best = nullptr;
    double least = infinity;
    for (const Point<2>& p : places) {
      if (!plot.inset(-1).contains(p) || !plot.inset(-1).contains(p + Point<2>(size.width, size.height())))
        continue;
      const double hidden = ink_under({p.x(), p.y(), size.width, size.height()}, frame, chart);
      if (hidden >= least) continue;
      least = hidden;
      best = &p;
    }
    style.color = line.stroke.color;
    if (best) canvas.text(*best, line.label, style);
  };
  for (const Reference& line : chart.horizontal) {
    const TextSize size = measure_text(line.label, style);
    const double y = place_of(line, frame, true), above = y - size.height() - 1.5, below = y + 4;
    const double right = plot.right() - 4 - size.width, left = plot.left() + 6,
                 middle = plot.center().x() - size.width / 2;
    place(line,
          {{right, above}, {left, above}, {right, below}, {left, below}, {middle, above}, {middle, below}},
          size);
  }
  for (const Reference& line : chart.vertical) {
    const TextSize size = measure_text(line.label, style);
    const double x = place_of(line, frame, false), right = x + 4, left = x - 4 - size.width;
    const double top = plot.top() + 4, bottom = plot.bottom() - 4 - size.height();
    place(line, {{right, top}, {left, top}, {right, bottom}, {left, bottom}}, size);
  }
}

void draw_series(Canvas& canvas, const ChartFrame& frame, const Chart& chart) {
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const Series& series = chart.series[i];
    const Points<2> points = page_points(frame, series);
    const auto inside = canvas.clip(frame.plot.inset(-series.line_width / 2));
    canvas.polyline(points, {.color = color_of(chart, i),
                             .width = series.line_width,
                             .dash = series.dash,
                             .cap = series.dash.empty() ? Cap::round : Cap::butt});
  }
  // Markers above all lines, and whole where they touch the frame.
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const Series& series = chart.series[i];
    const Points<2> points = page_points(frame, series);
    for (Index k = 0; k < points.cols(); ++k)
      if (frame.plot.inset(-0.5).contains(points.col(k)))
        draw_marker(canvas, series.marker, points.col(k), series.marker_size, color_of(chart, i));
  }
}

void draw_annotations(Canvas& canvas, const ChartFrame& frame, const Chart& chart) {
  for (const Annotation& note : chart.annotations) {
    const Point<2> at = frame.pixel_from_data(note.at);
    const double distance = note.offset.norm();
    if (!at.allFinite() || !std::isfinite(distance)) continue;
    const Point<2> words = at + note.offset;
    const bool right = note.offset.x() >= 0, above = note.offset.y() < 0;
    if (note.arrow && distance > 12) {
      const Point<2> along = note.offset / distance;
      canvas.arrow(words - 3 * along, at + 5 * along, {.color = note.color.with_alpha(0.8), .width = 0.9},
                   5.5);
    }
    TextStyle style = name_style(chart);
    style.color = note.color;
    style.halo = 2;
    // Words sit on the far side of the arrow's tail: beside it when it runs along, above or below when it
    // climbs.
    const bool steep = std::abs(note.offset.y()) > 2 * std::abs(note.offset.x());
    style.align = steep ? Align::center : right ? Align::left : Align::right;
    style.vertical = VerticalAlign::middle;
    std::vector<std::string> lines(1);
    for (const char c : note.text) c == '\n' ? lines.emplace_back() : lines.back() += c;
    const double step = 1.35 * style.size, extra = static_cast<double>(lines.size() - 1) * step;
    double y = words.y() - extra / 2;
    if (steep) y = above ? words.y() - extra - 0.5 * style.size : words.y() + 0.5 * style.size;
    for (const std::string& text : lines) {
      canvas.text({words.x() + (steep ? 0 : right ? 2 : -2), y}, text, style);
      y += step;
    }
  }
}

}  // namespace

void draw_marker(Canvas& canvas, Marker marker, const Point<2>& at, double size, const Color& color) {
  if (!(size > 0) || marker == Marker::none || !at.allFinite()) return;
  const double r = size / 2;
  const auto shape = [&](std::initializer_list<Point<2>> corners) {
    Points<2> points(2, static_cast<Index>(corners.size()));
    Index i = 0;
    for (const Point<2>& c : corners) points.col(i++) = at + r * c;
    canvas.polygon(points, {.color = theme::paper, .width = 1.6});
    canvas.fill_polygon(points, color);
  };
  const auto bars = [&](const Point<2>& u, const Point<2>& v) {
    for (const bool under : {true, false}) {
      const Stroke stroke{.color = under ? theme::paper : color,
                          .width = under ? 0.24 * size + 1.6 : 0.24 * size};
      canvas.line(at - r * u, at + r * u, stroke);
      canvas.line(at - r * v, at + r * v, stroke);
    }
  };
  switch (marker) {
    case Marker::none:
      break;
    case Marker::circle:
      canvas.fill_circle(at, r + 0.8, theme::paper);
      canvas.fill_circle(at, r, color);
      break;
    case Marker::square:
      shape({{-0.88, -0.88}, {0.88, -0.88}, {0.88, 0.88}, {-0.88, 0.88}});
      break;
    case Marker::triangle:
      shape({{0, -1.15}, {1.08, 0.75}, {-1.08, 0.75}});
      break;
    case Marker::diamond:
      shape({{0, -1.25}, {1.1, 0}, {0, 1.25}, {-1.1, 0}});
      break;
    case Marker::plus:
      bars({1, 0}, {0, 1});
      break;
    case Marker::cross:
      bars({0.8, 0.8}, {0.8, -0.8});
      break;
  }
}

void draw_sample(Canvas& canvas, const Point<2>& from, const Point<2>& to, const Series& series,
                 const Color& color) {
  canvas.line(from, to,
              {.color = color,
               .width = series.line_width,
               .dash = series.dash,
               .cap = series.dash.empty() ? Cap::round : Cap::butt});
  draw_marker(canvas, series.marker, (from + to) / 2, series.marker_size, color);
}

ChartFrame draw_chart(Canvas& canvas, const Rect& region, const Chart& chart) {
  const ChartFrame frame = lay_out(chart, region);
  if (chart.grid) draw_grid(canvas, frame);
  draw_reference_lines(canvas, frame, chart);
  draw_axes(canvas, frame, chart, region);
  draw_series(canvas, frame, chart);
  draw_reference_labels(canvas, frame, chart);
  draw_legend(canvas, frame, chart);
  draw_annotations(canvas, frame, chart);
  return frame;
}

}  // namespace seesaw
