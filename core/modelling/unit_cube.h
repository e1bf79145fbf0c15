// The model scaled to the unit cube: the coordinates in which "0.01" means something.
//
// Before it: a model in meters or microns, here or at an offset of 1e7.
// After it: lengths of this folder are fractions of the model's longest side.
#pragma once

#include "core/base/types.h"

namespace seesaw {

/// x_unit = (x - center) / scale: the box's middle becomes the origin, its longest side 1.
struct UnitCube {
  Point<3> center = Point<3>::Zero();
  double scale = 1;  ///< scene units; 1 for a box without size

  static UnitCube of(const Box<3>& box) {
    if (box.isEmpty()) return {};
    const double longest = box.sizes().maxCoeff();
    // Not (min + max) / 2, whose sum may be beyond all doubles.
    return {box.min() + 0.5 * box.sizes(), longest > 0 ? longest : 1.0};
  }
  Points<3> apply(const PointsRef<3>& points) const { return (points.colwise() - center) / scale; }
};

}  // namespace seesaw
