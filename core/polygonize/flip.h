// Edges flip where that widens the smallest angle of their two triangles (Lawson 1977).
//
// Before it: collapse.h.  After it: slide.h; the two take turns.
#pragma once

#include "core/polygonize/working_mesh.h"

namespace seesaw {

/// Flips edges, those of the worst triangles first, where the two triangles are nearly in one plane and not
/// both good as they are. One pass: what has become possible by the flips of a pass is left to the next.
void flip_edges(WorkingMesh& work);

}  // namespace seesaw
