// A fit that leaves out what it cannot take, instead of refusing a whole scan for one bad point.
//
// Before it: thousands of constraints that no person has looked at.
// After it: a function, and how many constraints it goes without.
//
// A person who draws wants to hear that two constraints contradict each other (core/rbf/system.h). Of a scan
// nobody wants to: one of the two goes.
#pragma once

#include <optional>

#include "core/rbf/fit.h"

namespace seesaw {

struct TolerantFit {
  Fit<3> fitted;
  Index left_out = 0;  ///< normal constraints, and boundary constraints without one, that were taken out
};

/// Fits `constraints`; where the solver finds that some stand too near to each other, or contradict each
/// other, the last of them loses its normal constraint, or goes if it has none, and it tries again, up to 30
/// times. `constraints` is what was fitted in the end. Throws ConstraintError.
TolerantFit fit_tolerantly(Constraints<3>& constraints, const FitOptions& options = {});

}  // namespace seesaw
