// How ill-conditioned is a matrix whose factorization we have? An estimate of |A^-1|_1 from a few solves.
//
// Before it: a factored symmetric matrix.  After it: FitReport::reciprocal_condition = 1 / (|A|_1 |A^-1|_1).
//
// Hager's method as Higham gives it (ACM TOMS 14(4), 1988, algorithm 4.1): climb the convex function |A^-1
// x|_1 over the unit ball, corner by corner. It never overestimates, and is within a factor of three nearly
// always, exact mostly.
//
// The estimator does not solve: it says what it wants solved and takes the answer. So whoever solves for
// something else at the time can do both in one pass over the matrix.
//
//     InverseNorm estimate(n);
//     while (estimate.wants_solve()) estimate.take(solve(estimate.next()));
//     estimate.value();
#pragma once

#include "core/base/types.h"

namespace seesaw {

class InverseNorm {
 public:
  /// For a symmetric n x n matrix.
  explicit InverseNorm(Index n);

  /// True until the estimate stands.
  bool wants_solve() const { return step_ != Step::done; }
  /// The right side b (n) to be solved for.
  const Values& next() const { return right_side_; }
  /// A^-1 b for that b.
  void take(const Eigen::Ref<const Values>& solution);
  /// The largest |A^-1 x|_1 found, |x|_1 = 1.
  double value() const { return value_; }

 private:
  enum class Step { norm, gradient, done };

  Step step_;
  int climbs_ = 0;
  double value_ = 0.0;
  Index corner_ = -1;  // x is that unit vector; -1: all entries 1 / n
  Values right_side_;
};

}  // namespace seesaw
