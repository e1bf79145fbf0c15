// From crossed cubes to one mesh: a vertex on every lattice edge that changes sign, shared by all its cubes.
//
// Before it: continuation.h or scan.h.  After it: seeds.h looks at it, improve.h makes it fit to be seen.
#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/triangle_mesh.h"
#include "core/polygonize/continuation.h"

namespace seesaw {

/// A mesh whose vertices still know their lattice edges.
struct LatticeMesh {
  Points<3> positions;        ///< 3 x V
  Faces faces = Faces(3, 0);  ///< 3 x F
  Points<3> inside, outside;  ///< 3 x V: the ends of each vertex' lattice edge
  Values inside_values, outside_values;
  /// Bit d: the vertex lies on a face of the lattice's range across direction d, and must stay there.
  std::vector<std::uint8_t> on_range;
  /// Cube c made the faces cube_start[c] .. cube_start[c + 1] - 1; empty once faces have been changed.
  std::vector<int> cube_start;

  Index vertices() const { return positions.cols(); }
  /// A vertex that stands exactly on a lattice corner, because f is exactly zero there.
  bool is_exact_zero(Index v) const { return inside_values[v] == 0; }
  /// Makes vertex `to` what vertex `from` is.
  void copy_vertex(Index from, Index to);
};

/// Roots are found to `tolerance` scene units. Vertices are numbered by the first cube that has them.
LatticeMesh assemble(const Lattice& lattice, const CrossedCubes& found, Sampler& sampler, double tolerance);

/// A number for each vertex, the same exactly for those that hang together; returns how many there are.
Index components_of(const Faces& faces, Index vertices, std::vector<int>& component);

/// Keeps the faces for which keep[f], and the vertices that these use.
void keep_faces(LatticeMesh& mesh, const std::vector<bool>& keep);

}  // namespace seesaw
