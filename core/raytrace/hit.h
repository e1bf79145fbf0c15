// Inside core/raytrace: where a ray met a surface.
#pragma once

#include "core/raytrace/material.h"
#include "core/raytrace/ray.h"

namespace seesaw {

struct Hit {
  double t = infinity;  ///< infinite for nothing
  Point<3> place = Point<3>::Zero();
  /// Where rays that leave the surface start: on its outer side, clear of the rounding of `place`.
  Point<3> start = Point<3>::Zero();
  Point<3> facet = Point<3>::UnitZ();   ///< unit normal of the surface itself, toward the ray's origin
  Point<3> normal = Point<3>::UnitZ();  ///< unit normal to shade by, toward the ray's origin
  const Material* material = nullptr;
  bool back = false;      ///< seen from the side that the outward normal does not leave by
  Color line = {};        ///< an edge line drawn over the surface ...
  double line_cover = 0;  ///< ... and how much of the sample it covers, 0 or 1

  bool found() const { return t < infinity; }
};

}  // namespace seesaw
