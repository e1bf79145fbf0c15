#include "core/implicit/blobby.h"

#include <algorithm>
#include <cmath>

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
    // In units of s: the nearest and farthest distance of the box from the center.
    const double near = box.exteriorDistance(center) / s;
    const Point<Dim> reach = (box.min() - center).cwiseAbs().cwiseMax((box.max() - center).cwiseAbs());
    const double far = reach.norm() / s;
    // |grad g| = 2 d exp(-d^2) / s rises to d = sqrt(1/2) and falls from there.
    const double steepest = std::clamp(std::sqrt(0.5), near, far);
    slopes += 2 * steepest * std::exp(-steepest * steepest) / s;
    // The Hessian's eigenvalues are -2 exp(-u) / s^2 across and 2 (2 u - 1) exp(-u) / s^2 along the radius,
    // u = d^2; the first falls in size, the second is largest at u = 3/2.
    const double u = std::clamp(1.5, near * near, far * far);
    const double largest = std::max(std::exp(-near * near), (2 * u - 1) * std::exp(-u));
    hessians += 2 * largest / (s * s);
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
