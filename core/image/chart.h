// A textbook chart: lines and markers over two axes.
//
// A Chart is a plain description; nothing is computed until it is drawn or laid out. Drawing returns the
// frame, which knows where each data point lies on the page, so that a caller can add marks of its own:
//
//     Chart chart{.title = "Convergence", .x = {.label = "N", .logarithmic = true}};
//     chart.series.push_back({.name = "error", .x = sizes, .y = errors, .marker = Marker::circle});
//     ChartFrame frame = draw_chart(canvas, {0, 0, 360, 240}, chart);
//     canvas.circle(frame.pixel_from_data({100, 1e-3}), 6, {.color = theme::moved});
//
// Before it: canvas.h, ticks.h. After it: figures of profiles, errors and times.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/image/canvas.h"
#include "core/image/chart_frame.h"

namespace seesaw {

enum class Marker { none, circle, square, triangle, diamond, plus, cross };

/// One curve or cloud. x and y are of one length. Values that are not numbers, and values that a
/// logarithmic axis cannot show, break the line.
struct Series {
  std::string name = {};  ///< for the legend; empty keeps it out
  std::vector<double> x = {}, y = {};
  std::optional<Color> color = {};  ///< by default the next of theme::series
  double line_width = 1.8;          ///< points; 0 for markers alone
  std::vector<double> dash = {};
  Marker marker = Marker::none;
  double marker_size = 6.5;  ///< points
};

/// A straight line across the plot at one value.
struct Reference {
  double value = 0;
  std::string label = {};  ///< along the line, where it hides the least data
  Stroke stroke = {.color = theme::soft_ink, .width = 1, .dash = {4, 3}, .cap = Cap::butt};
};

/// Words about one place of the plot.
struct Annotation {
  Point<2> at = {0, 0};         ///< data
  std::string text = {};        ///< '\n' breaks lines
  Point<2> offset = {18, -18};  ///< from the place to the words, points, y down
  bool arrow = true;            ///< a thin arrow from the words to the place
  Color color = theme::ink;
};

enum class Legend {
  automatic,  ///< in the corner of the plot that hides least; none for fewer than two names
  direct,     ///< each name at the right end of its line, in its color
  top_left,
  top_right,
  bottom_left,
  bottom_right,
  none
};

struct Chart {
  std::string title = {};
  Axis x = {}, y = {};
  std::vector<Series> series = {};
  std::vector<Reference> horizontal = {}, vertical = {};
  std::vector<Annotation> annotations = {};
  Legend legend = Legend::automatic;
  double text_size = 9.5;  ///< of tick labels, points; axis labels and the title follow
  bool grid = true;
};

/// Where everything goes when `chart` is drawn in `region` (points), including the axis labels. Throws
/// Error when a series has x and y of different lengths, or a region leaves no room for the plot.
ChartFrame lay_out(const Chart& chart, const Rect& region);

/// Draws it and returns the same frame.
ChartFrame draw_chart(Canvas& canvas, const Rect& region, const Chart& chart);

/// One marker centered at a page position, `size` points wide; open shapes have a paper rim.
void draw_marker(Canvas& canvas, Marker marker, const Point<2>& at, double size, const Color& color);

}  // namespace seesaw
