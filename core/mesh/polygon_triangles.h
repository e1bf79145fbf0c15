// Cuts a polygon in space into triangles, also where it is concave.
//
// Before it: a polygon of a file, its corners nearly in one plane.  After it: the faces of a TriangleMesh.
//
// The polygon is seen along the coordinate axis nearest to its normal (Newell's: the sum of the cross
// products of successive corners, exact for a plane polygon of any shape), and ears are cut off: a corner
// that turns left, with no other corner in the triangle it makes with its neighbors (Meisters 1975: a simple
// polygon always has two). All turns are exact (predicates.h). Of a convex quadrilateral the shorter diagonal
// is taken.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/types.h"

namespace seesaw {

/// Appends the n - 2 triangles of `polygon` (n >= 3 columns of `points`, in order) to `triangles`, as vertex
/// indices in the polygon's direction. No corner is left out, also not one on a straight side. Returns false
/// where it was seen that the polygon crosses itself: it is then cut all the same, but somehow. About O(n)
/// for polygons whose corners are spread evenly, O(n^2) at worst.
bool cut_polygon(const Eigen::Ref<const Points<3>>& points, std::span<const int> polygon,
                 std::vector<std::array<int, 3>>& triangles);

}  // namespace seesaw
