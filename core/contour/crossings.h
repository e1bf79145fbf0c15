// Where the curve crosses the edges of the triangulation, and its one way through each triangle.
//
// Before it: triangulation.h says which edges change sign, roots.h where on them.
// After it: refine.h judges the pieces; trace.h strings them together.
//
// A triangle whose vertices are not all of one sign has two edges with a crossing, never one or three. So the
// curve enters by one, leaves by the other, and the triangle next door continues it: closed loops, or ends on
// the box.
#pragma once

#include <vector>

#include "core/contour/roots.h"
#include "core/contour/triangulation.h"

namespace seesaw {

struct Crossing {
  Point<2> position;
  /// grad f there. Zero where it does not exist, and where f jumps across zero instead of passing through it.
  Point<2> gradient;
  /// The vertex on which the crossing lies because f is exactly zero there; -1 for an ordinary crossing.
  int corner = -1;
  /// Length of its edge, in scene units: how coarse the triangulation is here.
  double edge_length = 0;
};

/// The way through a mixed leaf, inside on its left.
struct Passage {
  int from, to;               ///< crossings
  int entry_edge, exit_edge;  ///< edges of the triangle they lie on
};

class Crossings {
 public:
  /// Keeps references. Finds the crossings of all leaves made so far.
  Crossings(Triangulation& triangulation, Sampler& sampler);

  /// Evaluates f at new vertices and finds the crossings of the leaves among triangles `first`, `first` + 1,
  /// ...
  void update(int first);

  Triangulation& mesh() { return mesh_; }
  const Triangulation& mesh() const { return mesh_; }
  Sampler& sampler() { return sampler_; }
  const Crossing& operator[](int k) const { return crossings_[static_cast<std::size_t>(k)]; }
  /// How near the zero set a crossing is sought, in scene units.
  double tolerance() const { return tolerance_; }

  /// `t` is a mixed leaf.
  Passage passage(int t) const;
  /// The leaf in which the curve goes on after (before) leaf `t`, or -1 where it meets the box.
  int after(int t) const { return next(t, passage(t).exit_edge); }
  int before(int t) const { return next(t, passage(t).entry_edge); }
  /// True when the passage has no length because both its ends are the same zero corner.
  bool is_point(const Passage& passage) const {
    const int corner = (*this)[passage.from].corner;
    return passage.from == passage.to || (corner >= 0 && corner == (*this)[passage.to].corner);
  }

 private:
  int next(int t, int edge) const { return mesh_.triangle(t).neighbor[static_cast<std::size_t>(edge)]; }

  Triangulation& mesh_;
  Sampler& sampler_;
  double tolerance_;
  std::vector<Crossing> crossings_;
};

}  // namespace seesaw
