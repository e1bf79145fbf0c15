// Needles vanish when an edge of theirs collapses.
//
// Before it: working_mesh.h.  After it: flip.h and slide.h, which better what is left.
//
// A lattice cuts a surface into slivers wherever it passes close to a corner. Most of them have an edge much
// shorter than a cube, and are gone with it: these go first, the shortest before the others. What still is a
// needle when edges have flipped and vertices have slid nearly always has a corner with three or four
// triangles only, which no flip can help; it is pulled into a neighbor. No triangle turns over, the topology
// stays (half_edges.h), and a vertex on a face of the lattice's range stays on that face.
#pragma once

#include "core/polygonize/working_mesh.h"

namespace seesaw {

/// Collapses edges of at most `length`, scene units: into the middle, or into the end that may not move.
void collapse_short_edges(WorkingMesh& work, double length);

/// Collapses edges of the needles left, of any length, where that makes the worst angle around wider.
void collapse_needles(WorkingMesh& work);

}  // namespace seesaw
