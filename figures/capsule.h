// A limb as a modeler would build it: a cylinder with round ends, of polygons.
#pragma once

#include "core/mesh/triangle_mesh.h"

namespace seesaw {

/// A closed mesh of the points within `radius` of the segment from..to (different points), with its own
/// normals. `around` >= 3 vertices in a ring; along the cylinder, rings stand about as far apart as a ring's
/// vertices.
TriangleMesh capsule_mesh(const Point<3>& from, const Point<3>& to, double radius, int around = 14);

}  // namespace seesaw
