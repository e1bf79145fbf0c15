#include "core/rbf/sensitivity.h"

#include <Eigen/LU>
#include <cmath>

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/rbf/energy.h"

namespace seesaw {
namespace {

// The same function, of normalized coordinates.
template <int Dim>
Interpolant<Dim> normalized(const Interpolant<Dim>& f) {
  return {f.kernel(), f.normalized_centers(), {}, {f.normalized_weights(), f.normalized_polynomial()}};
}

template <int Dim>
double normalized_smoothing(const Interpolant<Dim>& f, double smoothing) {
  return smoothing / std::pow(f.normalization().scale, growth_of(f.kernel()));
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
Sensitivity<Dim>::Sensitivity(const Interpolant<Dim>& function, double smoothing)
    : f_(function),
      factorization_(function.normalized_centers(), function.kernel(),
                     normalized_smoothing(function, smoothing)),
      mean_(function.normalized_centers().rowwise().mean()),
      centered_(function.normalized_centers().colwise() - mean_),
      slopes_(Dim, function.size()) {
  if (!factorization_.positive_definite())
    throw Error("the constraints are too close together to tell how the surface moves with them");

  projection_ = projection_onto<Dim>(centered_, factorization_.polynomial_rank() - 1);
  // What is missing to full rank is filled up, inverted and taken out again.
  const Eigen::Matrix<double, Dim, Dim> one = Eigen::Matrix<double, Dim, Dim>::Identity();
  const Eigen::Matrix<double, Dim, Dim> spread = centered_ * centered_.transpose() + (one - projection_);
  inverse_ = projection_ * spread.inverse() * projection_;

  const double sign = f_.kernel() == Kernel::linear ? -1.0 : 1.0;
  const Values none = Values::Zero(Dim + 1);
  a_polynomials_.resize(f_.size(), Dim + 1);
  for (int k = 0; k <= Dim; ++k) {
    Values p = Values::Ones(f_.size());
    if (k > 0) p = centered_.row(k - 1).transpose();
    a_polynomials_.col(k) = function_with({p, none}).values(f_.normalized_centers()) +
                            sign * normalized_smoothing(function, smoothing) * p;
  }
  Values values(f_.size());
  normalized(f_).evaluate(f_.normalized_centers(), values, slopes_);
}

template <int Dim>
Interpolant<Dim> Sensitivity<Dim>::function_with(const Solution& solution) const {
  return {f_.kernel(), f_.normalized_centers(), {}, solution};
}

template <int Dim>
Solution Sensitivity<Dim>::solve(const Values& top, const Eigen::Matrix<double, Dim + 1, 1>& bottom) {
  // y0 = P (P' P)^-1 bottom; sum of centered_ is 0, which makes P' P block diagonal.
  Eigen::Matrix<double, Dim + 1, 1> by;
  by[0] = bottom[0] / static_cast<double>(f_.size());
  by.template tail<Dim>() = inverse_ * bottom.template tail<Dim>();
  Solution solution = factorization_.solve(top - a_polynomials_ * by);
  solution.weights += centered_.transpose() * by.template tail<Dim>();
  solution.weights.array() += by[0];
  return solution;
}

template <int Dim>
Eigen::Matrix<double, Dim + 1, Eigen::Dynamic> Sensitivity<Dim>::by_rows(const Point<Dim>& at) {
  const Index n = f_.size();
  const Point<Dim> x = f_.normalization().apply(at);
  const Interpolant<Dim> phi(f_.kernel(), x, {}, {Values::Ones(1), Values::Zero(Dim + 1)});
  Eigen::Matrix<double, Dim + 1, 1> bottom;
  bottom << 1, x - mean_;
  const Solution y = solve(phi.values(f_.normalized_centers()), bottom);

  // G_x is a sum of kernels at the centers and at x.
  Points<Dim> centers(Dim, n + 1);
  centers << f_.normalized_centers(), x;
  Values weights(n + 1);
  weights << -y.weights, 1;
  const Interpolant<Dim> green(f_.kernel(), centers, {}, {weights, -y.polynomial});
  Values values(n);
  Points<Dim> gradients(Dim, n);
  green.evaluate(f_.normalized_centers(), values, gradients);

  Eigen::Matrix<double, Dim + 1, Eigen::Dynamic> result(Dim + 1, n);
  result.template topRows<Dim>() =
      projection_ * (gradients * f_.normalized_weights().asDiagonal() - slopes_ * y.weights.asDiagonal()) /
      f_.normalization().scale;
  result.row(Dim) = y.weights.transpose();
  return result;
}

template <int Dim>
Values Sensitivity<Dim>::rates(const PointsRef<Dim>& points, const PointsRef<Dim>& center_rates,
                               const Values& value_rates) {
  const Index n = f_.size();
  SEESAW_CHECK_EQ(center_rates.cols(), n);
  SEESAW_CHECK_EQ(value_rates.size(), n);
  const Points<Dim> velocities = projection_ * center_rates / f_.normalization().scale;
  const Points<Dim> carried = velocities * f_.normalized_weights().asDiagonal();  // w_j c_j'

  // u is minus a divergence; together with the points, so that the loops are started once.
  Points<Dim> all(Dim, n + points.cols());
  all << f_.normalized_centers(), f_.normalization().apply(points);
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
