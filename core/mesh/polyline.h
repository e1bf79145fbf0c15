// Chains of points in the plane: what a curve becomes when it is drawn, measured or cut.
//
// Before it: core/contour, which turns f = 0 into polylines.
// After it: pictures (core/image), files, and anybody who wants a length, an area or "is this point inside?".
//
// Direction carries meaning: inside lies on the *left*. So an outer boundary runs counter-clockwise and has
// positive area, the rim of a hole runs clockwise and has negative area, and the areas of a shape's boundary
// curves add up to the area of the shape.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "core/base/types.h"

namespace seesaw {

/// A chain of straight segments. Closed: the last vertex is joined to the first, which is not repeated.
struct Polyline {
  Points<2> vertices = Points<2>(2, 0);
  bool closed = false;

  /// Number of segments: as many as vertices when closed, one less when open.
  Index segments() const { return closed ? vertices.cols() : std::max<Index>(0, vertices.cols() - 1); }
};

/// Area to the left of the polyline minus area to its right, in squared scene units: positive for a
/// counter-clockwise loop. An open polyline is measured as if a straight segment closed it.
double signed_area(const Polyline& polyline);

/// In scene units; a closed polyline's last segment counts.
double length(const Polyline& polyline);

/// The smallest box around the vertices; empty for none.
Box<2> bounding_box(const Polyline& polyline);

/// How many times the closed polyline runs around `point`, counter-clockwise positive. Exact, whatever the
/// rounding, for every point that is not on the polyline; on it, the answer of one of the two sides. An open
/// polyline runs around nothing: 0.
int winding_number(const Polyline& polyline, const Point<2>& point);

/// The sum over all polylines: for the complete boundary of a shape, 1 inside, 0 outside.
int winding_number(const std::vector<Polyline>& polylines, const Point<2>& point);

/// The distance from `point` to the nearest segment (or lone vertex), in scene units; infinite for no vertex.
double distance(const Polyline& polyline, const Point<2>& point);

/// The polylines as CSV: the line "polyline,closed,x,y", then one line a vertex, polylines counted from 0,
/// closed 0 or 1. Seventeen digits, so that reading gives back the same numbers.
std::string to_csv(const std::vector<Polyline>& polylines);

}  // namespace seesaw
