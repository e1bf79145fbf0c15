#include "core/rbf/dense.h"

#if defined(SEESAW_HAS_LAPACK)
#include <lapacke.h>
#else
#include <Eigen/Cholesky>
#endif

namespace seesaw::dense {

#if defined(SEESAW_HAS_LAPACK)

// The _work variants: the others scan the whole matrix for NaN before they begin.

double norm1(const double* lower, Index n, Index stride) {
  if (n == 0) return 0.0;
  Values work(n);
  return LAPACKE_dlansy_work(LAPACK_COL_MAJOR, '1', 'L', static_cast<lapack_int>(n), lower,
                             static_cast<lapack_int>(stride), work.data());
}

bool cholesky(double* lower, Index n, Index stride) {
  return n == 0 || LAPACKE_dpotrf_work(LAPACK_COL_MAJOR, 'L', static_cast<lapack_int>(n), lower,
                                       static_cast<lapack_int>(stride)) == 0;
}

void solve(const double* cholesky, Index n, Index stride, double* x) {
  if (n == 0) return;
  LAPACKE_dpotrs_work(LAPACK_COL_MAJOR, 'L', static_cast<lapack_int>(n), 1, cholesky,
                      static_cast<lapack_int>(stride), x, static_cast<lapack_int>(n));
}

double reciprocal_condition(const double* cholesky, Index n, Index stride, double norm1) {
  if (n == 0) return 1.0;
  double result = 0;
  Values work(3 * n);
  Eigen::Matrix<lapack_int, Eigen::Dynamic, 1> integers(n);
  LAPACKE_dpocon_work(LAPACK_COL_MAJOR, 'L', static_cast<lapack_int>(n), cholesky,
                      static_cast<lapack_int>(stride), norm1, &result, work.data(), integers.data());
  return result;
}

const char* name() { return "LAPACK"; }

#else

namespace {

using Map = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<> >;
using ConstMap = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<> >;

// A = L L' given L, with the three members that Eigen's condition estimator asks of a factorization.
struct Factored {
  ConstMap l;
  Index rows() const { return l.rows(); }
  const Factored& adjoint() const { return *this; }
  Values solve(const Values& b) const {
    Values x = l.triangularView<Eigen::Lower>().solve(b);
    l.transpose().triangularView<Eigen::Upper>().solveInPlace(x);
    return x;
  }
};

// Hager's estimate of |A^-1|_1 as Higham gives it (ACM TOMS 14(4), 1988, algorithm 4.1).
double inverse_norm1(const Factored& a) {
  const Index n = a.rows();
  Values x = Values::Constant(n, 1.0 / static_cast<double>(n));
  double estimate = 0;
  Index last = -1;
  for (int step = 0; step < 5; ++step) {
    const Values y = a.solve(x);
    estimate = std::max(estimate, y.lpNorm<1>());
    const Values z = a.solve((y.array() < 0).select(Values::Constant(n, -1.0), Values::Constant(n, 1.0)));
    Index largest = 0;
    const double top = z.cwiseAbs().maxCoeff(&largest);
    if (largest == last || top <= z.dot(x)) break;
    x = Values::Unit(n, last = largest);
  }
  return estimate;
}

}  // namespace

double norm1(const double* lower, Index n, Index stride) {
  const ConstMap a(lower, n, n, Eigen::OuterStride<>(stride));
  Values sums = Values::Zero(n);
  for (Index j = 0; j < n; ++j) {
    sums[j] += a.col(j).tail(n - j).lpNorm<1>();
    sums.tail(n - j - 1) += a.col(j).tail(n - j - 1).cwiseAbs();
  }
  return n == 0 ? 0.0 : sums.maxCoeff();
}

bool cholesky(double* lower, Index n, Index stride) {
  Map a(lower, n, n, Eigen::OuterStride<>(stride));
  return Eigen::LLT<Eigen::Ref<Eigen::MatrixXd, 0, Eigen::OuterStride<> > >(a).info() == Eigen::Success;
}

void solve(const double* cholesky, Index n, Index stride, double* x) {
  Eigen::Map<Values> unknowns(x, n);
  unknowns = Factored{ConstMap(cholesky, n, n, Eigen::OuterStride<>(stride))}.solve(unknowns);
}

double reciprocal_condition(const double* cholesky, Index n, Index stride, double norm1) {
  if (n == 0) return 1.0;
  const double inverse = inverse_norm1({ConstMap(cholesky, n, n, Eigen::OuterStride<>(stride))});
  return 1.0 / (norm1 * inverse);
}

const char* name() { return "Eigen"; }

#endif

}  // namespace seesaw::dense
