// A mesh without needles. A lattice cuts a surface into slivers wherever it passes close to a corner.
//
// Before it: assemble.h.  After it: project.h brings every vertex onto f = 0 to rounding.
//
// Three moves, none of which changes the topology or turns a triangle over: edges much shorter than a cube
// collapse, shortest first; edges flip where that widens the smallest angle of their two triangles (Lawson
// 1977) and the two are nearly in one plane; vertices slide in their tangent plane toward the middle of their
// neighbors and are pulled back onto f = 0 by one Newton step, if their triangles are the better for it.
// Vertices on the box's faces do not move.
#pragma once

#include "core/polygonize/assemble.h"

namespace seesaw {

/// The smallest angle of any triangle, degrees; 0 for no triangles.
double smallest_angle(const Points<3>& positions, const Faces& faces);

/// Collapses edges of no length, which exact zeros at lattice corners leave behind.
void collapse_empty_edges(LatticeMesh& mesh, double cell);

/// All three moves; `cell` is the side of a cube.
void improve(LatticeMesh& mesh, Sampler& sampler, double cell);

}  // namespace seesaw
