// An upright rectangle of a page, in points: y down, origin at the top left.
//
// Before it: nothing. After it: canvas.h, chart.h, height_plot.h.
#pragma once

#include <algorithm>

#include "core/base/types.h"

namespace seesaw {

struct Rect {
  double x = 0, y = 0;           ///< the top left corner, points
  double width = 0, height = 0;  ///< points, 0 or more

  double left() const { return x; }
  double right() const { return x + width; }
  double top() const { return y; }
  double bottom() const { return y + height; }
  Point<2> center() const { return {x + width / 2, y + height / 2}; }
  bool contains(const Point<2>& p) const {
    return p.x() >= x && p.x() <= right() && p.y() >= y && p.y() <= bottom();
  }

  /// Smaller by `margin` points on every side; never less than nothing.
  Rect inset(double margin) const { return inset(margin, margin, margin, margin); }
  Rect inset(double from_left, double from_top, double from_right, double from_bottom) const {
    return {x + from_left, y + from_top, std::max(0.0, width - from_left - from_right),
            std::max(0.0, height - from_top - from_bottom)};
  }
};

}  // namespace seesaw
