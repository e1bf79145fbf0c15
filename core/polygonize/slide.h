// Vertices slide in their tangent plane toward the middle of their neighbors, and are pulled back onto f = 0
// by one Newton step.
//
// Before it: flip.h; the two take turns.  After it: project.h, which is exact.
//
// All of them slide at once, on all cores. Then those whose triangles are the worse for it go back. That
// changes their neighbors' triangles, so these are asked again, until everybody is content: then no triangle
// is worse than 30 degrees, or than the worst was around one of its corners, and none has turned over.
#pragma once

#include "core/polygonize/sampler.h"
#include "core/polygonize/working_mesh.h"

namespace seesaw {

/// Slides the corners of triangles that are not good as they are, but those on the boundary and on the faces
/// of the lattice's range.
void slide_vertices(WorkingMesh& work, Sampler& sampler);

}  // namespace seesaw
