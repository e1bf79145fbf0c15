// What a change of the parameters costs: the metric M of Witkin & Heckbert's footnote 1.
//
// Before it: parameters of different kinds (a radius, a bias, a coordinate), whose units cannot be compared.
// After it: control_points.h takes, of all motions that do as told, the one of least (q' - Q)' M (q' - Q).
//
// "It is possible to automatically compute a sensitivity matrix ... that compensates for scale differences
// among the components of F_q." A parameter's sensitivity is how fast the surface moves along its normal when
// the parameter does, |f_q| / |f_x|, in mean square over points of the surface. With its square as the metric
// a parameter's cost is what it does to the surface, and its unit no longer matters.
#pragma once

#include "core/implicit/parametric.h"

namespace seesaw {

class Metric {
 public:
  /// M = 1, for any number of parameters: the paper's.
  Metric() = default;
  /// M = diag(costs): m numbers > 0. Throws Error otherwise.
  static Metric diagonal(const Values& costs);
  /// Any symmetric positive definite M, m x m. Throws Error otherwise. m^3 / 3 multiplications.
  static Metric full(const Eigen::MatrixXd& matrix);

  /// The number of parameters it is for, or 0 for any.
  Index size() const { return size_; }
  /// L^-1 x and L^-T x where M = L L', for the columns of x (m x N): in these coordinates lengths are the
  /// usual ones.
  Eigen::MatrixXd to_orthonormal(const Eigen::MatrixXd& x) const;
  Values from_orthonormal(const Values& x) const;
  /// x' M x.
  double squared_length(const Values& x) const;

 private:
  Index size_ = 0;
  Values roots_;           // of a diagonal M, or empty
  Eigen::MatrixXd lower_;  // L of a full M, or empty
};

/// The diagonal metric of the field's free parameters: mean over `points` (Dim x N) of (f_q / |f_x|)^2, and
/// at least 1e-6 of the largest, so that what the surface does not feel is not free of charge. M = 1 where
/// there is nothing to feel. The points should cover the surface, as floaters do, and the metric be made
/// again as it moves: a parameter that moves what no point sees is nearly free and will be moved far. The
/// cost of N columns of q_gradients.
template <int Dim>
Metric sensitivity_metric(const ParametricField<Dim>& field, const PointsRef<Dim>& points);

}  // namespace seesaw
