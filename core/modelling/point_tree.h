// Which of many boxes of one size is nearest to another box?
//
// Before it: the middles of the boxes.  After it: clearance.cpp asks for each box of the other surface.
//
// Boxes of half sides h whose middles are d apart are max(|d| - h - h', 0) apart, axis by axis: a distance of
// the middles alone, so a tree of points serves. They are halved at the median along the longest side of the
// box around them, until eight are left; the search opens the nearer half first and drops a half that cannot
// beat what is known.
#pragma once

#include <vector>

#include "core/base/types.h"

namespace seesaw {

class PointTree {
 public:
  /// Of N >= 0 points, which are copied. O(N log N).
  explicit PointTree(const std::vector<Point<3>>& points);

  struct Nearest {
    Index index = -1;  ///< -1: there are no points
    double distance = infinity;
  };
  /// The point with the smallest |max(|point - at| - reach, 0)|, `reach` >= 0; of equally near ones the one
  /// with the lowest index. About log N points.
  Nearest nearest(const Point<3>& at, const Point<3>& reach) const;

 private:
  struct Node {
    Box<3> box;
    Index begin = 0, end = 0;  // of points_ and indices_
    Index right = -1;          // the second half, or -1 in a leaf; the first stands next to its parent
  };
  void build(Index begin, Index end, const std::vector<Point<3>>& points);

  std::vector<Point<3>> points_;  // in the tree's order
  std::vector<Index> indices_;
  std::vector<Node> nodes_;
};

}  // namespace seesaw
