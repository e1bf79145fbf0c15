// Edges flip where that widens the smallest angle of their two triangles (Lawson 1977).
//
// Before it: collapse.h.  After it: slide.h; the two take turns.
#pragma once

#include "core/polygonize/working_mesh.h"

namespace seesaw {

/// Flips edges near `changed`, those of the worst triangles first, where the two triangles are not good as
/// they are and nearly in one plane. `changed` becomes the corners of the triangles that are new.
void flip_edges(WorkingMesh& work, VertexSet& changed);

}  // namespace seesaw
