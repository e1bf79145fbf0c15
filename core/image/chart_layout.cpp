// How much room the words of a chart take, and what is left for the plot.
#include "core/image/chart_layout.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace seesaw {

using namespace chart_length;

Color color_of(const Chart& chart, std::size_t i) {
  return chart.series[i].color.value_or(theme::series_color(i));
}

Color text_color_of(const Chart& chart, std::size_t i) {
  Lab lab = lab_of(color_of(chart, i));
  lab.L = std::min(lab.L, 48.0);
  return color_of(lab);
}

TextStyle tick_style(const Chart& chart) { return {.size = chart.text_size, .color = theme::soft_ink}; }
TextStyle axis_label_style(const Chart& chart) {
  return {.size = 1.08 * chart.text_size, .align = Align::center};
}
TextStyle title_style(const Chart& chart) { return {.size = 1.3 * chart.text_size, .bold = true}; }
TextStyle name_style(const Chart& chart) {
  return {.size = 1.02 * chart.text_size, .vertical = VerticalAlign::middle};
}

Points<2> page_points(const ChartFrame& frame, const Series& series) {
  Points<2> points(2, static_cast<Index>(series.x.size()));
  for (std::size_t i = 0; i < series.x.size(); ++i)
    points.col(static_cast<Index>(i)) = frame.pixel_from_data({series.x[i], series.y[i]});
  return points;
}

ChartFrame lay_out(const Chart& chart, const Rect& region) {
  std::vector<double> xs, ys;
  for (const Series& s : chart.series) {
    if (s.x.size() != s.y.size())
      throw Error("series \"" + s.name + "\" has " + std::to_string(s.x.size()) + " x and " +
                  std::to_string(s.y.size()) + " y");
    xs.insert(xs.end(), s.x.begin(), s.x.end());
    ys.insert(ys.end(), s.y.begin(), s.y.end());
  }
  for (const Reference& line : chart.vertical) xs.push_back(line.value);
  for (const Reference& line : chart.horizontal) ys.push_back(line.value);

  ChartFrame frame;
  frame.x = scale_for(chart.x, xs);
  frame.y = scale_for(chart.y, ys);

  const TextSize tick_size = measure_text("0", tick_style(chart));
  const TextSize label_size = measure_text("x", axis_label_style(chart));
  double top = tick_size.ascent / 2 + 2;
  if (!chart.title.empty()) top += measure_text(chart.title, title_style(chart)).ascent + title_gap;
  double bottom = tick + tick_gap + tick_size.height();
  if (!chart.x.label.empty()) bottom += label_gap + label_size.height();
  // An axis without a label still gets a number for every 26 points of height, a breath under three lines
  // of text.
  frame.y_ticks =
      frame.y.ticks(std::max(2, static_cast<int>((region.height - top - bottom) / (2.9 * chart.text_size))));

  double left = 0, right = 2;
  for (const Tick& t : frame.y_ticks) left = std::max(left, measure_text(t.label, tick_style(chart)).width);
  left += tick + tick_gap;
  if (!chart.y.label.empty()) left += label_gap + label_size.height();
  if (chart.legend == Legend::direct)
    for (const Series& s : chart.series)
      if (!s.name.empty())
        right = std::max(right, direct_gap + measure_text(s.name, name_style(chart)).width);

  // As many ticks as their labels leave air for; the last label may reach beyond the plot.
  for (int about = 8; about >= 2; --about) {
    frame.x_ticks = frame.x.ticks(about);
    double widest = 0;
    std::size_t labels = 0;
    for (const Tick& t : frame.x_ticks) {
      widest = std::max(widest, measure_text(t.label, tick_style(chart)).width);
      labels += !t.label.empty();
    }
    if (static_cast<double>(labels) * (widest + 2 * chart.text_size) < region.width - left - right) break;
  }
  const Tick* last = nullptr;
  for (const Tick& t : frame.x_ticks)
    if (!t.label.empty()) last = &t;
  if (last) {
    const double half = measure_text(last->label, tick_style(chart)).width / 2;
    const double free = (1 - frame.x.fraction(last->value)) * (region.width - left - right);
    right = std::max(right, half - std::max(0.0, free - right));
  }

  frame.plot = region.inset(left, top, right, bottom);
  if (!(frame.plot.width >= 10 && frame.plot.height >= 10))
    throw Error("a chart of this size leaves no room for its plot; give it more, or smaller text");
  return frame;
}

}  // namespace seesaw
