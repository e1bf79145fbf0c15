#include "core/contour/crossings.h"

#include <algorithm>

#include "core/base/tolerances.h"

namespace seesaw {

Crossings::Crossings(Triangulation& triangulation, Sampler& sampler)
    : mesh_(triangulation),
      sampler_(sampler),
      tolerance_(std::max(0.1 * tolerance::on_curve * mesh_.lattice().extent, mesh_.lattice().grain)) {
  update(0);
}

void Crossings::update(int first) {
  Values values;
  sampler_.evaluate(mesh_.new_positions(), values);
  mesh_.set_new_values(values);

  struct Edge {
    int inside, outside;
  };
  std::vector<Edge> edges;
  const std::size_t known = crossings_.size();
  for (int t = first; t < mesh_.size(); ++t) {
    if (!mesh_.is_leaf(t) || !mesh_.is_mixed(t)) continue;
    for (int k = 0; k < 3; ++k) {
      int& mine = mesh_.triangle(t).crossing[static_cast<std::size_t>(k)];
      const auto [a, b] = mesh_.edge(t, k);
      if (mine >= 0 || mesh_.inside(a) == mesh_.inside(b)) continue;
      mine = static_cast<int>(known + edges.size());
      edges.push_back(mesh_.inside(a) ? Edge{a, b} : Edge{b, a});
      // The neighbor across an edge that changes sign is a mixed leaf, so it has been made.
      if (const int other = mesh_.triangle(t).neighbor[static_cast<std::size_t>(k)]; other >= 0)
        mesh_.triangle(other).crossing[static_cast<std::size_t>(mesh_.edge_toward(other, t))] = mine;
    }
  }

  const Index n = static_cast<Index>(edges.size());
  Points<2> inside(2, n), outside(2, n);
  Values inside_values(n), outside_values(n);
  for (Index i = 0; i < n; ++i) {
    const Edge& edge = edges[static_cast<std::size_t>(i)];
    inside.col(i) = mesh_.position(edge.inside);
    outside.col(i) = mesh_.position(edge.outside);
    inside_values[i] = mesh_.value(edge.inside);
    outside_values[i] = mesh_.value(edge.outside);
  }
  const Roots roots = find_roots(sampler_, inside, outside, inside_values, outside_values, tolerance_);
  for (Index i = 0; i < n; ++i) {
    Crossing crossing{roots.positions.col(i), roots.gradients.col(i)};
    crossing.edge_length = (outside.col(i) - inside.col(i)).norm();
    if (inside_values[i] == 0) crossing.corner = edges[static_cast<std::size_t>(i)].inside;
    // No zero within a thousandth of the edge by the gradient's own word: f jumps, and its gradient says
    // nothing about where the curve runs.
    if (std::abs(roots.values[i]) > 1e-3 * crossing.edge_length * crossing.gradient.norm())
      crossing.gradient.setZero();
    crossings_.push_back(crossing);
  }
}

Passage Crossings::passage(int t) const {
  const Triangle& triangle = mesh_.triangle(t);
  // The vertex that differs from the other two; the crossings lie on the two edges that meet there.
  const bool a = mesh_.inside(triangle.vertex[0]), b = mesh_.inside(triangle.vertex[1]),
             c = mesh_.inside(triangle.vertex[2]);
  const int odd = b == c ? 0 : a == c ? 1 : 2;
  const int after = (odd + 2) % 3, before = (odd + 1) % 3;  // The edges that leave `odd` and arrive at it.
  const bool odd_inside = odd == 0 ? a : odd == 1 ? b : c;
  // Around a lone inside vertex the curve turns left, counter-clockwise; around a lone outside one, right.
  const int entry = odd_inside ? after : before, exit = odd_inside ? before : after;
  return {triangle.crossing[static_cast<std::size_t>(entry)],
          triangle.crossing[static_cast<std::size_t>(exit)], entry, exit};
}

}  // namespace seesaw
