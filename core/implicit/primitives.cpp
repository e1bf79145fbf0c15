#include "core/implicit/primitives.h"

namespace seesaw {

template <int Dim>
Sphere<Dim>::Sphere(const Point<Dim>& center, double radius) : center_(center), radius_(radius) {
  SEESAW_CHECK_LT(0.0, radius);
}

template <int Dim>
void Sphere<Dim>::evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values) const {
  this->check_shapes(points, values);
  for (Index i = 0; i < points.cols(); ++i) values[i] = radius_ - (points.col(i) - center_).norm();
}

template <int Dim>
void Sphere<Dim>::evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values,
                           Eigen::Ref<Points<Dim>> gradients) const {
  SEESAW_CHECK_EQ(points.cols(), gradients.cols());
  evaluate(points, values);
  for (Index i = 0; i < points.cols(); ++i) {
    const Point<Dim> away = points.col(i) - center_;
    const double distance = away.norm();
    gradients.col(i) = distance > 0 ? Point<Dim>(-away / distance) : Point<Dim>::Zero();
  }
}

template <int Dim>
double Sphere<Dim>::gradient_bound(const Box<Dim>&) const {
  return 1.0;
}

template <int Dim>
Box<Dim> Sphere<Dim>::bounding_box() const {
  const Point<Dim> reach = Point<Dim>::Constant(1.25 * radius_);
  return Box<Dim>(center_ - reach, center_ + reach);
}

template class Sphere<2>;
template class Sphere<3>;

}  // namespace seesaw
