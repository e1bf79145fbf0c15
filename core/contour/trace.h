// From passages through triangles to polylines.
//
// Before it: crossings.h, refined; seeds attached to their passages.  After it: core/mesh/polyline.h.
#pragma once

#include "core/contour/seeds.h"
#include "core/mesh/polyline.h"

namespace seesaw {

/// All polylines, closed or with both ends on the box, inside on the left, in an order that depends on
/// nothing but the triangulation. Seeds become vertices. Pieces with nothing inside them are left out: loops
/// that shrink to a point, and lines of exact zeros with f < 0 on both sides.
std::vector<Polyline> trace(const Crossings& curve, const std::vector<Seed>& seeds, double angle_tolerance);

/// The part of the box's area that is inside: the polylines and the stretches of the box's sides that are
/// inside, together its boundary, in squared scene units.
double inside_area(const Crossings& curve, const std::vector<Polyline>& polylines);

}  // namespace seesaw
