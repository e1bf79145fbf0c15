// How the fitted function changes when its centers and values do, without fitting again.
//
// Before it: core/rbf/full_fit.h, a function, and the factored matrix that it was fitted with.
// After it: core/rbf/parametric_interpolant.h, on which control points work.
//
// Write eq. 8 of Turk & O'Brien 2002 (with smoothing, if any) as A s = [h; 0], s = [w; p], and f(x) = k(x)'
// s, k(x) = [phi(|x - c_j|); 1; x]. A is symmetric. With y(x) = A^-1 k(x) the rule for products gives
//
//     df = dk' s + y' ([dh; 0] - dA s).
//
// So df/dh_i = y_i: y holds the cardinal functions, f = sum h_i y_i. Moving c_i changes entry i of k, and row
// and column i of A:
//
//     df/dc_i = -w_i grad phi(x - c_i) - y_i grad f(c_i) - w_i grad g(c_i)
//             =  w_i grad G_x(c_i) - y_i grad f(c_i),        G_x(z) = phi(|z - x|) - g(z)
//
// where g is the function with weights and polynomial y, the one that interpolates phi(|z - x|) at the
// centers. (A center's distance to itself stays 0, so its own part has no gradient: for r, whose gradient
// does not exist there, that is exact.) y solves eq. 8 with a bottom that is not zero, P' y = [1; x]:
// Factorization::solve_all.
//
// For one direction (c', h') and many x it is cheaper to differentiate the system than its solution: with the
// function that the centers carry along, u(x) = -sum_j w_j c_j' . grad phi(x - c_j),
//
//     f_t = u + v,    v(c_i) = h_i' - c_i' . grad f(c_i) - u(c_i),    P' w_v = -sum_j w_j [0; c_j'],
//
// one solve for v, and then a few sums over the centers a point.
//
// Centers on one line or plane: f is level across it and remains so while they stay there. Across it the fit
// is not continuous, so has no derivative; directions are then projected onto the line or plane.
#pragma once

#include <memory>

#include "core/rbf/full_fit.h"

namespace seesaw {

template <int Dim>
class Sensitivity {
 public:
  /// Costs N^2 gradients of the kernel.
  explicit Sensitivity(std::shared_ptr<const FullFit<Dim>> fit);

  /// Of f at one point by every row: column i is [df/dc_i; df/dh_i], (Dim + 1) x N; value per scene unit, and
  /// a pure number. A solve (2 N^2 multiplications) and N^2 gradients of the kernel.
  Eigen::Matrix<double, Dim + 1, Eigen::Dynamic> by_rows(const Point<Dim>& x) const;

  /// f_t at `points` (Dim x M), M, while centers move at `center_rates` (Dim x N, scene units per unit of
  /// time) and values at `value_rates` (N). One solve, and Dim + 1 sums over the centers a point.
  Values rates(const PointsRef<Dim>& points, const PointsRef<Dim>& center_rates,
               const Values& value_rates) const;

 private:
  // Inside, all is in normalized coordinates.
  const Interpolant<Dim>& f() const { return fit_->fit.function; }
  Interpolant<Dim> function_with(const Solution& solution) const;
  /// A s = [top; bottom].
  Solution solve(const Values& top, const Eigen::Matrix<double, Dim + 1, 1>& bottom) const;

  std::shared_ptr<const FullFit<Dim>> fit_;
  Eigen::Matrix<double, Dim, Dim> projection_;  // onto the centers' line or plane, if they have one
  Points<Dim> slopes_;                          // grad f(c_i), Dim x N
};

extern template class Sensitivity<2>;
extern template class Sensitivity<3>;

}  // namespace seesaw
