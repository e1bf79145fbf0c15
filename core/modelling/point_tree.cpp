#include "core/modelling/point_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace seesaw {

PointTree::PointTree(const std::vector<Point<3>>& points) : indices_(points.size()) {
  std::iota(indices_.begin(), indices_.end(), Index{0});
  if (!points.empty()) build(0, static_cast<Index>(points.size()), points);
  points_.reserve(points.size());
  for (const Index i : indices_) points_.push_back(points[slot(i)]);
}

void PointTree::build(Index begin, Index end, const std::vector<Point<3>>& points) {
  constexpr Index leaf = 8;
  const std::size_t self = nodes_.size();
  nodes_.push_back({{}, begin, end, -1});
  Box<3> box;
  for (Index i = begin; i < end; ++i) box.extend(points[slot(indices_[slot(i)])]);
  nodes_[self].box = box;
  if (end - begin <= leaf) return;
  int axis = 0;
  box.sizes().maxCoeff(&axis);
  const Index middle = begin + (end - begin) / 2;
  std::nth_element(indices_.begin() + begin, indices_.begin() + middle, indices_.begin() + end,
                   [&](Index i, Index j) {
                     const double a = points[slot(i)][axis], b = points[slot(j)][axis];
                     return a < b || (a == b && i < j);
                   });
  build(begin, middle, points);
  nodes_[self].right = static_cast<Index>(nodes_.size());
  build(middle, end, points);
}

PointTree::Nearest PointTree::nearest(const Point<3>& at, const Point<3>& reach) const {
  double best = infinity;
  Index which = -1;
  const auto squared = [&](const Point<3>& away) {
    return (away.cwiseAbs() - reach).cwiseMax(0).squaredNorm();
  };
  const auto to_box = [&](Index node) {
    const Box<3>& box = nodes_[slot(node)].box;
    return squared((box.min() - at).cwiseMax(at - box.max()).cwiseMax(0));
  };
  const auto search = [&](const auto& self, Index node) -> void {
    const Node& here = nodes_[slot(node)];
    if (here.right < 0) {
      for (Index i = here.begin; i < here.end; ++i) {
        const double its = squared(points_[slot(i)] - at);
        if (its < best || (its == best && indices_[slot(i)] < which)) best = its, which = indices_[slot(i)];
      }
      return;
    }
    const Index halves[2] = {node + 1, here.right};
    const double away[2] = {to_box(halves[0]), to_box(halves[1])};
    const int first = away[1] < away[0] ? 1 : 0;
    for (const int k : {first, 1 - first})
      if (away[k] <= best) self(self, halves[k]);
  };
  if (!nodes_.empty()) search(search, 0);
  return {which, std::sqrt(best)};
}

}  // namespace seesaw
