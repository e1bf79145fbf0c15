// The dense linear algebra that a fit needs, on BLAS and LAPACK where they are installed, on Eigen where they
// are not. Those libraries pick the processor's instructions at run time; what we compile ourselves may not.
//
// A symmetric matrix is its lower triangle, column by column.
#pragma once

#include <functional>
#include <memory>

#include "core/base/types.h"

namespace seesaw::dense {

/// A square matrix of which only the lower triangle means anything; not initialized. n^2 doubles, in large
/// pages where the system has them: a new matrix of 100 MB otherwise costs 25,000 page faults, a tenth of its
/// factorization.
class Symmetric {
 public:
  explicit Symmetric(Index n);

  Index size() const { return n_; }
  /// Entry (i, j) is `data()[i + j * size()]`, i >= j.
  double* data() { return memory_.get(); }
  const double* data() const { return memory_.get(); }
  /// Rows i .. n - 1 of column j.
  Eigen::Map<Values> column_from(Index i, Index j) { return {data() + i + j * n_, n_ - i}; }

 private:
  struct Free {
    void operator()(double* memory) const;
  };
  Index n_;
  std::unique_ptr<double[], Free> memory_;
};

/// Writes columns begin .. begin + count - 1, on and below the diagonal. Called from any thread.
using FillColumns = std::function<void(Index begin, Index count)>;

/// Fills A and returns A X, of A n x n and X n x m with small m: what has just been written is multiplied
/// while it is in the cache. `fill` is called once for every column.
Eigen::MatrixXd fill_and_multiply(Symmetric& a, const FillColumns& fill, const Eigen::MatrixXd& x);

// The following look at the trailing block of A: rows and columns `first` .. n - 1, n - first of them.

/// A := A - U V' - V U', U and V n x m with small m. Returns the 1-norm of the trailing block, its largest
/// absolute column sum.
double subtract_products(Symmetric& a, const Eigen::MatrixXd& u, const Eigen::MatrixXd& v, Index first);

/// Overwrites the block with L, block = L L'. False where it is not positive definite (to rounding). About
/// (n - first)^3 / 3 multiplications.
bool cholesky(Symmetric& a, Index first);

/// x := block^-1 x for each column of x, (n - first) x m, given L. The matrix is read once however many
/// columns.
void solve(const Symmetric& a, Index first, Eigen::Ref<Eigen::MatrixXd> x);

/// "BLAS" or "Eigen".
const char* name();

}  // namespace seesaw::dense
