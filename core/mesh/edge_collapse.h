// Takes vertices out of a mesh one by one and never damages its topology.
//
// Before it: a mesh that is manifold.  After it: simplify.h, which wants an exact number of vertices.
//
// An edge from u to v is collapsed into v, which stays where it is. The price is what Garland and Heckbert
// (1997) ask: the sum of squared distances from v to the planes of all faces that u and v have stood for so
// far, weighted by area; cheap edges go first. A collapse is refused if it would
//
//     change the topology    the neighbors that u and v have in common must be just the tips of the edge's
//     own faces
//                            (the link condition, Dey et al. 1999); on a boundary only boundary edges
//                            collapse
//     turn a face over       every face that moves keeps a normal within 78 degrees of its old one
#pragma once

#include "core/base/progress.h"
#include "core/mesh/triangle_mesh.h"

namespace seesaw {

/// `mesh`, which must be manifold, with `vertices` vertices, or as few above that as the rules allow.
/// Vertices that stay keep their places, normals and order. O(V log V). Throws Cancelled.
TriangleMesh collapse_edges(const TriangleMesh& mesh, Index vertices, const Progress& progress = {});

}  // namespace seesaw
