// Polygons as scanners and modelers leave them become a mesh one can compute with, and every change is
// counted.
//
// Before it: a PolygonSoup (mesh_readers.h), or a TriangleMesh of doubtful origin.
// After it: mesh_check.h says what is still wrong: holes are not filled, and what is not manifold stays so.
//
// In this order:
//
//     weld         vertices with exactly equal coordinates become one (not where the faces as they are make a
//                  closed manifold which that would spoil: two cubes that touch along an edge)
//     cut          polygons become triangles (polygon_triangles.h)
//     drop         faces that name a vertex twice, and faces that are there twice, in whatever direction
//     straighten   a face whose corners lie exactly on one line is joined with its neighbor across the
//     longest side,
//                  which is then cut from the middle corner: the surface stays as closed as it was
//     orient       neighbors agree, what is inside out is turned (orientation.h)
//     drop         vertices in no face
//
// What is kept keeps its order.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/mesh/polygon_soup.h"
#include "core/mesh/triangle_mesh.h"

namespace seesaw {

struct MeshRepairs {
  Index welded_vertices = 0;    ///< vertices that became another one with equal coordinates
  Index unused_vertices = 0;    ///< vertices in no face, dropped
  Index degenerate_faces = 0;   ///< faces of no area, dropped or joined with a neighbor
  Index duplicate_faces = 0;    ///< faces with the same vertices as an earlier one, dropped
  Index crossing_polygons = 0;  ///< polygons whose outline crosses itself, cut somehow
  Index lines_and_points = 0;   ///< elements of a file that are no faces, dropped
  Index turned_faces = 0;       ///< faces turned to agree with their neighbors
  Index turned_shells = 0;      ///< closed pieces that were inside out, turned
  Index one_sided = 0;          ///< pieces that no turning makes consistent, left as they are

  /// Was anything found?
  bool any() const;
  /// All of them by name, in the order above.
  std::vector<std::pair<std::string, Index>> named() const;
  /// One phrase for each that is not 0: "12 vertices welded to others with equal coordinates".
  std::vector<std::string> in_words() const;
};

struct LoadedMesh {
  TriangleMesh mesh;
  MeshRepairs repairs;
};

struct RepairOptions {
  bool weld = true;    ///< make vertices with equal coordinates one
  bool orient = true;  ///< turn faces, and closed pieces that are inside out
};

/// The mesh of `soup`, which must be finite and in range. Normals are kept where every vertex in use has one,
/// no face was turned, and they look to the same side as the faces; otherwise the mesh has none. Throws Error
/// for more than 715 million triangles.
LoadedMesh repair(const PolygonSoup& soup, const RepairOptions& options = {});

/// The same of a mesh.
LoadedMesh repair(const TriangleMesh& mesh, const RepairOptions& options = {});

}  // namespace seesaw
