// The lattice as triangles that can be bisected anywhere, any number of times, without ever leaving a gap.
//
// Before it: lattice.h.  After it: refine.h decides what to bisect; trace.h walks through what is left.
//
// Each cell is two right isosceles triangles. A triangle is bisected from its apex to the middle of its
// longest side, which gives two of the same shape; the neighbor across that side is bisected with it, and if
// that side is not the neighbor's longest, the neighbor is bisected first. That recursion ends, because each
// step goes to a larger triangle (Rivara 1984; Velho & Zorin 2001 call it the 4-8 mesh). So no vertex ever
// lies in the middle of a neighbor's edge, and a curve cannot end where fine meets coarse.
//
// Only cells that matter are made into triangles: those the curve passes, and what the recursion or a seed
// asks for.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/contour/lattice.h"

namespace seesaw {

/// Vertex 0 is the apex, counter-clockwise; edge k lies opposite vertex k, so edge 0 is the longest.
struct Triangle {
  std::array<int, 3> vertex;
  std::array<int, 3> neighbor;              ///< across edge k: a leaf, `box_side` or `not_made`
  std::array<int, 3> crossing{-1, -1, -1};  ///< on edge k: an index into the crossings of refine.h, or -1
  int child = -1;                           ///< children are child and child + 1; -1 for a leaf
  std::int16_t level = 0;                   ///< how many bisections made it
  std::int16_t turns_left = 0;              ///< how many bisections the angle tolerance may still ask for

  static constexpr int box_side = -1;
  static constexpr int not_made = -2;
};

class Triangulation {
 public:
  /// Keeps a reference to `lattice`, whose values are known. Makes the triangles of all cells with corners of
  /// both signs; each may be bisected `turns` times for the angle tolerance.
  Triangulation(const Lattice& lattice, int turns);

  const Lattice& lattice() const { return lattice_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  Triangle& triangle(int t) { return triangles_[static_cast<std::size_t>(t)]; }
  const Triangle& triangle(int t) const { return triangles_[static_cast<std::size_t>(t)]; }
  int size() const { return static_cast<int>(triangles_.size()); }
  bool is_leaf(int t) const { return triangle(t).child < 0; }

  /// Lattice coordinates and value of a vertex; lattice corners come first, in the lattice's order.
  Point<2> uv(int vertex) const;
  double value(int vertex) const;
  Point<2> position(int vertex) const { return lattice_.position(uv(vertex)); }
  bool inside(int vertex) const { return is_inside(value(vertex)); }
  /// True when the triangle's vertices are of both signs.
  bool is_mixed(int t) const;
  /// The vertices at the ends of edge k, counter-clockwise.
  std::array<int, 2> edge(int t, int k) const {
    const Triangle& triangle = this->triangle(t);
    return {triangle.vertex[static_cast<std::size_t>((k + 1) % 3)],
            triangle.vertex[static_cast<std::size_t>((k + 2) % 3)]};
  }
  /// Which edge of leaf `t` leads to its neighbor `other`.
  int edge_toward(int t, int other) const;

  /// Bisects leaf `t` and what must go with it. New vertices have no value until `set_new_values`.
  void bisect(int t);
  /// Vertices made beyond the lattice's corners.
  Index refined_vertices() const { return static_cast<Index>(refined_uv_.size()); }
  /// Scene positions of the vertices without a value, 2 x N, and where their values go, in the same order.
  Points<2> new_positions() const;
  void set_new_values(const Values& values);

  /// Leaves that come within `reach` of `uv`, both in lattice units (a little generous at corners). Only
  /// triangles that have been made are looked at; `make_around` makes those whose cells touch `uv`.
  void leaves_near(const Point<2>& uv, double reach, std::vector<int>& leaves) const;
  void make_around(const Point<2>& uv, double reach);

  /// The index of the cell's first triangle, the second follows; -1 when they are not made.
  int first_triangle(int i, int j) const { return cells_[cell_index(i, j)]; }
  /// visit(t, k) for every edge k of a leaf t that is part of one side of a made cell, in no particular
  /// order. side: 0 bottom, 1 right, 2 top, 3 left. Edges run counter-clockwise around the cell.
  template <class Visit>
  void for_each_edge_on_side(int i, int j, int side, Visit&& visit) const {
    const auto [t, k] = root_with_side(i, j, side);
    visit_edges(t, k, visit);
  }

 private:
  struct TriangleEdge {
    int triangle, edge;
  };
  std::size_t cell_index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(lattice_.nx) + static_cast<std::size_t>(i);
  }
  TriangleEdge root_with_side(int i, int j, int side) const;
  TriangleEdge leaf_with_side(int i, int j, int side) const;
  void make_cell(int i, int j);
  int neighbor_made(int t, int k);
  void split(int t, int middle);
  bool touches(const Triangle& triangle, const Point<2>& uv, double reach) const;

  template <class Visit>
  void visit_edges(int t, int k, Visit& visit) const {
    const Triangle& triangle = this->triangle(t);
    if (triangle.child < 0) return visit(t, k);
    // Where the three edges of a bisected triangle went: see `split`.
    if (k == 1) return visit_edges(triangle.child + 1, 0, visit);
    if (k == 2) return visit_edges(triangle.child, 0, visit);
    visit_edges(triangle.child, 1, visit);
    visit_edges(triangle.child + 1, 2, visit);
  }

  const Lattice& lattice_;
  int corners_;
  int turns_;
  std::vector<int> cells_;
  std::vector<Triangle> triangles_;
  std::vector<Point<2>> refined_uv_;
  std::vector<double> refined_values_;
};

}  // namespace seesaw
