// A mesh and its net of half-edges, which the moves change together.
//
// Before it: assemble.h.  After it: collapse.h, flip.h and slide.h, one kind of move each.
#pragma once

#include <vector>

#include "core/polygonize/assemble.h"
#include "core/polygonize/half_edges.h"

namespace seesaw {

/// A set of vertices.
class VertexSet {
 public:
  /// All vertices, or none.
  VertexSet(Index vertices, bool all) : flags_(static_cast<std::size_t>(vertices), all ? 1 : 0) {}
  bool has(int v) const { return flags_[static_cast<std::size_t>(v)] != 0; }
  void add(int v) { flags_[static_cast<std::size_t>(v)] = 1; }
  void remove(int v) { flags_[static_cast<std::size_t>(v)] = 0; }

 private:
  std::vector<char> flags_;
};

struct WorkingMesh {
  LatticeMesh& mesh;
  HalfEdges net;
  double cell;  ///< the side of a cube

  /// Keeps a reference to `mesh`.
  WorkingMesh(LatticeMesh& its_mesh, double its_cell)
      : mesh(its_mesh), net(its_mesh.faces, its_mesh.vertices()), cell(its_cell) {}

  Point<3> at(int v) const { return mesh.positions.col(v); }
  /// On a face of the lattice's range, or on the mesh's boundary.
  bool is_fixed(int v) const { return mesh.on_range[static_cast<std::size_t>(v)] != 0 || net.is_boundary(v); }
  /// For each face 1 where its quality (triangle_quality.h) is less than `quality`, else 0.
  std::vector<char> faces_below(double quality) const;
  /// Whether one of the two faces at the edge of h is among those marked.
  bool is_at(const std::vector<char>& faces, int h) const {
    const int t = net.twin(h);
    return faces[static_cast<std::size_t>(h / 3)] != 0 ||
           (t >= 0 && faces[static_cast<std::size_t>(t / 3)] != 0);
  }
  /// To call in the end: gives the mesh the faces of the net, without what has collapsed.
  void finish();
};

}  // namespace seesaw
