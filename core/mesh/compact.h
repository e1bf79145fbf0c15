// A mesh without the vertices that no face uses.
//
// Before it: somebody who took faces away (simplify.h, edge_collapse.h).  After it: a mesh like any other.
#pragma once

#include "core/mesh/triangle_mesh.h"

namespace seesaw {

/// The vertices of `mesh` that `faces` (3 x F, over those vertices) use, in their order, with their normals.
TriangleMesh with_faces(const TriangleMesh& mesh, const Faces& faces);

}  // namespace seesaw
