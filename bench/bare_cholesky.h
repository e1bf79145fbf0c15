// What a fit cannot be faster than: the Cholesky factorization of an N x N matrix, by the BLAS that the fit
// uses.
//
// Deliberately not core/rbf/dense.h: the yardstick should not shrink with the thing that it measures.
#pragma once

#include "core/base/types.h"

#if defined(SEESAW_HAS_LAPACK)
#include <lapacke.h>
#else
#include <Eigen/Cholesky>
#endif

namespace seesaw::bench {

/// The lower triangle of a positive definite N x N matrix (the upper one is never touched).
inline void fill_definite(Eigen::MatrixXd& matrix) {
  const Index n = matrix.rows();
  for (Index j = 0; j < n; ++j) {
    for (Index i = j + 1; i < n; ++i) matrix(i, j) = 1.0 / static_cast<double>(1 + i - j);
    matrix(j, j) = static_cast<double>(n);
  }
}

inline void copy_lower(const Eigen::MatrixXd& from, Eigen::MatrixXd& to) {
  const Index n = from.rows();
  for (Index j = 0; j < n; ++j) to.col(j).tail(n - j) = from.col(j).tail(n - j);
}

inline void bare_cholesky(Eigen::MatrixXd& lower) {
#if defined(SEESAW_HAS_LAPACK)
  const auto n = static_cast<lapack_int>(lower.rows());
  LAPACKE_dpotrf_work(LAPACK_COL_MAJOR, 'L', n, lower.data(), n);
#else
  Eigen::LLT<Eigen::Ref<Eigen::MatrixXd> > in_place(lower);
#endif
}

}  // namespace seesaw::bench
