// A ray, and a stretch of it that matters.
//
// Before it: camera.h, or a surface that reflects or is lit. After it: whatever can be hit.
#pragma once

#include "core/base/types.h"

namespace seesaw {

/// The points origin + t * direction with begin <= t <= end; t is a length in scene units.
struct Ray {
  Point<3> origin = Point<3>::Zero();
  Point<3> direction = Point<3>::UnitZ();  ///< of length 1
  double begin = 0;
  double end = infinity;

  Point<3> at(double t) const { return origin + t * direction; }
};

}  // namespace seesaw
