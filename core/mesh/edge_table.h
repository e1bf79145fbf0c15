// Which faces meet at which edge: the one table that every question about a mesh's topology starts from.
//
// Before it: the faces of a TriangleMesh, in any state: open, non-manifold, inconsistently oriented.
// After it: mesh_check.h counts with it, mesh_repair.h walks across edges with it.
//
// A half-edge is one side of one face. Half-edge h = 3 f + k belongs to face f and runs from vertex
// faces(k, f) to vertex faces((k + 1) % 3, f). All half-edges between the same two vertices, in either
// direction, are one edge. A face that names a vertex twice has no area and no proper edges: it is left out.
#pragma once

#include <span>
#include <vector>

#include "core/mesh/triangle_mesh.h"

namespace seesaw {

class EdgeTable {
 public:
  /// Of `faces` (3 x F) over `vertices` vertices; every index must be in 0 .. vertices - 1. O(F) but for the
  /// sorting around each vertex. The table keeps no reference to `faces`.
  EdgeTable(const Faces& faces, Index vertices);

  /// Number of edges.
  Index edges() const { return static_cast<Index>(ends_.size()); }

  /// The edge's vertices, a < b.
  struct Ends {
    int a, b;
  };
  Ends ends(Index edge) const { return ends_[static_cast<std::size_t>(edge)]; }

  /// The half-edges of the edge, in increasing order: one on a boundary, two where the mesh is manifold.
  std::span<const int> halves(Index edge) const {
    const auto begin = static_cast<std::size_t>(first_[static_cast<std::size_t>(edge)]);
    const auto end = static_cast<std::size_t>(first_[static_cast<std::size_t>(edge) + 1]);
    return {halves_.data() + begin, end - begin};
  }

  /// The edge of half-edge 3 f + k, or -1 where face f names a vertex twice.
  int edge_of(Index half) const { return edge_of_[static_cast<std::size_t>(half)]; }

  /// The edge between vertices a and b, or -1. O(log E).
  Index find(int a, int b) const;

  /// Does face f name a vertex twice?
  bool skipped(Index face) const { return edge_of(3 * face) < 0; }

 private:
  std::vector<Ends> ends_;
  std::vector<int> first_;  // of each edge in halves_, and one past the last
  std::vector<int> halves_;
  std::vector<int> edge_of_;
};

/// Where half-edge `half` starts and ends.
inline int start_of(const Faces& faces, Index half) { return faces(half % 3, half / 3); }
inline int end_of(const Faces& faces, Index half) { return faces((half + 1) % 3, half / 3); }

/// Sets of 0 .. n - 1 that grow together (union by the smaller number, path halving): near O(1) an operation.
class DisjointSets {
 public:
  explicit DisjointSets(Index n);
  /// The set's smallest member.
  int find(Index i);
  void unite(Index i, Index j);

 private:
  std::vector<int> parent_;
};

}  // namespace seesaw
