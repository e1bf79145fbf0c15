#include "core/rbf/inverse_norm.h"

#include <cmath>

namespace seesaw {

InverseNorm::InverseNorm(Index n)
    : step_(n == 0 ? Step::done : Step::norm),
      right_side_(Values::Constant(n, n == 0 ? 0.0 : 1.0 / static_cast<double>(n))) {}

void InverseNorm::take(const Eigen::Ref<const Values>& solution) {
  if (step_ == Step::norm) {  // y = A^-1 x
    const double norm = solution.lpNorm<1>();
    const bool higher = norm > value_;
    value_ = std::max(value_, norm);
    // One climb: a second one gains nothing nearly always, and costs two more solves.
    if (!higher || climbs_ == 1 || !std::isfinite(norm)) {
      step_ = Step::done;
      return;
    }
    right_side_ = (solution.array() < 0).select(Values::Constant(solution.size(), -1.0), 1.0);
    step_ = Step::gradient;
    return;
  }
  // z = A^-T sign(y), the gradient: the steepest corner, unless x is the best already.
  Index steepest = 0;
  const double slope = solution.cwiseAbs().maxCoeff(&steepest);
  const double here = corner_ < 0 ? solution.mean() : solution[corner_];
  if (steepest == corner_ || slope <= here) {
    step_ = Step::done;
    return;
  }
  corner_ = steepest;
  ++climbs_;
  right_side_ = Values::Unit(solution.size(), steepest);
  step_ = Step::norm;
}

}  // namespace seesaw
