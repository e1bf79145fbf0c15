// Blobby spheres: the surface that everybody made before, a level of a sum of Gaussians (Blinn 1982).
//
// Before it: centers and standard deviations that somebody guessed.
// After it: core/implicit/field.h. Turk & O'Brien 2002, section 8.2, compare interpolating surfaces with it;
// Witkin & Heckbert 1994, section 5, drag it by control points.
//
//     f(x) = -t + sum_i g_i(x),      g_i(x) = exp(-|x - c_i|^2 / s_i^2)
//
// That is eq. 1 of T&O 2002 and eq. 2 with the minus sign that is missing in its print: without it the
// Gaussians would grow without end. Witkin and Heckbert's F = b - sum g_i is the same with the other sign,
// F = -f, b = t; ours is positive inside. s_i is called the standard deviation by both papers; a statistician
// would call s_i / sqrt 2 so.
//
// One sphere alone has radius s sqrt(-log t). Several together are *not* the union of the spheres: where they
// meet their values add up, and the surface bulges.
#pragma once

#include "core/implicit/field.h"

namespace seesaw {

template <int Dim>
class BlobbySpheres final : public Field<Dim> {
 public:
  /// `threshold` t; `centers` c_i, Dim x K, and `deviations` s_i > 0, K, in scene units. With 0 < t < 1 every
  /// sphere is there; with t <= 0 everything is inside, with t >= K nothing.
  BlobbySpheres(double threshold, const PointsRef<Dim>& centers, const Eigen::Ref<const Values>& deviations);

  /// The blobby sphere that alone has the given radius at threshold t: s = radius / sqrt(-log t), 0 < t < 1.
  static double deviation_for(double radius, double threshold);

  /// K exponentials a point.
  void evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values) const override;
  void evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values,
                Eigen::Ref<Points<Dim>> gradients) const override;
  using Field<Dim>::evaluate;

  /// Rigorous: the smaller of the sum of every Gaussian's steepest slope in the box, and the slope at the
  /// middle plus the radius times the sum of largest Hessians. O(K).
  double gradient_bound(const Box<Dim>& box) const override;

  /// Holds the whole solid: beyond s_i sqrt(log(K / t)) of every center the sum is below t. (Witkin and
  /// Heckbert take 3 s_i, and so do we where t <= 0 or t >= K leaves no solid to hold.)
  Box<Dim> bounding_box() const override;

  double threshold() const { return threshold_; }
  const Points<Dim>& centers() const { return centers_; }
  const Values& deviations() const { return deviations_; }
  Index size() const { return centers_.cols(); }

 private:
  double threshold_;
  Points<Dim> centers_;  // Dim x K
  Values deviations_;    // K
};

extern template class BlobbySpheres<2>;
extern template class BlobbySpheres<3>;

}  // namespace seesaw
