// What there is to know about a mesh: is it closed, manifold and oriented, of how many pieces, how large, and
// how good are its triangles?
//
// Before it: a mesh from a file or from a polygonizer.  After it: a report for people, or a test.
//
// With V vertices in use, E edges and F faces the Euler characteristic is chi = V - E + F. A closed,
// connected, oriented surface of genus g has chi = 2 - 2 g; of C such pieces together the genera add up to C
// - chi / 2. The volume of a closed mesh is the sum of the signed volumes of the tetrahedra between each face
// and one point (the divergence theorem for the field x / 3):
//
//     volume = 1/6 sum over faces  a . (b x c)
//
// Two faces are connected when they share a vertex (by its index: weld first). Faces that name a vertex twice
// have no place in the topology; they are counted and otherwise left out.
#pragma once

#include "core/mesh/triangle_mesh.h"

namespace seesaw {

struct MeshReport {
  Index vertices = 0;  ///< all of them, also those in no face
  Index faces = 0;     ///< all of them, also degenerate ones
  Index edges = 0;
  Index components = 0;

  bool closed = false;    ///< there are faces, and every edge has an even number of them
  bool manifold = false;  ///< no edge has more than two faces, and around every vertex runs a single fan
  bool oriented =
      false;  ///< across every edge, as many faces run one way as the other (on a boundary: one more)

  Index euler_characteristic = 0;  ///< V - E + F without the vertices in no face
  /// The sum over all components; -1 where the mesh is not closed, manifold and oriented.
  Index genus = -1;

  Index boundary_edges = 0;        ///< edges with one face: 0 is watertight
  Index boundary_loops = 0;        ///< closed chains of them, walked along the surface: one a hole
  Index nonmanifold_edges = 0;     ///< edges with three faces or more
  Index nonmanifold_vertices = 0;  ///< vertices where several fans of faces meet only in the point
  Index misoriented_edges = 0;     ///< edges that break `oriented`
  Index degenerate_faces = 0;      ///< faces of no area: a vertex named twice, or three on one line
  Index unused_vertices = 0;       ///< vertices in no face

  double area = 0;            ///< squared scene units
  double volume = 0;          ///< cubed scene units, negative for inside out; NaN unless closed and oriented
  double smallest_angle = 0;  ///< of all corners of all faces, degrees; 0 for no faces
  double largest_angle = 0;   ///< likewise
  Box<3> box;                 ///< around the vertices in use; empty for none
};

/// Measures `mesh`, whose vertices must be finite and whose indices in range (a programmer's mistake if not:
/// mesh_file.h and the polygonizer see to it). About 0.5 s for a million faces.
MeshReport check_mesh(const TriangleMesh& mesh);

}  // namespace seesaw
