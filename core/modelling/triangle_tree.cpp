#include "core/modelling/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace seesaw {

namespace {

constexpr int leaf_size = 4;

Point<3> nearest_in_segment(const Point<3>& point, const Point<3>& a, const Point<3>& b) {
  const Point<3> along = b - a;
  const double square = along.squaredNorm();
  if (!(square > 0)) return a;
  return a + std::clamp((point - a).dot(along) / square, 0.0, 1.0) * along;
}

// Where the ray enters the box, or infinity; a ray within it enters at 0.
double entry(const Box<3>& box, const Point<3>& origin, const Point<3>& direction) {
  double enter = 0, leave = infinity;
  for (int d = 0; d < 3; ++d) {
    if (direction[d] == 0) {
      if (origin[d] < box.min()[d] || origin[d] > box.max()[d]) return infinity;
      continue;
    }
    double near = (box.min()[d] - origin[d]) / direction[d];
    double far = (box.max()[d] - origin[d]) / direction[d];
    if (near > far) std::swap(near, far);
    enter = std::max(enter, near);
    leave = std::min(leave, far);
  }
  // A flat box has no thickness to be hit in: leave room for rounding.
  return enter <= leave * (1 + 1e-12) + 1e-300 ? enter : infinity;
}

}  // namespace

Point<3> nearest_in_triangle(const Point<3>& p, const Point<3>& a, const Point<3>& b, const Point<3>& c) {
  const Point<3> ab = b - a, ac = c - a;
  const Point<3> normal = ab.cross(ac);
  const double square = normal.squaredNorm();
  // Inside the triangle's prism the foot on its plane is nearest; elsewhere a point of an edge is.
  if (square > 1e-30 * ab.squaredNorm() * ac.squaredNorm()) {
    const Point<3> ap = p - a;
    const double v = ap.cross(ac).dot(normal) / square, w = ab.cross(ap).dot(normal) / square;
    if (v >= 0 && w >= 0 && v + w <= 1) return a + v * ab + w * ac;
  }
  Point<3> best = nearest_in_segment(p, a, b);
  for (const Point<3>& other : {nearest_in_segment(p, b, c), nearest_in_segment(p, c, a)})
    if ((other - p).squaredNorm() < (best - p).squaredNorm()) best = other;
  return best;
}

double ray_hits_triangle(const Point<3>& origin, const Point<3>& direction, const Point<3>& a,
                         const Point<3>& b, const Point<3>& c) {
  // Moeller and Trumbore 1997.
  constexpr double slack = 1e-9;
  const Point<3> ab = b - a, ac = c - a;
  const Point<3> h = direction.cross(ac);
  const double determinant = ab.dot(h);
  if (!(std::abs(determinant) > 1e-14 * ab.norm() * ac.norm())) return infinity;
  const Point<3> from = origin - a;
  const double u = from.dot(h) / determinant;
  if (!(u >= -slack && u <= 1 + slack)) return infinity;
  const Point<3> q = from.cross(ab);
  const double v = direction.dot(q) / determinant;
  if (!(v >= -slack && u + v <= 1 + slack)) return infinity;
  const double distance = ac.dot(q) / determinant;
  return distance >= 0 ? distance : infinity;
}

TriangleTree::TriangleTree(const PointsRef<3>& vertices, const Faces& faces)
    : vertices_(vertices), faces_(faces), order_(static_cast<std::size_t>(faces.cols())) {
  std::iota(order_.begin(), order_.end(), 0);
  Points<3> middles(3, faces_.cols());
  for (int f = 0; f < static_cast<int>(faces_.cols()); ++f)
    middles.col(f) = (corner(f, 0) + corner(f, 1) + corner(f, 2)) / 3;
  if (!order_.empty()) build(0, static_cast<int>(order_.size()), middles);
}

void TriangleTree::build(int begin, int end, const Points<3>& middles) {
  const std::size_t mine = nodes_.size();
  Node node;
  node.begin = begin;
  node.end = end;
  Box<3> spread;
  for (int i = begin; i < end; ++i) {
    const int face = order_[static_cast<std::size_t>(i)];
    for (int k = 0; k < 3; ++k) node.box.extend(corner(face, k));
    spread.extend(Point<3>(middles.col(face)));
  }
  nodes_.push_back(node);
  if (end - begin <= leaf_size) return;
  Index axis = 0;
  spread.sizes().maxCoeff(&axis);
  const int middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end, [&](int a, int b) {
    return std::pair(middles(axis, a), a) < std::pair(middles(axis, b), b);
  });
  build(begin, middle, middles);
  nodes_[mine].right = static_cast<int>(nodes_.size());
  build(middle, end, middles);
}

TriangleTree::Nearest TriangleTree::nearest(const Point<3>& point, double within,
                                            const Ignore& ignore) const {
  Nearest best;
  double square = within < infinity ? within * within : infinity;
  const auto descend = [&](const auto& self, int index) -> void {
    const Node& node = nodes_[static_cast<std::size_t>(index)];
    if (node.right < 0) {
      for (int i = node.begin; i < node.end; ++i) {
        const int face = order_[static_cast<std::size_t>(i)];
        if (ignore && ignore(face)) continue;
        const Point<3> foot = nearest_in_triangle(point, corner(face, 0), corner(face, 1), corner(face, 2));
        const double d = (foot - point).squaredNorm();
        if (d < square || (d == square && best.face > face)) {
          square = d;
          best.face = face;
          best.point = foot;
        }
      }
      return;
    }
    int near = index + 1, far = node.right;
    double near_square = nodes_[static_cast<std::size_t>(near)].box.squaredExteriorDistance(point);
    double far_square = nodes_[static_cast<std::size_t>(far)].box.squaredExteriorDistance(point);
    if (far_square < near_square) {
      std::swap(near, far);
      std::swap(near_square, far_square);
    }
    if (near_square <= square) self(self, near);
    if (far_square <= square) self(self, far);
  };
  if (!nodes_.empty()) descend(descend, 0);
  if (best.face >= 0) best.distance = std::sqrt(square);
  return best;
}

TriangleTree::Hit TriangleTree::first_hit(const Point<3>& origin, const Point<3>& direction, double within,
                                          const Ignore& ignore) const {
  Hit best;
  best.distance = within;
  const auto descend = [&](const auto& self, int index) -> void {
    const Node& node = nodes_[static_cast<std::size_t>(index)];
    if (node.right < 0) {
      for (int i = node.begin; i < node.end; ++i) {
        const int face = order_[static_cast<std::size_t>(i)];
        if (ignore && ignore(face)) continue;
        const double t =
            ray_hits_triangle(origin, direction, corner(face, 0), corner(face, 1), corner(face, 2));
        if (t < best.distance || (t == best.distance && best.face > face)) best = {face, t};
      }
      return;
    }
    int near = index + 1, far = node.right;
    double near_entry = entry(nodes_[static_cast<std::size_t>(near)].box, origin, direction);
    double far_entry = entry(nodes_[static_cast<std::size_t>(far)].box, origin, direction);
    if (far_entry < near_entry) {
      std::swap(near, far);
      std::swap(near_entry, far_entry);
    }
    if (near_entry <= best.distance && near_entry < infinity) self(self, near);
    if (far_entry <= best.distance && far_entry < infinity) self(self, far);
  };
  if (!nodes_.empty()) descend(descend, 0);
  if (best.face < 0) best.distance = infinity;
  return best;
}

void TriangleTree::visit_within(const Point<3>& point, double radius,
                                const std::function<void(int)>& visit) const {
  const double square = radius * radius;
  const auto descend = [&](const auto& self, int index) -> void {
    const Node& node = nodes_[static_cast<std::size_t>(index)];
    if (node.box.squaredExteriorDistance(point) > square) return;
    if (node.right >= 0) {
      self(self, index + 1);
      self(self, node.right);
      return;
    }
    for (int i = node.begin; i < node.end; ++i) {
      const int face = order_[static_cast<std::size_t>(i)];
      const Point<3> foot = nearest_in_triangle(point, corner(face, 0), corner(face, 1), corner(face, 2));
      if ((foot - point).squaredNorm() <= square) visit(face);
    }
  };
  if (!nodes_.empty()) descend(descend, 0);
}

}  // namespace seesaw
