#include "core/implicit/parametric_shapes.h"

#include <algorithm>
#include <cmath>

namespace seesaw {
namespace {

// Gaussians are even in s. Below this its powers are no doubles.
double size_of(double s) { return std::max(std::abs(s), 1e-100); }

template <int Dim>
Values q_of(const BlobbySpheres<Dim>& shape) {
  Eigen::MatrixXd blobs(Dim + 1, shape.size());
  blobs << shape.centers(), shape.deviations().transpose();
  Values q(1 + blobs.size());
  q << shape.threshold(), blobs.reshaped();
  return q;
}

template <int Dim>
Values q_of(const BlobbyCylinders<Dim>& shape) {
  Eigen::MatrixXd blobs(2 * Dim + 1, shape.size());
  blobs << shape.starts(), shape.ends(), shape.deviations().transpose();
  Values q(1 + blobs.size());
  q << shape.threshold(), blobs.reshaped();
  return q;
}

// Column k: the numbers of blob k.
template <int Rows>
Eigen::Map<const Eigen::Matrix<double, Rows, Eigen::Dynamic>> blobs_of(const Values& q) {
  return {q.data() + 1, Rows, (q.size() - 1) / Rows};
}

Values deviations_of(const Eigen::Ref<const Eigen::RowVectorXd, 0, Eigen::InnerStride<>>& signed_ones) {
  return signed_ones.unaryExpr(&size_of).transpose();
}

}  // namespace

template <int Dim>
ParametricSphere<Dim>::ParametricSphere(const Point<Dim>& center, double radius)
    : center_(center), radius_(radius) {
  this->start(Dim + 1);
}

template <int Dim>
void ParametricSphere<Dim>::evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values) const {
  this->check_shapes(points, values);
  values = (radius_ * radius_ - (points.colwise() - center_).colwise().squaredNorm().array()).transpose();
}

template <int Dim>
void ParametricSphere<Dim>::evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values,
                                     Eigen::Ref<Points<Dim>> gradients) const {
  evaluate(points, values);
  SEESAW_CHECK_EQ(points.cols(), gradients.cols());
  gradients = -2 * (points.colwise() - center_);
}

template <int Dim>
double ParametricSphere<Dim>::gradient_bound(const Box<Dim>& box) const {
  if (box.isEmpty()) return 0.0;
  return 2 * (box.min() - center_).cwiseAbs().cwiseMax((box.max() - center_).cwiseAbs()).norm() * (1 + 1e-15);
}

template <int Dim>
Box<Dim> ParametricSphere<Dim>::bounding_box() const {
  const Point<Dim> room = Point<Dim>::Constant(1.1 * std::abs(radius_));
  return {center_ - room, center_ + room};
}

template <int Dim>
std::vector<std::string> ParametricSphere<Dim>::names() const {
  std::vector<std::string> names;
  append_coordinate_names<Dim>("c", names);
  names.push_back("r");
  return names;
}

template <int Dim>
Values ParametricSphere<Dim>::all() const {
  Values q(Dim + 1);
  q << center_, radius_;
  return q;
}

template <int Dim>
void ParametricSphere<Dim>::set_all(const Values& values) {
  center_ = values.head<Dim>();
  radius_ = values[Dim];
}

// f_c = 2 (x - c), f_r = 2 r.
template <int Dim>
Eigen::MatrixXd ParametricSphere<Dim>::all_gradients(const PointsRef<Dim>& points) const {
  Eigen::MatrixXd result(Dim + 1, points.cols());
  result.topRows(Dim) = 2 * (points.colwise() - center_);
  result.row(Dim).setConstant(2 * radius_);
  return result;
}

template <int Dim>
ParametricBlobbySpheres<Dim>::ParametricBlobbySpheres(const BlobbySpheres<Dim>& shape)
    : ParametricBlobs<Dim, BlobbySpheres<Dim>>(shape, q_of(shape)) {}

template <int Dim>
std::vector<std::string> ParametricBlobbySpheres<Dim>::names() const {
  std::vector<std::string> names = {"bias"};
  for (Index k = 0; k < this->shape_.size(); ++k) {
    append_coordinate_names<Dim>("c" + std::to_string(k), names);
    names.push_back("s" + std::to_string(k));
  }
  return names;
}

template <int Dim>
void ParametricBlobbySpheres<Dim>::set_all(const Values& values) {
  const auto blobs = blobs_of<Dim + 1>(values);
  this->shape_ = BlobbySpheres<Dim>(values[0], blobs.template topRows<Dim>(), deviations_of(blobs.row(Dim)));
  this->all_ = values;
}

// f_b = -1, f_c = 2 (x - c) / s^2 g, f_s = 2 |x - c|^2 / s^3 g.
template <int Dim>
Eigen::MatrixXd ParametricBlobbySpheres<Dim>::all_gradients(const PointsRef<Dim>& points) const {
  const auto blobs = blobs_of<Dim + 1>(this->all_);
  Eigen::MatrixXd result(this->all_.size(), points.cols());
  result.row(0).setConstant(-1);
  for (Index i = 0; i < points.cols(); ++i)
    for (Index k = 0; k < blobs.cols(); ++k) {
      const Point<Dim> away = points.col(i) - blobs.col(k).template head<Dim>();
      const double s = std::copysign(size_of(blobs(Dim, k)), blobs(Dim, k));
      const double slope = 2 / (s * s) * std::exp(-away.squaredNorm() / (s * s));
      result.col(i).template segment<Dim + 1>(1 + (Dim + 1) * k) << slope * away,
          slope * away.squaredNorm() / s;
    }
  return result;
}

template <int Dim>
ParametricBlobbyCylinders<Dim>::ParametricBlobbyCylinders(const BlobbyCylinders<Dim>& shape)
    : ParametricBlobs<Dim, BlobbyCylinders<Dim>>(shape, q_of(shape)) {}

template <int Dim>
std::vector<std::string> ParametricBlobbyCylinders<Dim>::names() const {
  std::vector<std::string> names = {"bias"};
  for (Index k = 0; k < this->shape_.size(); ++k) {
    append_coordinate_names<Dim>("a" + std::to_string(k), names);
    append_coordinate_names<Dim>("b" + std::to_string(k), names);
    names.push_back("s" + std::to_string(k));
  }
  return names;
}

template <int Dim>
void ParametricBlobbyCylinders<Dim>::set_all(const Values& values) {
  const auto blobs = blobs_of<2 * Dim + 1>(values);
  this->shape_ = BlobbyCylinders<Dim>(values[0], blobs.template topRows<Dim>(),
                                      blobs.template middleRows<Dim>(Dim), deviations_of(blobs.row(2 * Dim)));
  this->all_ = values;
}

// e = (1 - u) a + u b is where the distance is least, so a change of u changes it by nothing in first order:
// f_a = (1 - u) 2 (x - e) / s^2 g, f_b = u 2 (x - e) / s^2 g.
template <int Dim>
Eigen::MatrixXd ParametricBlobbyCylinders<Dim>::all_gradients(const PointsRef<Dim>& points) const {
  const auto blobs = blobs_of<2 * Dim + 1>(this->all_);
  Eigen::MatrixXd result(this->all_.size(), points.cols());
  result.row(0).setConstant(-1);
  for (Index i = 0; i < points.cols(); ++i)
    for (Index k = 0; k < blobs.cols(); ++k) {
      const NearestOnSegment<Dim> nearest(points.col(i), blobs.col(k).template head<Dim>(),
                                          blobs.col(k).template segment<Dim>(Dim));
      const double s = std::copysign(size_of(blobs(2 * Dim, k)), blobs(2 * Dim, k));
      const double square = nearest.away.squaredNorm();
      const double slope = 2 / (s * s) * std::exp(-square / (s * s));
      result.col(i).template segment<2 * Dim + 1>(1 + (2 * Dim + 1) * k)
          << (1 - nearest.along) * slope * nearest.away,
          nearest.along * slope * nearest.away, slope * square / s;
    }
  return result;
}

template class ParametricSphere<2>;
template class ParametricSphere<3>;
template class ParametricBlobbySpheres<2>;
template class ParametricBlobbySpheres<3>;
template class ParametricBlobbyCylinders<2>;
template class ParametricBlobbyCylinders<3>;

}  // namespace seesaw
