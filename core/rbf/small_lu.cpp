#include "core/rbf/small_lu.h"

#include <cmath>
#include <numeric>

#include "core/base/check.h"

namespace seesaw {

SmallLu::SmallLu(Eigen::MatrixXd matrix)
    : matrix_(std::move(matrix)), factors_(matrix_), scale_(matrix_.rows()), order_(slot(matrix_.rows())) {
  const Index n = matrix_.rows();
  SEESAW_CHECK_EQ(n, matrix_.cols());
  std::iota(order_.begin(), order_.end(), Index{0});
  for (Index i = 0; i < n; ++i) {
    scale_[i] = 1.0 / factors_.row(i).cwiseAbs().maxCoeff();
    factors_.row(i) *= scale_[i];
  }
  for (Index k = 0; k < n && !singular_; ++k) {
    Index pivot = k;
    const double size = factors_.col(k).tail(n - k).cwiseAbs().maxCoeff(&pivot);
    // Not `size == 0`: what is no number is refused, too.
    singular_ = !(size > 0.0 && std::isfinite(size));
    if (singular_) return;
    pivot += k;
    if (pivot != k) {
      factors_.row(k).swap(factors_.row(pivot));
      std::swap(order_[slot(k)], order_[slot(pivot)]);
    }
    for (Index i = k + 1; i < n; ++i) factors_(i, k) /= factors_(k, k);
    for (Index j = k + 1; j < n; ++j)
      factors_.col(j).tail(n - k - 1) -= factors_(k, j) * factors_.col(k).tail(n - k - 1);
  }
}

Values SmallLu::substitute(const Values& b) const {
  const Index n = b.size();
  Values x(n);
  for (Index i = 0; i < n; ++i) x[i] = scale_[order_[slot(i)]] * b[order_[slot(i)]];
  for (Index k = 0; k < n; ++k) x.tail(n - k - 1) -= x[k] * factors_.col(k).tail(n - k - 1);
  for (Index k = n - 1; k >= 0; --k) {
    x[k] /= factors_(k, k);
    x.head(k) -= x[k] * factors_.col(k).head(k);
  }
  return x;
}

Values SmallLu::solve(const Values& b) const {
  SEESAW_CHECK_EQ(b.size(), matrix_.rows());
  SEESAW_CHECK_EQ(singular_, false);
  Values x = substitute(b);
  Values missing = b;
  for (Index k = 0; k < x.size(); ++k) missing -= x[k] * matrix_.col(k);
  return x + substitute(missing);
}

}  // namespace seesaw
