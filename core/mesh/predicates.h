// On which side? Asked of points and lines or planes, and always answered rightly.
//
// Before it: coordinates as they are.  After it: self_intersections.h, shells.h, polygon_triangles.h, which
// decide topology by these signs and would contradict themselves if rounding decided any of them.
//
// First the determinant in plain arithmetic, with a bound on its rounding error; only where that cannot tell
// (for points that are nearly or exactly on the plane) the same determinant in exact arithmetic, as sums of
// doubles that do not overlap (Shewchuk 1997, "Adaptive precision floating-point arithmetic and fast robust
// geometric predicates"). Exact as long as products of three coordinates neither overflow nor underflow.
#pragma once

#include "core/base/types.h"

namespace seesaw {

/// 1 when a, b, c run counter-clockwise, -1 when clockwise, 0 when they lie on one line.
int side_of_line(const Point<2>& a, const Point<2>& b, const Point<2>& c);

/// 1 when d lies on the side of the plane through a, b, c to which (b - a) x (c - a) points, -1 on the other
/// side, 0 in the plane (also when a, b, c lie on one line).
int side_of_plane(const Point<3>& a, const Point<3>& b, const Point<3>& c, const Point<3>& d);

}  // namespace seesaw
