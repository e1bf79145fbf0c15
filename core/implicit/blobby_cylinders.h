// Blobby cylinders: a level of a sum of Gaussians of the distances to line segments.
//
// Before it: segments and standard deviations.
// After it: core/implicit/field.h; parametric_shapes.h makes it movable. Witkin & Heckbert 1994, Fig. 2, drag
// three of them into a shape.
//
//     f(x) = -t + sum_i g_i(x),      g_i(x) = exp(-d_i(x)^2 / s_i^2),      d_i(x) = |x - e_i(x)|
//
// with e_i(x) the point nearest to x on the segment from a_i to b_i. Witkin & Heckbert (section 5) say no
// more than "the sum of Gaussians of the distance to each of several line segments". One alone is a cylinder
// of radius s sqrt(-log t) with round ends; in 2D, a stadium.
//
// The gradient is continuous: d^2 is, for a convex set, differentiable with gradient 2 (x - e) although e has
// a kink where it reaches an end. The second derivatives jump there.
#pragma once

#include "core/implicit/field.h"

namespace seesaw {

/// The point of a segment that is nearest to another point, e = a + along (b - a).
template <int Dim>
struct NearestOnSegment {
  double along;     ///< 0 at a, 1 at b; 1/2 where a == b
  Point<Dim> away;  ///< x - e
  NearestOnSegment(const Point<Dim>& x, const Point<Dim>& a, const Point<Dim>& b);
};

template <int Dim>
class BlobbyCylinders final : public Field<Dim> {
 public:
  /// `threshold` t as for BlobbySpheres; `starts` a_i and `ends` b_i, Dim x K, and `deviations` s_i > 0, K,
  /// in scene units. A segment may be a point: that cylinder is a blobby sphere.
  BlobbyCylinders(double threshold, const PointsRef<Dim>& starts, const PointsRef<Dim>& ends,
                  const Eigen::Ref<const Values>& deviations);

  /// K exponentials a point.
  void evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values) const override;
  void evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values,
                Eigen::Ref<Points<Dim>> gradients) const override;
  using Field<Dim>::evaluate;

  /// Rigorous; as that of BlobbySpheres, with distances that lie within the box's radius of the one at its
  /// middle. O(K).
  double gradient_bound(const Box<Dim>& box) const override;

  /// Holds the whole solid: beyond s_i sqrt(log(K / t)) of every segment the sum is below t. 3 s_i where t <=
  /// 0 or t >= K leaves no solid to hold.
  Box<Dim> bounding_box() const override;

  double threshold() const { return threshold_; }
  const Points<Dim>& starts() const { return starts_; }
  const Points<Dim>& ends() const { return ends_; }
  const Values& deviations() const { return deviations_; }
  Index size() const { return starts_.cols(); }

 private:
  double threshold_;
  Points<Dim> starts_, ends_;  // Dim x K
  Values deviations_;          // K
};

extern template struct NearestOnSegment<2>;
extern template struct NearestOnSegment<3>;
extern template class BlobbyCylinders<2>;
extern template class BlobbyCylinders<3>;

}  // namespace seesaw
