// A torus of polygons, as a modeler would hand it over: the objects of Fig. 9 of Turk & O'Brien 2002.
//
// Before it: a place, a direction and two radii.
// After it: model_constraints.h makes constraints of its vertices; blend.h mixes several; renderers draw it.
#pragma once

#include "core/mesh/triangle_mesh.h"

namespace seesaw {

struct TorusShape {
  Point<3> center = Point<3>::Zero();
  /// The core circle is perpendicular to it; any length but zero.
  Point<3> axis = Point<3>::UnitZ();
  double major = 1.0;  ///< radius of the core circle
  double minor = 0.3;  ///< radius of the tube, 0 < minor < major
};

/// A closed mesh of around * across vertices *on* the torus and twice as many triangles, with the torus' own
/// normals; each row of vertices is turned by half a step, so the triangles are nearly equilateral where the
/// counts allow. `around` >= 3 steps along the core circle, `across` >= 3 around the tube.
TriangleMesh polygonal_torus(const TorusShape& shape, int around = 24, int across = 12);

}  // namespace seesaw
