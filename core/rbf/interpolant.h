// The function of eq. 5: a sum of kernels and a linear polynomial, whose zero set is the curve or surface.
//
// Before it: core/rbf/solve.h, the weights; core/rbf/fit.h makes one from constraints in one call.
// After it: core/implicit/field.h, and behind that waist whatever draws, meshes or traces a field.
//
//     f(x) = sum_j w_j phi(|x - c_j|) + p_0 + p . x               Turk & O'Brien 2002, eq. 5
//
// What it promises beyond a Field: Hessians, and the numbers behind the picture (weights, polynomial,
// energy).
#pragma once

#include <memory>

#include "core/implicit/field.h"
#include "core/rbf/kernel.h"
#include "core/rbf/solve.h"
#include "core/rbf/system.h"

namespace seesaw {

template <int Dim>
class Interpolant final : public Field<Dim> {
 public:
  /// `centers` Dim x N in scene units; `solution` in the coordinates of `normalization`.
  Interpolant(Kernel kernel, const PointsRef<Dim>& centers, const Normalization<Dim>& normalization,
              const Solution& solution);

  /// N kernel evaluations a point and next to nothing else: about 2e9 a second and core in AVX-512 for |x|^3.
  void evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values) const override;
  void evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values,
                Eigen::Ref<Points<Dim>> gradients) const override;
  using Field<Dim>::evaluate;

  /// hessians.col(i) = the Dim x Dim second derivatives at points.col(i), column-major, value per scene unit
  /// squared. At a center, where those of r^2 log r and r do not exist, that center's own part is left out.
  void evaluate_hessians(const PointsRef<Dim>& points, Eigen::Ref<Hessians<Dim>> hessians) const;
  /// The Hessian at one point, Dim x Dim.
  Eigen::Matrix<double, Dim, Dim> hessian(const Point<Dim>& point) const;

  /// Rigorous but for rounding; core/rbf/gradient_bound.h says how. O(N).
  double gradient_bound(const Box<Dim>& box) const override;
  /// The box around the centers, grown by half its longest side.
  Box<Dim> bounding_box() const override { return box_; }

  Kernel kernel() const { return kernel_; }
  Index size() const { return centers_.cols(); }
  /// c_j, Dim x N, scene units.
  const Points<Dim>& centers() const { return centers_; }
  /// w_j of eq. 5 in scene units, N. They meet eq. 8's side conditions: sum w_j = 0 and sum w_j c_j = 0.
  Values weights() const;
  /// p_0 and p of eq. 5 in scene units, Dim + 1. Far from the origin p_0 has few digits; the field does not
  /// use it.
  Values polynomial() const;

  /// The bending energy of the function, >= 0, in value^2 per scene unit^(2 order - Dim): see
  /// core/rbf/energy.h.
  double energy() const;

  const Normalization<Dim>& normalization() const { return normalization_; }
  /// In normalized coordinates: Dim x N and N.
  const Points<Dim>& normalized_centers() const { return normalized_; }
  const Values& normalized_weights() const { return solution_.weights; }
  const Values& normalized_polynomial() const { return solution_.polynomial; }

 private:
  Kernel kernel_;
  Points<Dim> centers_;
  Normalization<Dim> normalization_;
  Points<Dim> normalized_;
  Solution solution_;
  Box<Dim> box_;
  Eigen::Matrix<double, Eigen::Dynamic, Dim>
      columns_;  // normalized centers, one array a coordinate, for the loops
};

extern template class Interpolant<2>;
extern template class Interpolant<3>;
extern template class Interpolant<4>;

}  // namespace seesaw
