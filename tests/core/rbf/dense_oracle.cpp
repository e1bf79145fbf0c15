#include "tests/core/rbf/dense_oracle.h"

#include <Eigen/LU>

namespace seesaw {

Values solve_by_lu(const Eigen::MatrixXd& a, const Values& b) { return a.fullPivLu().solve(b); }

Eigen::MatrixXd inverse_by_lu(const Eigen::MatrixXd& a) { return a.fullPivLu().inverse(); }

}  // namespace seesaw
