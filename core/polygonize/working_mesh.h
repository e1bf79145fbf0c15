// A mesh and its net of half-edges, which the moves change together.
//
// Before it: assemble.h.  After it: collapse.h, flip.h and slide.h, one kind of move each.
#pragma once

#include <algorithm>
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
  /// Of each face (triangle_quality.h); 1, better than any, for those that have collapsed. Who makes a move
  /// calls `renew` for the faces that have changed.
  std::vector<double> quality;

  /// Keeps a reference to `its_mesh`.
  WorkingMesh(LatticeMesh& its_mesh, double its_cell);

  Point<3> at(int v) const { return mesh.positions.col(v); }
  /// On a face of the lattice's range, or on the mesh's boundary.
  bool is_fixed(int v) const { return mesh.on_range[static_cast<std::size_t>(v)] != 0 || net.is_boundary(v); }

  /// The quality of the face of h.
  double quality_at(int h) const { return quality[static_cast<std::size_t>(h / 3)]; }
  /// Of the worse of the two faces at the edge of h.
  double worse_at(int h) const {
    const int t = net.twin(h);
    return t < 0 ? quality_at(h) : std::min(quality_at(h), quality_at(t));
  }
  /// Of the worst face around v.
  double worst_around(int v) const;
  void renew(int face);
  void renew_all();

  /// To call in the end: gives the mesh the faces of the net, without what has collapsed.
  void finish();
};

}  // namespace seesaw
