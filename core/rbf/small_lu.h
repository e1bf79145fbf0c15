// A linear system of a few dozen unknowns, of any kind: Eigen's LU with rows scaled to one size, and one step
// of refinement.
//
// Before it: a small square matrix.  After it: core/rbf/border.h, whose Schur complement is indefinite (a
// removed row is a negative pivot, an added one a positive) and has entries of very different sizes.
#pragma once

#include <memory>

#include "core/base/types.h"

namespace seesaw {

class SmallLu {
 public:
  explicit SmallLu(Eigen::MatrixXd matrix);
  ~SmallLu();

  /// True where a pivot vanished or was no number: nothing can be solved then.
  bool singular() const;
  /// x with matrix x = b.
  Values solve(const Values& b) const;

 private:
  struct Factors;  // keeps Eigen's decompositions out of what others compile

  Eigen::MatrixXd matrix_;
  Values scale_;  // of the rows
  std::unique_ptr<Factors> factors_;
};

}  // namespace seesaw
