#include "core/implicit/blobby_cylinders.h"

#include <algorithm>
#include <cmath>

#include "core/implicit/gaussian.h"

namespace seesaw {

template <int Dim>
NearestOnSegment<Dim>::NearestOnSegment(const Point<Dim>& x, const Point<Dim>& a, const Point<Dim>& b) {
  const Point<Dim> axis = b - a;
  const double square = axis.squaredNorm();
  along = square > 0 ? std::clamp((x - a).dot(axis) / square, 0.0, 1.0) : 0.5;
  away = x - a - along * axis;
}

template <int Dim>
BlobbyCylinders<Dim>::BlobbyCylinders(double threshold, const PointsRef<Dim>& starts,
                                      const PointsRef<Dim>& ends, const Eigen::Ref<const Values>& deviations)
    : threshold_(threshold), starts_(starts), ends_(ends), deviations_(deviations) {
  SEESAW_CHECK_EQ(starts_.cols(), deviations_.size());
  SEESAW_CHECK_EQ(ends_.cols(), deviations_.size());
  SEESAW_CHECK_GE(deviations_.size(), 1);
  SEESAW_CHECK_LT(0.0, deviations_.minCoeff());
}

template <int Dim>
void BlobbyCylinders<Dim>::evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values) const {
  this->check_shapes(points, values);
  for (Index i = 0; i < points.cols(); ++i) {
    double sum = -threshold_;
    for (Index k = 0; k < size(); ++k) {
      const NearestOnSegment<Dim> nearest(points.col(i), starts_.col(k), ends_.col(k));
      sum += std::exp(-nearest.away.squaredNorm() / (deviations_[k] * deviations_[k]));
    }
    values[i] = sum;
  }
}

template <int Dim>
void BlobbyCylinders<Dim>::evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values,
                                    Eigen::Ref<Points<Dim>> gradients) const {
  this->check_shapes(points, values);
  SEESAW_CHECK_EQ(points.cols(), gradients.cols());
  for (Index i = 0; i < points.cols(); ++i) {
    double sum = -threshold_;
    Point<Dim> slope = Point<Dim>::Zero();
    for (Index k = 0; k < size(); ++k) {
      const NearestOnSegment<Dim> nearest(points.col(i), starts_.col(k), ends_.col(k));
      const double square = deviations_[k] * deviations_[k];
      const double gaussian = std::exp(-nearest.away.squaredNorm() / square);
      sum += gaussian;
      slope -= 2 / square * gaussian * nearest.away;
    }
    values[i] = sum;
    gradients.col(i) = slope;
  }
}

template <int Dim>
double BlobbyCylinders<Dim>::gradient_bound(const Box<Dim>& box) const {
  if (box.isEmpty()) return 0.0;
  const Point<Dim> middle = box.center();
  const double radius = 0.5 * box.diagonal().norm();
  double slopes = 0, hessians = 0;
  for (Index k = 0; k < size(); ++k) {
    const double distance = NearestOnSegment<Dim>(middle, starts_.col(k), ends_.col(k)).away.norm();
    // Distances change by no more than the way.
    const auto bounds = gaussian_bounds(std::max(0.0, distance - radius), distance + radius, deviations_[k]);
    slopes += bounds.slope;
    hessians += bounds.hessian;
  }
  return std::min(slopes, this->gradient(middle).norm() + radius * hessians) * (1 + 1e-12);
}

template <int Dim>
Box<Dim> BlobbyCylinders<Dim>::bounding_box() const {
  const double count = static_cast<double>(size());
  const bool solid = threshold_ > 0 && threshold_ < count;
  const double reach = solid ? 1.05 * std::sqrt(std::log(count / threshold_)) : 3.0;
  Box<Dim> box;
  for (Index k = 0; k < size(); ++k) {
    const Point<Dim> room = Point<Dim>::Constant(reach * deviations_[k]);
    for (const auto& end : {starts_.col(k), ends_.col(k)})
      box.extend(Point<Dim>(end - room)).extend(Point<Dim>(end + room));
  }
  return box;
}

template struct NearestOnSegment<2>;
template struct NearestOnSegment<3>;
template class BlobbyCylinders<2>;
template class BlobbyCylinders<3>;

}  // namespace seesaw
