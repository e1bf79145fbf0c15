// Fewer vertices, the same shape: from a scan of 35,000 vertices to the 800 that a dense solve can take.
//
// Before it: a mesh, best closed and manifold.  After it: constraints (core/modelling), one or two a vertex.
//
// meshoptimizer's edge collapse by quadrics does the bulk. It counts faces, and it does not look after the
// topology: of the bunny's 34,835 vertices it makes 800 without damage, but pinches an edge on the way to
// 3,000. So each of its results is measured (mesh_check.h) and only one with the topology of the original is
// taken, if need be with more vertices than asked for, in the worst case the original. The vertices that are
// then too many are taken out one by one (edge_collapse.h), which never changes the topology: fast for the
// last few, tens of seconds for half a million. Of a closed surface with V vertices and Euler characteristic
// chi, F = 2 (V - chi).
#pragma once

#include "core/base/progress.h"
#include "core/mesh/triangle_mesh.h"

namespace seesaw {

/// `mesh` with exactly `vertices` vertices (at least 4), all of them vertices of `mesh` in their places and
/// order, with their normals if it has any. A manifold mesh keeps its components, Euler characteristic,
/// boundary loops and orientation; one that is not manifold has `vertices` or the nearest number below that
/// could be had. A mesh of no more than `vertices` comes back without its unused vertices, otherwise as it
/// is. Throws Error where the number cannot be had without damage, and says which number was reached;
/// Cancelled.
TriangleMesh simplify(const TriangleMesh& mesh, Index vertices, const Progress& progress = {});

}  // namespace seesaw
