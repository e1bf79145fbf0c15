#include "core/rbf/small_lu.h"

#include <Eigen/LU>

#include "core/base/check.h"

namespace seesaw {

struct SmallLu::Factors {
  Eigen::PartialPivLU<Eigen::MatrixXd> lu;
};

SmallLu::SmallLu(Eigen::MatrixXd matrix)
    : matrix_(std::move(matrix)), scale_(matrix_.cwiseAbs().rowwise().maxCoeff().cwiseInverse()) {
  SEESAW_CHECK_EQ(matrix_.rows(), matrix_.cols());
  factors_ = std::make_unique<Factors>(Factors{(scale_.asDiagonal() * matrix_).lu()});
}

SmallLu::~SmallLu() = default;

bool SmallLu::singular() const {
  const auto pivots = factors_->lu.matrixLU().diagonal().array();
  return !(pivots.isFinite() && pivots != 0).all();
}

Values SmallLu::solve(const Values& b) const {
  SEESAW_CHECK_EQ(b.size(), matrix_.rows());
  SEESAW_CHECK_EQ(singular(), false);
  const auto substitute = [&](const Values& right) -> Values {
    return factors_->lu.solve(scale_.cwiseProduct(right));
  };
  const Values x = substitute(b);
  return x + substitute(b - matrix_ * x);
}

}  // namespace seesaw
