#include "core/implicit/booleans.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace seesaw {

template <int Dim>
Boolean<Dim>::Boolean(std::vector<FieldPointer<Dim>> leaves, std::vector<double> inner, double outer)
    : leaves_(std::move(leaves)), inner_(std::move(inner)), outer_(outer) {
  SEESAW_CHECK_GE(leaves_.size(), std::size_t{1});
  SEESAW_CHECK_EQ(leaves_.size(), inner_.size());
  for (const FieldPointer<Dim>& leaf : leaves_) SEESAW_CHECK_EQ(leaf == nullptr, false);
}

template <int Dim>
void Boolean<Dim>::evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values) const {
  this->check_shapes(points, values);
  Values each(points.cols());
  for (std::size_t k = 0; k < leaves_.size(); ++k) {
    leaves_[k]->evaluate(points, each);
    if (k == 0)
      values = inner_[k] * each;
    else
      values = values.cwiseMax(inner_[k] * each);
  }
  values *= outer_;
}

template <int Dim>
void Boolean<Dim>::evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values,
                            Eigen::Ref<Points<Dim>> gradients) const {
  this->check_shapes(points, values);
  SEESAW_CHECK_EQ(points.cols(), gradients.cols());
  Values each(points.cols());
  Points<Dim> slopes(Dim, points.cols());
  for (std::size_t k = 0; k < leaves_.size(); ++k) {
    leaves_[k]->evaluate(points, each, slopes);
    for (Index i = 0; i < points.cols(); ++i) {
      const double value = inner_[k] * each[i];
      if (k > 0 && !(value > values[i])) continue;
      values[i] = value;
      gradients.col(i) = outer_ * inner_[k] * slopes.col(i);
    }
  }
  values *= outer_;
}

template <int Dim>
std::vector<int> Boolean<Dim>::winners(const PointsRef<Dim>& points) const {
  std::vector<int> result(static_cast<std::size_t>(points.cols()), 0);
  Values each(points.cols()), best(points.cols());
  for (std::size_t k = 0; k < leaves_.size(); ++k) {
    leaves_[k]->evaluate(points, each);
    for (Index i = 0; i < points.cols(); ++i) {
      const double value = inner_[k] * each[i];
      if (k > 0 && !(value > best[i])) continue;
      best[i] = value;
      result[static_cast<std::size_t>(i)] = static_cast<int>(k);
    }
  }
  return result;
}

template <int Dim>
double Boolean<Dim>::gradient_bound(const Box<Dim>& box) const {
  if (box.isEmpty()) return 0.0;
  const Point<Dim> middle = box.center();
  const double radius = 0.5 * box.diagonal().norm();
  // A winner is nowhere below the best of all lower limits.
  std::vector<double> bounds, highest;
  double floor = -infinity;
  for (std::size_t k = 0; k < leaves_.size(); ++k) {
    const double value = inner_[k] * leaves_[k]->value(middle);
    bounds.push_back(leaves_[k]->gradient_bound(box));
    // A little more than |grad| R, for the rounding of the value.
    const double change = radius > 0 ? bounds[k] * radius * (1 + 1e-12) + 1e-12 * std::abs(value) : 0.0;
    highest.push_back(value + change);
    floor = std::max(floor, value - change);
  }
  double bound = 0.0;
  for (std::size_t k = 0; k < leaves_.size(); ++k)
    if (!(highest[k] < floor)) bound = std::max(bound, bounds[k]);
  return bound;
}

namespace {

std::vector<double> signs(std::size_t n, double sign) { return std::vector<double>(n, sign); }

}  // namespace

template <int Dim>
Union<Dim>::Union(std::vector<FieldPointer<Dim>> leaves)
    : Boolean<Dim>(leaves, signs(leaves.size(), 1.0), 1.0) {}

template <int Dim>
Box<Dim> Union<Dim>::bounding_box() const {
  Box<Dim> box;
  for (const FieldPointer<Dim>& leaf : this->leaves()) box.extend(leaf->bounding_box());
  return box;
}

template <int Dim>
Intersection<Dim>::Intersection(std::vector<FieldPointer<Dim>> leaves)
    : Boolean<Dim>(leaves, signs(leaves.size(), -1.0), -1.0) {}

template <int Dim>
Box<Dim> Intersection<Dim>::bounding_box() const {
  Box<Dim> box = this->leaves().front()->bounding_box();
  for (const FieldPointer<Dim>& leaf : this->leaves()) box = box.intersection(leaf->bounding_box());
  return box.isEmpty() ? Box<Dim>() : box;
}

template <int Dim>
Difference<Dim>::Difference(FieldPointer<Dim> solid, FieldPointer<Dim> tool)
    : Boolean<Dim>({std::move(solid), std::move(tool)}, {-1.0, 1.0}, -1.0) {}

template <int Dim>
Box<Dim> Difference<Dim>::bounding_box() const {
  return this->leaves().front()->bounding_box();
}

template class Boolean<2>;
template class Boolean<3>;
template class Union<2>;
template class Union<3>;
template class Intersection<2>;
template class Intersection<3>;
template class Difference<2>;
template class Difference<3>;

}  // namespace seesaw
