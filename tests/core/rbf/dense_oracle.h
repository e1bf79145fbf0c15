// Dense algebra by another road than the solver's, for tests to compare with: LU, not Cholesky. In a file of
// its own because the templates behind it take a compiler ten seconds.
#pragma once

#include "core/base/types.h"

namespace seesaw {

/// x with a x = b, by LU with complete pivoting.
Values solve_by_lu(const Eigen::MatrixXd& a, const Values& b);
/// a^-1, by the same.
Eigen::MatrixXd inverse_by_lu(const Eigen::MatrixXd& a);

}  // namespace seesaw
