#include "core/rbf/sensitivity.h"

#include "core/base/check.h"

namespace seesaw {
namespace {

// The same function, of normalized coordinates.
template <int Dim>
Interpolant<Dim> normalized(const Interpolant<Dim>& f) {
  return {f.kernel(), f.normalized_centers(), {}, {f.normalized_weights(), f.normalized_polynomial()}};
}

// Onto the line or plane, of as many `directions` as the factorization found, that vectors (Dim x N) lie in:
// the longest of them, the longest of what is left across it, ...
template <int Dim>
Eigen::Matrix<double, Dim, Dim> projection_onto(Points<Dim> vectors, Index directions) {
  if (directions == Dim) return Eigen::Matrix<double, Dim, Dim>::Identity();
  Eigen::Matrix<double, Dim, Dim> projection = Eigen::Matrix<double, Dim, Dim>::Zero();
  for (Index k = 0; k < directions; ++k) {
    Index longest = 0;
    vectors.colwise().squaredNorm().maxCoeff(&longest);
    const Point<Dim> axis = vectors.col(longest).normalized();
    projection += axis * axis.transpose();
    vectors -= axis * (axis.transpose() * vectors).eval();
  }
  return projection;
}

}  // namespace

template <int Dim>
Sensitivity<Dim>::Sensitivity(std::shared_ptr<const FullFit<Dim>> fit)
    : fit_(std::move(fit)), slopes_(Dim, f().size()) {
  const Points<Dim>& centers = f().normalized_centers();
  projection_ = projection_onto<Dim>(centers.colwise() - centers.rowwise().mean(),
                                     fit_->factorization.polynomial_rank() - 1);
  Values values(f().size());
  normalized(f()).evaluate(centers, values, slopes_);
}

template <int Dim>
Interpolant<Dim> Sensitivity<Dim>::function_with(const Solution& solution) const {
  return {f().kernel(), f().normalized_centers(), {}, solution};
}

template <int Dim>
Solution Sensitivity<Dim>::solve(const Values& top, const Eigen::Matrix<double, Dim + 1, 1>& bottom) const {
  Eigen::MatrixXd right_side(top.size() + Dim + 1, 1);
  right_side << top, bottom;
  const Eigen::MatrixXd s = fit_->factorization.solve_all(right_side);
  return {s.col(0).head(top.size()), s.col(0).tail(Dim + 1)};
}

template <int Dim>
Eigen::Matrix<double, Dim + 1, Eigen::Dynamic> Sensitivity<Dim>::by_rows(const Point<Dim>& at) const {
  const Index n = f().size();
  const Point<Dim> x = f().normalization().apply(at);
  const Interpolant<Dim> phi(f().kernel(), x, {}, {Values::Ones(1), Values::Zero(Dim + 1)});
  Eigen::Matrix<double, Dim + 1, 1> bottom;
  bottom << 1, x;
  const Solution y = solve(phi.values(f().normalized_centers()), bottom);

  // G_x is a sum of kernels at the centers and at x.
  Points<Dim> centers(Dim, n + 1);
  centers << f().normalized_centers(), x;
  Values weights(n + 1);
  weights << -y.weights, 1;
  const Interpolant<Dim> green(f().kernel(), centers, {}, {weights, -y.polynomial});
  Values values(n);
  Points<Dim> gradients(Dim, n);
  green.evaluate(f().normalized_centers(), values, gradients);

  Eigen::Matrix<double, Dim + 1, Eigen::Dynamic> result(Dim + 1, n);
  result.template topRows<Dim>() =
      projection_ * (gradients * f().normalized_weights().asDiagonal() - slopes_ * y.weights.asDiagonal()) /
      f().normalization().scale;
  result.row(Dim) = y.weights.transpose();
  return result;
}

template <int Dim>
Values Sensitivity<Dim>::rates(const PointsRef<Dim>& points, const PointsRef<Dim>& center_rates,
                               const Values& value_rates) const {
  const Index n = f().size();
  SEESAW_CHECK_EQ(center_rates.cols(), n);
  SEESAW_CHECK_EQ(value_rates.size(), n);
  const Points<Dim> velocities = projection_ * center_rates / f().normalization().scale;
  const Points<Dim> carried = velocities * f().normalized_weights().asDiagonal();  // w_j c_j'

  // u is minus a divergence; together with the points, so that the loops are started once.
  Points<Dim> all(Dim, n + points.cols());
  all << f().normalized_centers(), f().normalization().apply(points);
  Values u = Values::Zero(all.cols()), values(all.cols());
  Points<Dim> gradients(Dim, all.cols());
  for (int d = 0; d < Dim; ++d) {
    if (carried.row(d).isZero(0)) continue;
    function_with({carried.row(d).transpose(), Values::Zero(Dim + 1)}).evaluate(all, values, gradients);
    u -= gradients.row(d).transpose();
  }

  Eigen::Matrix<double, Dim + 1, 1> bottom;
  bottom << 0, -carried.rowwise().sum();
  const Values top = value_rates - velocities.cwiseProduct(slopes_).colwise().sum().transpose() - u.head(n);
  const Interpolant<Dim> v = function_with(solve(top, bottom));
  return u.tail(points.cols()) + v.values(all.rightCols(points.cols()));
}

template class Sensitivity<2>;
template class Sensitivity<3>;

}  // namespace seesaw
