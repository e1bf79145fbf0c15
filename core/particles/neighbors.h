// Who is near whom, when everybody reaches a different distance.
//
// Before it: floaters' positions and how far each one's influence goes.
// After it: repulsion.h, which adds up pairs; measures.h and integrals.h, which look for the nearest.
//
// Witkin & Heckbert 1994, section 5: "Above r = 250 floaters, the O(r^2) repulsion cost has dominated, but
// this could easily be optimized using spatial data structures." Adaptive repulsion makes it less easy: a
// pair interacts when *either* one reaches the other, and while a surface fills up, pioneers reach across all
// of it past thousands that reach no farther than their neighbors. A plain grid must choose one cell size and
// is wrong for one of them.
//
// So: floaters are sorted by the octave of their reach first and along a Morton (Z-shaped) curve second, and
// cut into leaves of 16. Over the leaves stands a binary tree whose nodes know a box and the farthest reach
// in it. A leaf asks the tree once for all its members: a node whose box is farther from the leaf's than both
// farthest reaches holds no partner. Pioneers share leaves with pioneers only, and so spoil nobody's search.
// Sorting is O(n log n) with a small constant, everything else linear where reaches are of the size of the
// spacing.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/base/types.h"

namespace seesaw {

class Neighbors {
 public:
  /// `positions` 3 x N and finite; `reaches` N, >= 0, scene units.
  Neighbors(const PointsRef<3>& positions, const Eigen::Ref<const Values>& reaches);

  /// For every leaf, from many threads: `work(members, candidates)`, indices of floaters both. Every floater
  /// is a member once. Whoever lies within max(reach_i, reach_j) of some member i is among the candidates, i
  /// itself included, and so are others that lie not quite so near. Both lists, and their order, are the same
  /// on every number of threads.
  void for_each_leaf(
      const std::function<void(std::span<const int> members, std::span<const int> candidates)>& work) const;

  /// The squared distance from `point` to the nearest floater but `but` (-1: of all), for which `accept` (if
  /// any) holds; infinite where there is none. Logarithmic.
  double nearest_squared(const Point<3>& point, Index but = -1,
                         const std::function<bool(int)>& accept = {}) const;

  Index size() const { return static_cast<Index>(order_.size()); }

 private:
  struct Node {
    Box<3> box;
    double reach = 0;
  };
  // Level 0 are the leaves; node k of a level has the children 2k and 2k + 1 of the level below.
  void build();
  std::span<const int> members(std::size_t leaf) const;

  Points<3> positions_;
  Values reaches_;
  std::vector<int> order_;
  std::vector<std::vector<Node>> levels_;
};

}  // namespace seesaw
