// A triangle mesh as a net of half-edges that can be changed without tearing it.
//
// Before it: the faces of an oriented manifold, with or without boundary.  After it: working_mesh.h.
//
// Half-edge h = 3 f + k leads from corner k of face f to the next; its twin is the same edge seen from the
// other face, -1 on the boundary. Two changes, each of which keeps an oriented manifold one, of the same
// topology: an edge collapses to one of its ends when the ends have no common neighbors but the two that
// complete the faces at the edge (the link condition; Dey, Edelsbrunner, Guha & Nekhayev 1999); an edge flips
// when the other diagonal is not yet there.
#pragma once

#include <vector>

#include "core/mesh/triangle_mesh.h"

namespace seesaw {

class HalfEdges {
 public:
  HalfEdges(const Faces& faces, Index vertices);

  static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int previous(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
  int size() const { return static_cast<int>(origin_.size()); }
  /// Also those without faces.
  Index vertices() const { return static_cast<Index>(leaving_.size()); }
  /// False for the half-edges of faces that have collapsed.
  bool is_alive(int h) const { return origin_[slot(h)] >= 0; }
  int origin(int h) const { return origin_[slot(h)]; }
  int target(int h) const { return origin_[slot(next(h))]; }
  int twin(int h) const { return twin_[slot(h)]; }
  /// A half-edge that leaves v, -1 for a vertex without faces; on the boundary the first one, without a twin.
  int leaving(int v) const { return leaving_[slot(v)]; }
  bool is_boundary(int v) const { return leaving(v) < 0 || twin(leaving(v)) < 0; }

  /// Whether test(h) is true for a half-edge that leaves v; asks no further then.
  template <class Test>
  bool any_leaving(int v, Test&& test) const {
    const int first = leaving(v);
    for (int h = first; h >= 0;) {
      if (test(h)) return true;
      h = twin(previous(h));
      if (h == first) break;
    }
    return false;
  }

  /// visit(h) for the half-edges that leave v, counter-clockwise.
  template <class Visit>
  void for_each_leaving(int v, Visit&& visit) const {
    any_leaving(v, [&](int h) {
      visit(h);
      return false;
    });
  }

  /// Whether the edge may collapse into the origin of h: its target is not on the boundary, or the edge
  /// itself is a boundary edge, seen from its only face; and the link condition holds.
  bool can_collapse(int h) const;
  /// The target of h becomes the origin of h.
  void collapse(int h);
  /// Whether the other diagonal may replace the edge.
  bool can_flip(int h) const;
  /// h then leads from the vertex opposite the edge in its twin's face to the one opposite in its own.
  void flip(int h);

  /// The faces that are left, in their old order and old numbers of vertices.
  Faces faces() const;

 private:
  bool are_neighbors(int a, int b) const;
  bool keeps_three(int v) const;
  void join(int g, int h);

  std::vector<int> origin_, twin_, leaving_;
  std::vector<int> moved_;  // of the collapse that is going on
};

}  // namespace seesaw
