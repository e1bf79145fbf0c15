// The dense linear algebra that a fit needs. The algorithms are written once, strip by strip; their steps are
// BLAS and LAPACK where they are installed, Eigen where they are not (dense_steps.h).
//
// A symmetric matrix is its lower triangle, and little more than that is stored: its columns are cut into
// strips, each of which begins at its own diagonal. Half the memory is half the pages that the system has to
// clear, and within a strip everything is an ordinary column-major matrix.
//
//        +----+
//        | \  |            strip t: columns t w .. t w + w - 1, rows from t w on,
//        |  \ +----+       its columns n - t w numbers apart
//        |    | \  |
//        |    |  \ +---+
//        +----+----+---+
//
// Before it: core/rbf/matrix_memory.h, and whoever fills a matrix.  After it: core/rbf/solve.h.
#pragma once

#include <functional>

#include "core/base/progress.h"
#include "core/base/types.h"
#include "core/rbf/matrix_memory.h"

namespace seesaw::dense {

/// A square matrix of which only the lower triangle means anything; not initialized. About n^2 / 2 doubles.
class Symmetric {
 public:
  /// Columns in a strip.
  static constexpr Index strip = 384;

  explicit Symmetric(Index n) : n_(n), memory_(matrix_memory(stored())) {}

  Index size() const { return n_; }
  /// How many doubles are stored.
  Index stored() const { return start_of((n_ + strip - 1) / strip); }
  double* data() { return memory_.get(); }
  /// Entry (i, j), i not above the strip of j. Entries of one column follow each other; those of one row in
  /// one strip are stride(j) apart.
  double* at(Index i, Index j) {
    return memory_.get() + start_of(j / strip) + (i - first_row(j)) + (j % strip) * stride(j);
  }
  const double* at(Index i, Index j) const { return const_cast<Symmetric*>(this)->at(i, j); }
  Index stride(Index j) const { return n_ - first_row(j); }
  /// Rows i .. n - 1 of column j.
  Eigen::Map<Values> column_from(Index i, Index j) { return {at(i, j), n_ - i}; }
  Eigen::Map<const Values> column_from(Index i, Index j) const { return {at(i, j), n_ - i}; }

 private:
  static Index first_row(Index j) { return j / strip * strip; }
  // Strips 0 .. t - 1 have strip * (n + (n - strip) + ...) numbers. (The last may be narrower.)
  Index start_of(Index t) const { return strip * (t * n_ - strip * (t * (t - 1) / 2)); }

  Index n_;
  MatrixMemory memory_;
};

// What goes through a whole matrix says how far it is, some hundred times and from the calling thread, and
// can be stopped: it then ends with Cancelled, some 10 ms later, and what it had in hand is of no more use.

/// Writes columns begin .. begin + count - 1, on and below the diagonal. Called from any thread.
using FillColumns = std::function<void(Index begin, Index count)>;

/// Fills A and returns A X, of A n x n and X n x m with small m: what has just been written is multiplied
/// while it is in the cache. `fill` is called once for every column.
Eigen::MatrixXd fill_and_multiply(Symmetric& a, const FillColumns& fill, const Eigen::MatrixXd& x,
                                  const Progress& progress = {});

// The following look at the trailing block of A: rows and columns `first` .. n - 1, n - first of them.

/// A := A - U V' - V U', U and V n x m with small m. Returns the 1-norm of the trailing block, its largest
/// absolute column sum.
double subtract_products(Symmetric& a, const Eigen::MatrixXd& u, const Eigen::MatrixXd& v, Index first,
                         const Progress& progress = {});

/// Overwrites the block with L, block = L L'. False where it is not positive definite (to rounding). About
/// (n - first)^3 / 3 multiplications.
bool cholesky(Symmetric& a, Index first, const Progress& progress = {});

/// x := block^-1 x for each column of x, (n - first) x m, given L. The matrix is read once however many
/// columns.
void solve(const Symmetric& a, Index first, Eigen::Ref<Eigen::MatrixXd> x, const Progress& progress = {});

/// "BLAS" or "Eigen".
const char* name();

}  // namespace seesaw::dense
