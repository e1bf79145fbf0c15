// A direction for every vertex of a mesh, from the faces around it.
//
// Before it: a mesh whose faces run counter-clockwise seen from outside.
// After it: normal constraints (core/modelling), smooth shading (core/raytrace), files.
//
// The faces' unit normals are added with the angle of the face at the vertex as weight (Thuermer and
// Wuethrich 1998), so that the answer depends on the shape and not on how it is cut into triangles: a cube's
// corner looks along the diagonal, however its squares are split.
#pragma once

#include "core/mesh/triangle_mesh.h"

namespace seesaw {

/// Outward unit normals of `mesh`, 3 x V. A zero column says "not known": a vertex in no face, or one whose
/// faces cancel (the two sides of a sheet). Faces of no area count for nothing.
Points<3> vertex_normals(const TriangleMesh& mesh);

}  // namespace seesaw
