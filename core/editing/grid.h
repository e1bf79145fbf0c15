// A grid that points snap to, with a step that is a round number.
//
// Before it: how large a pixel is.  After it: core/editing/desk.h, wherever a point is placed or dragged.
//
// Snapped coordinates are the doubles that a person would type: 0.3, and not 3 * 0.1 = 0.30000000000000004.
#pragma once

#include "core/base/types.h"

namespace seesaw {

/// The smallest of ..., 0.1, 0.2, 0.5, 1, 2, 5, 10, ... that is not below `least` (> 0).
double round_step(double least);
/// The next of them above or below `step`.
double next_step(double step, bool larger);

/// The multiple of `step` (> 0) nearest to x; where `step` is one of the above, the double nearest to that.
double nearest_multiple(double x, double step);

struct Grid {
  bool on = false;
  /// In scene units; 0 lets the view choose, some 24 pixels.
  double chosen = 0;

  /// > 0, scene units. `pixel` is the view's.
  double step(double pixel) const { return chosen > 0 ? chosen : round_step(24 * pixel); }
  Point<2> nearest(const Point<2>& p, double pixel) const {
    return {nearest_multiple(p.x(), step(pixel)), nearest_multiple(p.y(), step(pixel))};
  }
};

}  // namespace seesaw
