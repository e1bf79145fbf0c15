// Inside core/raytrace: the lines along the edges of a polygon model.
//
// Before it: scene.h. After it: embree_geometry.cpp.
#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/triangle_mesh.h"
#include "core/raytrace/ray.h"

namespace seesaw {

/// One byte a face: bit k says that the edge from corner k to corner k + 1 is drawn. All are, but those
/// between two faces whose normals differ by less than `least_angle` degrees.
std::vector<std::uint8_t> edges_to_draw(const TriangleMesh& mesh, double least_angle);

/// Whether the ray, which meets the triangle abc at `place`, passes a drawn edge (bits as above) within
/// `reach`, a length across the ray in scene units.
bool on_drawn_edge(const Ray& ray, const Point<3>& place, const Point<3>& a, const Point<3>& b,
                   const Point<3>& c, std::uint8_t drawn, double reach);

}  // namespace seesaw
