// The interpolating surface as one that control points can move: its parameters are its constraints.
//
// Before it: core/rbf/constraints.h, and core/rbf/sensitivity.h for the derivatives.
// After it: core/implicit/parametric.h, and behind it core/particles, which knows nothing of kernels.
//
// Turk & O'Brien 2002 drag a constraint and solve again. Witkin & Heckbert 1994 drag any point of any surface
// with a known f_q, and solve for the parameters. Here both meet: q are the constraints' positions and
// values, all of them or those that are not frozen, and a point of the surface that is no constraint can be
// dragged too.
//
// Constraint i has the parameters "ci.x", "ci.y", "ci.z", "ci.value", and with a normal "ci.normal_value". A
// boundary constraint takes its normal constraint along: the row that stands for the normal moves by the same
// vector, and the normal keeps its direction.
//
// Positions and values have different units, so the least |q' - Q| is a matter of the unit of length. Freeze
// the values, or give a metric (core/particles/control_points.h): sensitivity_metric makes one for which
// units do not matter.
#pragma once

#include <optional>

#include "core/implicit/parametric.h"
#include "core/rbf/sensitivity.h"

namespace seesaw {

/// For Dim 2 and 3. set_q fits again, N^3 / 3 multiplications (of N rows), and the factored matrix is kept
/// for the derivatives: N^2 / 2 doubles. A point of q_gradients costs a solve and N^2 kernels; all of `rates`
/// costs one solve, and (Dim + 1) N kernels a point.
///
/// Rows that the fit has merged (two constraints at one position with one value) have no derivative: one of
/// them stands for all, and the others' derivatives are given as zero.
template <int Dim>
class ParametricInterpolant final : public ParametricField<Dim> {
 public:
  /// Throws ConstraintError, as `fit` does, and so does set_q; the last good surface is then kept.
  explicit ParametricInterpolant(const Constraints<Dim>& constraints, const FitOptions& options = {});

  void evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values) const override;
  void evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values,
                Eigen::Ref<Points<Dim>> gradients) const override;
  using Field<Dim>::evaluate;
  double gradient_bound(const Box<Dim>& box) const override;
  Box<Dim> bounding_box() const override;

  std::vector<std::string> names() const override;
  /// Indices into names(), for freezing: the first of Dim coordinates; the value; the normal's value, if any.
  Index position_parameter(Index constraint) const;
  Index value_parameter(Index constraint) const;
  std::optional<Index> normal_value_parameter(Index constraint) const;
  /// Freezes all values, normals' values included, or all positions.
  void freeze_values(bool frozen = true);
  void freeze_positions(bool frozen = true);

  /// As q has moved them.
  const Constraints<Dim>& constraints() const { return constraints_; }
  const Interpolant<Dim>& function() const { return fit_->fit.function; }
  const FitReport& report() const { return fit_->fit.report; }

 private:
  Values all() const override;
  void set_all(const Values& values) override;
  Eigen::MatrixXd all_gradients(const PointsRef<Dim>& points) const override;
  Values all_rates(const PointsRef<Dim>& points, const Values& rates) const override;

  /// Where row i's center and value stand in q.
  struct RowParameters {
    Index position, value;
  };
  std::vector<RowParameters> row_parameters() const;
  const Sensitivity<Dim>& sensitivity() const;

  Constraints<Dim> constraints_;
  FitOptions options_;
  std::vector<Index> first_;  // of each constraint's parameters
  std::shared_ptr<const FullFit<Dim>> fit_;
  mutable std::optional<Sensitivity<Dim>> sensitivity_;  // made when it is first asked for
};

extern template class ParametricInterpolant<2>;
extern template class ParametricInterpolant<3>;

}  // namespace seesaw
