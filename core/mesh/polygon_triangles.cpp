#include "core/mesh/polygon_triangles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "core/mesh/predicates.h"

namespace seesaw {

namespace {

// Corners by the cell of a lattice they lie in, so that those near a triangle are found without asking all.
class CornerGrid {
 public:
  // About one corner a cell for `count` corners spread over `box`.
  CornerGrid(const Box<2>& box, std::size_t count)
      : box_(box), side_(std::clamp(static_cast<int>(std::sqrt(static_cast<double>(count))), 1, 2000)) {
    cells_.resize(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_));
  }
  void add(int corner, const Point<2>& p) { cells_[cell(column(p, 0), column(p, 1))].push_back(corner); }

  /// Does `fits(corner)` hold for any corner in the cells that the box from `low` to `high` touches?
  template <class Fits>
  bool any(const Point<2>& low, const Point<2>& high, Fits&& fits) const {
    for (int i = column(low, 0); i <= column(high, 0); ++i)
      for (int j = column(low, 1); j <= column(high, 1); ++j)
        for (const int corner : cells_[cell(i, j)])
          if (fits(corner)) return true;
    return false;
  }

 private:
  int column(const Point<2>& p, int axis) const {
    const double length = box_.max()[axis] - box_.min()[axis];
    if (!(length > 0)) return 0;
    return std::clamp(static_cast<int>((p[axis] - box_.min()[axis]) / length * side_), 0, side_ - 1);
  }
  std::size_t cell(int i, int j) const {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(side_) + static_cast<std::size_t>(j);
  }

  Box<2> box_;
  int side_;
  std::vector<std::vector<int>> cells_;
};

// The ring of corners that are left, with each corner's turn.
class Ring {
 public:
  Ring(const Eigen::Ref<const Points<3>>& points, std::span<const int> polygon) : polygon_(polygon) {
    const std::size_t n = polygon.size();
    const auto at = [&](std::size_t i) -> Point<3> { return points.col(polygon[i % n]); };
    Point<3> normal = Point<3>::Zero();
    for (std::size_t i = 1; i + 1 < n; ++i) normal += (at(i) - at(0)).cross(at(i + 1) - at(0));
    Index axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    // Seen from where the normal points: then the polygon runs counter-clockwise.
    const Index u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (std::size_t i = 0; i < n; ++i) {
      const Point<3> p = at(i);
      flat_.push_back(normal[axis] < 0 ? Point<2>(p[v], p[u]) : Point<2>(p[u], p[v]));
      space_.push_back(p);
      before_.push_back(static_cast<int>(i + n - 1) % static_cast<int>(n));
      after_.push_back(static_cast<int>(i + 1) % static_cast<int>(n));
    }
    std::size_t in_the_way = 0;
    Box<2> box;
    for (std::size_t i = 0; i < n; ++i) {
      turn_.push_back(measured_turn(static_cast<int>(i)));
      in_the_way += turn_.back() <= 0;
      box.extend(flat_[i]);
    }
    grid_.emplace(box, in_the_way);
    for (std::size_t i = 0; i < n; ++i)
      if (turn_[i] <= 0) grid_->add(static_cast<int>(i), flat_[i]);
  }

  int before(int i) const { return before_[slot(i)]; }
  int after(int i) const { return after_[slot(i)]; }

  bool is_ear(int i) const {
    if (turn_[slot(i)] <= 0) return false;
    const int a = before(i), b = after(i);
    const Point<2>&pa = flat_[slot(a)], &pi = flat_[slot(i)], &pb = flat_[slot(b)];
    // Only a corner that does not turn left can be the first to stand in the way.
    return !grid_->any(pa.cwiseMin(pi).cwiseMin(pb), pa.cwiseMax(pi).cwiseMax(pb), [&](int j) {
      if (turn_[slot(j)] > 0) return false;
      const Point<2>& p = flat_[slot(j)];
      // Where a hole was joined to the rim by a double edge, one place is several corners.
      if (p == pa || p == pi || p == pb) return false;
      return side_of_line(pa, pi, p) >= 0 && side_of_line(pi, pb, p) >= 0 && side_of_line(pb, pa, p) >= 0;
    });
  }

  void cut(int i, std::vector<std::array<int, 3>>& triangles) {
    const int a = before(i), b = after(i);
    triangles.push_back({polygon_[slot(a)], polygon_[slot(i)], polygon_[slot(b)]});
    after_[slot(a)] = b;
    before_[slot(b)] = a;
    turn_[slot(i)] = 1;  // no longer in anybody's way
    for (const int corner : {a, b}) {
      const int old = turn_[slot(corner)];
      turn_[slot(corner)] = measured_turn(corner);
      // Only where the polygon crosses itself.
      if (old > 0 && turn_[slot(corner)] <= 0) grid_->add(corner, flat_[slot(corner)]);
    }
  }

  bool turns_right(int i) const { return turn_[slot(i)] < 0; }

  double diagonal(int i) const { return (space_[slot(before(i))] - space_[slot(after(i))]).squaredNorm(); }

 private:
  int measured_turn(int i) const {
    return side_of_line(flat_[slot(before(i))], flat_[slot(i)], flat_[slot(after(i))]);
  }

  std::span<const int> polygon_;
  std::vector<Point<2>> flat_;
  std::vector<Point<3>> space_;
  std::vector<int> before_, after_, turn_;
  std::optional<CornerGrid> grid_;  // of the corners that do not turn left
};

}  // namespace

bool cut_polygon(const Eigen::Ref<const Points<3>>& points, std::span<const int> polygon,
                 std::vector<std::array<int, 3>>& triangles) {
  if (polygon.size() == 3) {
    triangles.push_back({polygon[0], polygon[1], polygon[2]});
    return true;
  }
  Ring ring(points, polygon);
  bool simple = true;
  int here = 0;
  for (std::size_t left = polygon.size(); left > 3; --left) {
    if (left == 4 && ring.is_ear(ring.after(here)) && ring.diagonal(ring.after(here)) < ring.diagonal(here))
      here = ring.after(here);
    std::size_t tried = 0;
    while (tried < left && !ring.is_ear(here)) {
      here = ring.after(here);
      ++tried;
    }
    simple = simple && tried < left;
    const int next = ring.after(here);
    ring.cut(here, triangles);
    // Not the neighbor, where there is a choice: ears cut in turn all around make better triangles than a
    // fan.
    here = ring.after(next);
  }
  const int a = ring.before(here), b = ring.after(here);
  triangles.push_back({polygon[static_cast<std::size_t>(a)], polygon[static_cast<std::size_t>(here)],
                       polygon[static_cast<std::size_t>(b)]});
  // What is left over of a polygon that crosses itself runs the wrong way.
  return simple && !ring.turns_right(here);
}

}  // namespace seesaw
