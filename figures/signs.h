// The sign of f around a curve: positive inside, negative outside, and where far away it comes back (T&O
// 2002, 4.1).
#pragma once

#include "figures/scene_panel.h"

namespace seesaw {

struct Signs {
  double size = 0;             ///< the longer side of the box around the curve, scene units
  double smallest_inside = 0;  ///< least f on a lattice of the inside
  double largest_outside = 0;  ///< greatest f outside, to five sizes from the middle
  /// The least distance from the middle, in sizes, at which f turns positive again, looking along 360
  /// directions; 1e8, as far as is looked, if it never does.
  double returns_at_sizes = 0;
};

/// For a scene of one closed curve.
Signs measure_signs(const FittedScene& scene);

/// Adds them to the panel's facts, and the paper's claims about them to the figure's checks.
void add_signs(const Signs& signs, Panel& panel, Figure& figure);

}  // namespace seesaw
