// Surfaces that move, for tests of floaters: each changes by plain numbers, and says how fast f changes with
// them.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/implicit/blobby.h"
#include "core/implicit/booleans.h"
#include "core/implicit/primitives.h"
#include "core/implicit/torus.h"
#include "core/particles/measures.h"

namespace seesaw {

// The sanitizers run some ten times slower: large populations and second variants are left to the plain
// build.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

/// A cylinder with round caps along the x axis: f = r - distance from the segment. Its length can change.
class Capsule final : public Field<3> {
 public:
  Capsule(double half, double thickness) : half_length(half), radius(thickness) {}
  double half_length, radius;

  void evaluate(const PointsRef<3>& points, Eigen::Ref<Values> values) const override {
    Points<3> gradients(3, points.cols());
    evaluate(points, values, gradients);
  }
  void evaluate(const PointsRef<3>& points, Eigen::Ref<Values> values,
                Eigen::Ref<Points<3>> gradients) const override {
    for (Index i = 0; i < points.cols(); ++i) {
      const Point<3> d = from_axis(points.col(i));
      values[i] = radius - d.norm();
      gradients.col(i) = d.norm() > 0 ? Point<3>(-d / d.norm()) : Point<3>(0, 0, 0);
    }
  }
  double gradient_bound(const Box<3>&) const override { return 1; }
  Box<3> bounding_box() const override {
    const Point<3> reach(half_length + 1.25 * radius, 1.25 * radius, 1.25 * radius);
    return Box<3>(-reach, reach);
  }
  /// df / d half_length at each of `points`.
  Values length_rates(const Points<3>& points) const {
    Values result(points.cols());
    for (Index i = 0; i < points.cols(); ++i) {
      const Point<3> d = from_axis(points.col(i));
      result[i] = std::abs(points(0, i)) > half_length ? std::abs(d[0]) / d.norm() : 0.0;
    }
    return result;
  }
  double area() const { return 2 * pi * radius * 2 * half_length + 4 * pi * radius * radius; }
  double volume() const { return pi * radius * radius * (2 * half_length + 4 * radius / 3); }

 private:
  static constexpr double pi = 3.141592653589793;
  Point<3> from_axis(const Point<3>& x) const {
    return Point<3>(x[0] - std::clamp(x[0], -half_length, half_length), x[1], x[2]);
  }
};

/// f = 1 - |x / a|, coordinate by coordinate: an ellipsoid, no distance, |grad f| from 1 / max a to 1 / min
/// a.
class Ellipsoid final : public Field<3> {
 public:
  explicit Ellipsoid(const Point<3>& half_axes) : axes(half_axes) {}
  Point<3> axes;

  void evaluate(const PointsRef<3>& points, Eigen::Ref<Values> values) const override {
    for (Index i = 0; i < points.cols(); ++i) values[i] = 1 - points.col(i).cwiseQuotient(axes).norm();
  }
  void evaluate(const PointsRef<3>& points, Eigen::Ref<Values> values,
                Eigen::Ref<Points<3>> gradients) const override {
    evaluate(points, values);
    for (Index i = 0; i < points.cols(); ++i) {
      const Point<3> scaled = points.col(i).cwiseQuotient(axes);
      gradients.col(i).setZero();
      if (scaled.norm() > 0) gradients.col(i) = -scaled.cwiseQuotient(axes) / scaled.norm();
    }
  }
  double gradient_bound(const Box<3>&) const override { return 1 / axes.minCoeff(); }
  Box<3> bounding_box() const override { return Box<3>(-1.25 * axes, 1.25 * axes); }
};

/// Any field that can be exchanged for another while floaters look at it.
class Moving final : public Field<3> {
 public:
  std::shared_ptr<const Field<3>> now;
  explicit Moving(std::shared_ptr<const Field<3>> first) : now(std::move(first)) {}
  void evaluate(const PointsRef<3>& points, Eigen::Ref<Values> values) const override {
    now->evaluate(points, values);
  }
  void evaluate(const PointsRef<3>& points, Eigen::Ref<Values> values,
                Eigen::Ref<Points<3>> gradients) const override {
    now->evaluate(points, values, gradients);
  }
  double gradient_bound(const Box<3>& box) const override { return now->gradient_bound(box); }
  Box<3> bounding_box() const override { return now->bounding_box(); }
};

inline Union<3> two_spheres(double radius_a, double radius_b, double gap) {
  return Union<3>(
      {share(Sphere<3>({0, 0, 0}, radius_a)), share(Sphere<3>({radius_a + gap + radius_b, 0, 0}, radius_b))});
}

/// Points all over the sphere, nearly even: a Fibonacci spiral.
inline Points<3> points_on_sphere(const Point<3>& center, double radius, Index n) {
  Points<3> result(3, n);
  for (Index i = 0; i < n; ++i) {
    const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(n);
    const double angle = 2.399963229728653 * static_cast<double>(i), rho = std::sqrt(1 - z * z);
    result.col(i) = center + radius * Point<3>(rho * std::cos(angle), rho * std::sin(angle), z);
  }
  return result;
}

/// Points all over a torus around the z axis at the origin, about evenly.
inline Points<3> points_on_torus(double major, double minor, int around) {
  const int across = std::max(8, static_cast<int>(around * minor / major));
  Points<3> result(3, around * across);
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double u = 6.283185307179586 * i / around, v = 6.283185307179586 * j / across;
      const double rho = major + minor * std::cos(v);
      result.col(i * across + j) << rho * std::cos(u), rho * std::sin(u), minor * std::sin(v);
    }
  return result;
}

}  // namespace seesaw
