// A linear system of a few dozen unknowns, of any kind: LU with rows scaled to one size and partial pivoting,
// and one step of refinement.
//
// Before it: a small square matrix.  After it: core/rbf/border.h, whose Schur complement is indefinite (a
// removed row is a negative pivot, an added one a positive) and has entries of very different sizes.
#pragma once

#include <vector>

#include "core/base/types.h"

namespace seesaw {

class SmallLu {
 public:
  explicit SmallLu(Eigen::MatrixXd matrix);

  /// True where a pivot vanished or was no number: nothing can be solved then.
  bool singular() const { return singular_; }
  /// x with matrix x = b.
  Values solve(const Values& b) const;

 private:
  Values substitute(const Values& b) const;

  Eigen::MatrixXd matrix_, factors_;  // factors_: L below the diagonal, U on and above
  Values scale_;                      // of the rows
  std::vector<Index> order_;          // row i of the factors is row order_[i] of the matrix
  bool singular_ = false;
};

}  // namespace seesaw
