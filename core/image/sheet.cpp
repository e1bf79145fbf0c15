#include "core/image/sheet.h"

#include <algorithm>
#include <cmath>

namespace seesaw {
namespace {

Points<2> matrix_of(const std::vector<Point<2>>& points) {
  Points<2> matrix(2, static_cast<Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) matrix.col(static_cast<Index>(i)) = points[i];
  return matrix;
}

// The part of the segment a + t (b - a), t in 0 .. 1, inside the box: Liang and Barsky 1984. False for
// none.
bool part_within(const Point<2>& a, const Point<2>& b, const Box<2>& box, double& from, double& to) {
  from = 0;
  to = 1;
  for (int d = 0; d < 2; ++d) {
    const double run = b[d] - a[d];
    if (run == 0) {
      if (a[d] < box.min()[d] || a[d] > box.max()[d]) return false;
      continue;
    }
    double enter = (box.min()[d] - a[d]) / run, leave = (box.max()[d] - a[d]) / run;
    if (enter > leave) std::swap(enter, leave);
    from = std::max(from, enter);
    to = std::min(to, leave);
  }
  return from <= to;
}

}  // namespace

Box<2> Canvas::Marks::reach(double stroke_width) const {
  const double margin = std::max(width, height) + 2 * std::min(stroke_width, std::max(width, height));
  return Box<2>(Point<2>(-margin, -margin), Point<2>(width + margin, height + margin));
}

std::vector<Points<2>> pieces_within(const PointsRef<2>& points, const Box<2>& box) {
  std::vector<Points<2>> pieces;
  std::vector<Point<2>> piece;
  const auto finish = [&] {
    if (piece.size() > 1) pieces.push_back(matrix_of(piece));
    piece.clear();
  };
  for (Index i = 0; i + 1 < points.cols(); ++i) {
    const Point<2> a = points.col(i), b = points.col(i + 1);
    double from = 0, to = 0;
    if (!a.allFinite() || !b.allFinite() || !part_within(a, b, box, from, to)) {
      finish();
      continue;
    }
    if (from > 0) finish();
    if (piece.empty()) piece.push_back(from > 0 ? Point<2>(a + from * (b - a)) : a);
    piece.push_back(to < 1 ? Point<2>(a + to * (b - a)) : b);
    if (to < 1) finish();
  }
  finish();
  return pieces;
}

Points<2> ring_within(const PointsRef<2>& ring, const Box<2>& box) {
  std::vector<Point<2>> now, next;
  bool inside_all = true;
  for (Index i = 0; i < ring.cols(); ++i) {
    const Point<2> p = ring.col(i);
    if (!p.allFinite()) continue;
    now.push_back(p);
    inside_all = inside_all && box.contains(p);
  }
  if (inside_all) return matrix_of(now);
  for (int side = 0; side < 4; ++side) {
    const int d = side % 2;
    const double sign = side < 2 ? 1 : -1;
    const double border = side < 2 ? box.max()[d] : box.min()[d];
    const auto inside = [&](const Point<2>& p) { return sign * (border - p[d]) >= 0; };
    next.clear();
    for (std::size_t i = 0; i < now.size(); ++i) {
      const Point<2>&a = now[i], &b = now[(i + 1) % now.size()];
      if (inside(a)) next.push_back(a);
      if (inside(a) != inside(b)) {
        Point<2> cut = a + (border - a[d]) / (b[d] - a[d]) * (b - a);
        cut[d] = border;
        next.push_back(cut);
      }
    }
    now.swap(next);
  }
  return matrix_of(now);
}

Color safe(const Color& color) {
  const auto part = [](double p) { return p > 0 ? std::min(p, 1.0) : 0.0; };
  return {part(color.r), part(color.g), part(color.b), part(color.a)};
}

}  // namespace seesaw
