#include "core/implicit/torus.h"

#include <cmath>

namespace seesaw {

Torus::Torus(const Point<3>& center, const Point<3>& axis, double major, double minor)
    : center_(center), axis_(axis.normalized()), major_(major), minor_(minor) {
  SEESAW_CHECK_LT(0.0, axis.norm());
  SEESAW_CHECK_LT(0.0, minor);
  SEESAW_CHECK_LT(minor, major);
}

void Torus::evaluate(const PointsRef<3>& points, Eigen::Ref<Values> values) const {
  check_shapes(points, values);
  for (Index i = 0; i < points.cols(); ++i) {
    const Point<3> x = points.col(i) - center_;
    const double height = x.dot(axis_);
    values[i] = minor_ - std::hypot((x - height * axis_).norm() - major_, height);
  }
}

void Torus::evaluate(const PointsRef<3>& points, Eigen::Ref<Values> values,
                     Eigen::Ref<Points<3>> gradients) const {
  SEESAW_CHECK_EQ(points.cols(), gradients.cols());
  evaluate(points, values);
  for (Index i = 0; i < points.cols(); ++i) {
    const Point<3> x = points.col(i) - center_;
    const double height = x.dot(axis_);
    const Point<3> outward = x - height * axis_;
    const double rho = outward.norm();
    const double distance = std::hypot(rho - major_, height);
    gradients.col(i).setZero();
    if (rho > 0 && distance > 0)
      gradients.col(i) = -((rho - major_) / rho * outward + height * axis_) / distance;
  }
}

double Torus::gradient_bound(const Box<3>&) const { return 1.0; }

Box<3> Torus::bounding_box() const {
  // A circle perpendicular to the axis reaches R sqrt(1 - a_d^2) along coordinate d.
  const Point<3> circle = major_ * (1 - axis_.array().square()).max(0).sqrt();
  const Point<3> reach = circle.array() + 1.25 * minor_;
  return Box<3>(center_ - reach, center_ + reach);
}

}  // namespace seesaw
