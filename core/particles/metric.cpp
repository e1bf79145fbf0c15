#include "core/particles/metric.h"

#include <Eigen/Cholesky>

#include "core/base/error.h"

namespace seesaw {

Metric Metric::diagonal(const Values& costs) {
  if (!costs.allFinite() || !(costs.array() > 0).all())
    throw Error("a metric's costs must be positive numbers");
  Metric metric;
  metric.size_ = costs.size();
  metric.roots_ = costs.cwiseSqrt();
  return metric;
}

Metric Metric::full(const Eigen::MatrixXd& matrix) {
  const double size = matrix.cwiseAbs().sum();
  const bool symmetric = matrix.rows() == matrix.cols() && matrix.allFinite() &&
                         (matrix - matrix.transpose()).cwiseAbs().maxCoeff() <= 1e-12 * size;
  const Eigen::LLT<Eigen::MatrixXd> cholesky(symmetric ? matrix : -Eigen::MatrixXd::Ones(1, 1));
  if (cholesky.info() != Eigen::Success) throw Error("a metric must be symmetric and positive definite");
  Metric metric;
  metric.size_ = matrix.rows();
  metric.lower_ = cholesky.matrixL();
  return metric;
}

Eigen::MatrixXd Metric::to_orthonormal(const Eigen::MatrixXd& x) const {
  if (size_ > 0) SEESAW_CHECK_EQ(x.rows(), size_);
  if (roots_.size() > 0) return roots_.cwiseInverse().asDiagonal() * x;
  if (lower_.size() > 0) return lower_.triangularView<Eigen::Lower>().solve(x);
  return x;
}

Values Metric::from_orthonormal(const Values& x) const {
  if (size_ > 0) SEESAW_CHECK_EQ(x.size(), size_);
  if (roots_.size() > 0) return x.cwiseQuotient(roots_);
  if (lower_.size() > 0) return lower_.transpose().triangularView<Eigen::Upper>().solve(x);
  return x;
}

double Metric::squared_length(const Values& x) const {
  if (size_ > 0) SEESAW_CHECK_EQ(x.size(), size_);
  if (roots_.size() > 0) return x.cwiseProduct(roots_).squaredNorm();
  if (lower_.size() > 0) return (lower_.transpose() * x).squaredNorm();
  return x.squaredNorm();
}

template <int Dim>
Metric sensitivity_metric(const ParametricField<Dim>& field, const PointsRef<Dim>& points) {
  Values values(points.cols());
  Points<Dim> gradients(Dim, points.cols());
  field.evaluate(points, values, gradients);
  const Eigen::MatrixXd by_q = field.q_gradients(points);
  Values sums = Values::Zero(field.parameters());
  for (Index i = 0; i < points.cols(); ++i) {
    const double steepness = gradients.col(i).squaredNorm();
    if (steepness > 0) sums += by_q.col(i).cwiseAbs2() / steepness;
  }
  const double largest = sums.size() > 0 ? sums.maxCoeff() : 0.0;
  if (!(largest > 0)) return {};
  return Metric::diagonal(sums.cwiseMax(1e-6 * largest) / static_cast<double>(points.cols()));
}

template Metric sensitivity_metric<2>(const ParametricField<2>&, const PointsRef<2>&);
template Metric sensitivity_metric<3>(const ParametricField<3>&, const PointsRef<3>&);

}  // namespace seesaw
