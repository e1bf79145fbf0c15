// Which curve is which: a box in the emptiest corner, or each name beside its own curve.
#include <algorithm>
#include <cmath>

#include "core/image/chart_layout.h"

namespace seesaw {
namespace {

constexpr double sample_length = 22, sample_gap = 7, padding = 7;  // points

std::vector<std::size_t> named_series(const Chart& chart) {
  std::vector<std::size_t> named;
  for (std::size_t i = 0; i < chart.series.size(); ++i)
    if (!chart.series[i].name.empty()) named.push_back(i);
  return named;
}

Rect corner_box(const Rect& plot, double width, double height, Legend corner) {
  constexpr double margin = 6;
  const bool left = corner == Legend::top_left || corner == Legend::bottom_left;
  const bool top = corner == Legend::top_left || corner == Legend::top_right;
  return {left ? plot.left() + margin : plot.right() - margin - width,
          top ? plot.top() + margin : plot.bottom() - margin - height, width, height};
}

void draw_box(Canvas& canvas, const ChartFrame& frame, const Chart& chart) {
  const std::vector<std::size_t> named = named_series(chart);
  const TextStyle style = name_style(chart);
  const double row = 1.55 * chart.text_size;
  double widest = 0;
  for (const std::size_t i : named)
    widest = std::max(widest, measure_text(chart.series[i].name, style).width);
  const double width = widest + sample_length + sample_gap + 2 * padding;
  const double height = static_cast<double>(named.size()) * row + 2 * padding - 0.4 * chart.text_size;

  Legend corner = chart.legend;
  if (corner == Legend::automatic) {
    double least = infinity;
    for (const Legend c : {Legend::top_right, Legend::top_left, Legend::bottom_right, Legend::bottom_left}) {
      const double hidden = ink_under(corner_box(frame.plot, width, height, c), frame, chart);
      if (hidden < least) {
        least = hidden;
        corner = c;
      }
    }
  }
  const Rect box = corner_box(frame.plot, width, height, corner);
  canvas.fill_rectangle(box, theme::paper.with_alpha(0.9), 3);
  canvas.rectangle(box, {.color = theme::grid, .width = 0.7});
  double y = box.top() + padding + 0.58 * chart.text_size;
  for (const std::size_t i : named) {
    const Point<2> from(box.left() + padding, y);
    draw_sample(canvas, from, from + Point<2>(sample_length, 0), chart.series[i], color_of(chart, i));
    canvas.text(from + Point<2>(sample_length + sample_gap, 0), chart.series[i].name, style);
    y += row;
  }
}

void draw_direct(Canvas& canvas, const ChartFrame& frame, const Chart& chart) {
  struct Name {
    std::size_t series;
    double y;
  };
  std::vector<Name> names;
  for (const std::size_t i : named_series(chart)) {
    const Points<2> points = page_points(frame, chart.series[i]);
    for (Index k = points.cols() - 1; k >= 0; --k) {
      if (!points.col(k).allFinite() || points(0, k) > frame.plot.right() + 0.5) continue;
      names.push_back({i, std::clamp(points(1, k), frame.plot.top(), frame.plot.bottom())});
      break;
    }
  }
  std::stable_sort(names.begin(), names.end(), [](const Name& a, const Name& b) { return a.y < b.y; });
  // Neighbors that would overlap share the shift between them; a few rounds settle any chart that fits at
  // all.
  const double apart = 1.3 * chart.text_size;
  for (int round = 0; round < 200; ++round) {
    bool moved = false;
    for (std::size_t i = 0; i + 1 < names.size(); ++i) {
      const double missing = apart - (names[i + 1].y - names[i].y);
      if (missing < 1e-6) continue;
      names[i].y -= missing / 2;
      names[i + 1].y += missing / 2;
      moved = true;
    }
    if (!moved) break;
  }
  for (const Name& name : names) {
    TextStyle style = name_style(chart);
    style.color = text_color_of(chart, name.series);
    canvas.text({frame.plot.right() + chart_length::direct_gap, name.y}, chart.series[name.series].name,
                style);
  }
}

}  // namespace

double ink_under(const Rect& box, const ChartFrame& frame, const Chart& chart) {
  const Rect around = box.inset(-5);
  double hidden = 0;
  const auto look = [&](const Point<2>& p) { hidden += p.allFinite() && around.contains(p) ? 1 : 0; };
  for (const Series& s : chart.series) {
    const Points<2> points = page_points(frame, s);
    for (Index i = 0; i < points.cols(); ++i) {
      look(points.col(i));
      if (i + 1 == points.cols() || !(s.line_width > 0)) continue;
      const Point<2> a = points.col(i), step = points.col(i + 1) - points.col(i);
      const double length = step.norm();
      if (!std::isfinite(length)) continue;
      const int pieces = std::min(400, static_cast<int>(length / 4));
      for (int k = 1; k < pieces; ++k) look(a + step * (static_cast<double>(k) / pieces));
    }
  }
  for (const Annotation& note : chart.annotations)
    hidden += 50 * around.contains(frame.pixel_from_data(note.at) + note.offset);
  return hidden;
}

void draw_legend(Canvas& canvas, const ChartFrame& frame, const Chart& chart) {
  const std::size_t names = named_series(chart).size();
  if (names == 0 || chart.legend == Legend::none) return;
  if (chart.legend == Legend::direct) return draw_direct(canvas, frame, chart);
  if (chart.legend != Legend::automatic || names > 1) draw_box(canvas, frame, chart);
}

}  // namespace seesaw
