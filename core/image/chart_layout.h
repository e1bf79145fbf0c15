// Inside core/image: lengths and choices that laying a chart out and drawing it must agree on.
//
// Before it: chart.h. After it: chart_layout.cpp (margins), chart.cpp (ink), chart_legend.cpp (names).
#pragma once

#include <vector>

#include "core/image/chart.h"

namespace seesaw {

namespace chart_length {  // points
inline constexpr double tick = 4, minor_tick = 2.5, tick_gap = 4, label_gap = 7, title_gap = 9,
                        direct_gap = 6;
}  // namespace chart_length

/// The color of series number i: its own, or the next of the theme.
Color color_of(const Chart& chart, std::size_t i);
/// A series' color, dark enough to be read as text on paper.
Color text_color_of(const Chart& chart, std::size_t i);

TextStyle tick_style(const Chart& chart);
TextStyle axis_label_style(const Chart& chart);
TextStyle title_style(const Chart& chart);
TextStyle name_style(const Chart& chart);

/// The page positions of the series' points, 2 x N, with NaN where it has none.
Points<2> page_points(const ChartFrame& frame, const Series& series);

/// How much of the data a box on the page would cover: the number of samples along lines and of points
/// inside it.
double ink_under(const Rect& box, const ChartFrame& frame, const Chart& chart);

/// The names, in the way the chart asks for.
void draw_legend(Canvas& canvas, const ChartFrame& frame, const Chart& chart);

/// One short sample of the series, as a legend shows it.
void draw_sample(Canvas& canvas, const Point<2>& from, const Point<2>& to, const Series& series,
                 const Color& color);

}  // namespace seesaw
