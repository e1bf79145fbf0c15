// Fields with known zero sets, and what must hold for any contour of any field.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "core/base/random.h"
#include "core/contour/contour.h"

namespace seesaw {

/// Any f with its gradient, given as one function of a point.
class FunctionField final : public Field<2> {
 public:
  struct Jet {
    double f;
    Point<2> gradient;
  };
  using Function = std::function<Jet(const Point<2>&)>;

  explicit FunctionField(Function function) : function_(std::move(function)) {}

  void evaluate(const PointsRef<2>& points, Eigen::Ref<Values> values) const override {
    check_shapes(points, values);
    for (Index i = 0; i < points.cols(); ++i) values[i] = function_(points.col(i)).f;
  }
  void evaluate(const PointsRef<2>& points, Eigen::Ref<Values> values,
                Eigen::Ref<Points<2>> gradients) const override {
    check_shapes(points, values);
    for (Index i = 0; i < points.cols(); ++i) {
      const Jet jet = function_(points.col(i));
      values[i] = jet.f;
      gradients.col(i) = jet.gradient;
    }
  }
  double gradient_bound(const Box<2>&) const override { return infinity; }
  Box<2> bounding_box() const override { return {}; }

 private:
  Function function_;
};

using Jet = FunctionField::Jet;

inline Box<2> box_of(double x0, double y0, double x1, double y1) {
  return {Point<2>(x0, y0), Point<2>(x1, y1)};
}

/// r^2 - |x - c|^2: exactly zero at Pythagorean lattice points, unlike r - |x - c|.
inline Jet disc(const Point<2>& x, const Point<2>& center, double radius) {
  const Point<2> d = x - center;
  return {radius * radius - d.squaredNorm(), -2 * d};
}

inline Jet minimum(const Jet& a, const Jet& b) { return a.f <= b.f ? a : b; }
inline Jet maximum(const Jet& a, const Jet& b) { return a.f >= b.f ? a : b; }
inline Jet product(const Jet& a, const Jet& b) { return {a.f * b.f, a.gradient * b.f + b.gradient * a.f}; }
inline Jet negated(const Jet& a) { return {-a.f, -a.gradient}; }

inline Points<2> points_of(const std::vector<Point<2>>& list) {
  Points<2> points(2, static_cast<Index>(list.size()));
  for (std::size_t k = 0; k < list.size(); ++k) points.col(static_cast<Index>(k)) = list[k];
  return points;
}

inline bool on_box_side(const Box<2>& box, const Point<2>& p) {
  return (p.array() == box.min().array() || p.array() == box.max().array()).any();
}

/// How far the farthest of `points` is from the nearest polyline.
inline double farthest(const Contour& contour, const Points<2>& points) {
  double worst = 0;
  for (Index i = 0; i < points.cols(); ++i) {
    double nearest = infinity;
    for (const Polyline& polyline : contour.polylines)
      nearest = std::min(nearest, distance(polyline, points.col(i)));
    worst = std::max(worst, nearest);
  }
  return worst;
}

/// What holds for every contour: polylines closed or ended exactly on the box, vertices in the box and on the
/// zero set to `tolerance` times the extent, no vertex twice in a row, facts that agree with the polylines.
inline void expect_sound(const Field<2>& field, const Box<2>& box, const Contour& contour, double level = 0,
                         double tolerance = 1e-12) {
  const double extent = box.sizes().maxCoeff();
  EXPECT_EQ(contour.components, static_cast<Index>(contour.polylines.size()));
  EXPECT_EQ(contour.seeds_lost, 0);
  EXPECT_TRUE(contour.complete);
  Index closed = 0, vertices = 0;
  double total = 0;
  for (const Polyline& polyline : contour.polylines) {
    const Index n = polyline.vertices.cols();
    closed += polyline.closed;
    vertices += n;
    total += length(polyline);
    ASSERT_GE(n, polyline.closed ? 3 : 2);
    if (!polyline.closed) {
      EXPECT_TRUE(on_box_side(box, polyline.vertices.col(0))) << polyline.vertices.col(0).transpose();
      EXPECT_TRUE(on_box_side(box, polyline.vertices.col(n - 1))) << polyline.vertices.col(n - 1).transpose();
    }
    Values f(n);
    Points<2> gradients(2, n);
    field.evaluate(polyline.vertices, f, gradients);
    for (Index i = 0; i < n; ++i) {
      EXPECT_TRUE(box.contains(Point<2>(polyline.vertices.col(i))));
      const double slope = gradients.col(i).norm();
      EXPECT_TRUE(slope == 0 || std::abs(f[i] - level) / slope <= tolerance * extent)
          << polyline.vertices.col(i).transpose() << ": off by " << std::abs(f[i] - level) / slope;
      const bool last = i + 1 == n && !polyline.closed;
      EXPECT_TRUE(last || polyline.vertices.col(i) != polyline.vertices.col((i + 1) % n)) << i << " of " << n;
    }
  }
  EXPECT_EQ(contour.closed, closed);
  EXPECT_EQ(contour.vertices, vertices);
  EXPECT_DOUBLE_EQ(contour.length, total);
}

/// A step to the left of the middle of every segment f is larger than a step to the right.
inline void expect_inside_on_left(const Field<2>& field, const Contour& contour, double shortest = 0) {
  for (const Polyline& polyline : contour.polylines)
    for (Index i = 0; i < polyline.segments(); ++i) {
      const Point<2> a = polyline.vertices.col(i),
                     b = polyline.vertices.col((i + 1) % polyline.vertices.cols());
      const Point<2> along = b - a;
      if (along.norm() <= shortest) continue;
      const Point<2> left = 0.25 * Point<2>(-along.y(), along.x());
      const double f_left = field.value(0.5 * (a + b) + left), f_right = field.value(0.5 * (a + b) - left);
      EXPECT_GT(f_left, f_right) << a.transpose() << " to " << b.transpose();
    }
}

}  // namespace seesaw
