#include "core/implicit/blobby.h"

#include <algorithm>
#include <cmath>

#include "core/implicit/gaussian.h"

namespace seesaw {

template <int Dim>
BlobbySpheres<Dim>::BlobbySpheres(double threshold, const PointsRef<Dim>& centers,
                                  const Eigen::Ref<const Values>& deviations)
    : threshold_(threshold), centers_(centers), deviations_(deviations) {
  SEESAW_CHECK_EQ(centers_.cols(), deviations_.size());
  SEESAW_CHECK_GE(deviations_.size(), 1);
  SEESAW_CHECK_LT(0.0, deviations_.minCoeff());
}

template <int Dim>
double BlobbySpheres<Dim>::deviation_for(double radius, double threshold) {
  SEESAW_CHECK_LT(0.0, threshold);
  SEESAW_CHECK_LT(threshold, 1.0);
  return radius / std::sqrt(-std::log(threshold));
}

template <int Dim>
void BlobbySpheres<Dim>::evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values) const {
  this->check_shapes(points, values);
  for (Index i = 0; i < points.cols(); ++i) {
    double sum = -threshold_;
    for (Index k = 0; k < size(); ++k)
      sum += std::exp(-(points.col(i) - centers_.col(k)).squaredNorm() / (deviations_[k] * deviations_[k]));
    values[i] = sum;
  }
}

template <int Dim>
void BlobbySpheres<Dim>::evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values,
                                  Eigen::Ref<Points<Dim>> gradients) const {
  this->check_shapes(points, values);
  SEESAW_CHECK_EQ(points.cols(), gradients.cols());
  for (Index i = 0; i < points.cols(); ++i) {
    double sum = -threshold_;
    Point<Dim> slope = Point<Dim>::Zero();
    for (Index k = 0; k < size(); ++k) {
      const Point<Dim> away = points.col(i) - centers_.col(k);
      const double square = deviations_[k] * deviations_[k];
      const double gaussian = std::exp(-away.squaredNorm() / square);
      sum += gaussian;
      slope -= 2 / square * gaussian * away;
    }
    values[i] = sum;
    gradients.col(i) = slope;
  }
}

template <int Dim>
double BlobbySpheres<Dim>::gradient_bound(const Box<Dim>& box) const {
  if (box.isEmpty()) return 0.0;
  const Point<Dim> middle = box.center();
  const double radius = 0.5 * box.diagonal().norm();
  double slopes = 0, hessians = 0;
  for (Index k = 0; k < size(); ++k) {
    const double s = deviations_[k];
    const Point<Dim> center = centers_.col(k);
    const Point<Dim> reach = (box.min() - center).cwiseAbs().cwiseMax((box.max() - center).cwiseAbs());
    const GaussianBounds bounds = gaussian_bounds(box.exteriorDistance(center), reach.norm(), s);
    slopes += bounds.slope;
    hessians += bounds.hessian;
  }
  return std::min(slopes, this->gradient(middle).norm() + radius * hessians) * (1 + 1e-12);
}

template <int Dim>
Box<Dim> BlobbySpheres<Dim>::bounding_box() const {
  const double count = static_cast<double>(size());
  const bool solid = threshold_ > 0 && threshold_ < count;
  const double reach = solid ? 1.05 * std::sqrt(std::log(count / threshold_)) : 3.0;
  Box<Dim> box;
  for (Index k = 0; k < size(); ++k) {
    const Point<Dim> room = Point<Dim>::Constant(reach * deviations_[k]);
    box.extend(Point<Dim>(centers_.col(k) - room)).extend(Point<Dim>(centers_.col(k) + room));
  }
  return box;
}

template class BlobbySpheres<2>;
template class BlobbySpheres<3>;

}  // namespace seesaw
