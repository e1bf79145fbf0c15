#include "core/mesh/polygon_triangles.h"

#include <cstddef>

#include "core/mesh/predicates.h"

namespace seesaw {

namespace {

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
    for (std::size_t i = 0; i < n; ++i) turn_.push_back(measured_turn(static_cast<int>(i)));
  }

  int before(int i) const { return before_[at(i)]; }
  int after(int i) const { return after_[at(i)]; }

  bool is_ear(int i) const {
    if (turn_[at(i)] <= 0) return false;
    const int a = before(i), b = after(i);
    for (int j = after(b); j != a; j = after(j)) {
      // Only a corner that does not turn left can be the first to stand in the way.
      if (turn_[at(j)] > 0) continue;
      const Point<2>& p = flat_[at(j)];
      // Where a hole was joined to the rim by a double edge, one place is several corners.
      if (p == flat_[at(a)] || p == flat_[at(i)] || p == flat_[at(b)]) continue;
      if (side_of_line(flat_[at(a)], flat_[at(i)], p) >= 0 &&
          side_of_line(flat_[at(i)], flat_[at(b)], p) >= 0 &&
          side_of_line(flat_[at(b)], flat_[at(a)], p) >= 0)
        return false;
    }
    return true;
  }

  void cut(int i, std::vector<std::array<int, 3>>& triangles) {
    const int a = before(i), b = after(i);
    triangles.push_back({polygon_[at(a)], polygon_[at(i)], polygon_[at(b)]});
    after_[at(a)] = b;
    before_[at(b)] = a;
    turn_[at(a)] = measured_turn(a);
    turn_[at(b)] = measured_turn(b);
  }

  bool turns_right(int i) const { return turn_[at(i)] < 0; }

  double diagonal(int i) const { return (space_[at(before(i))] - space_[at(after(i))]).squaredNorm(); }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  int measured_turn(int i) const {
    return side_of_line(flat_[at(before(i))], flat_[at(i)], flat_[at(after(i))]);
  }

  std::span<const int> polygon_;
  std::vector<Point<2>> flat_;
  std::vector<Point<3>> space_;
  std::vector<int> before_, after_, turn_;
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
