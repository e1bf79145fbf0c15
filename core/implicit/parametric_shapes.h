// Witkin & Heckbert's own shapes, movable: a sphere, blobby spheres, blobby cylinders.
//
// Before it: numbers that somebody guessed, and that nobody wants to turn dials for.
// After it: core/implicit/parametric.h. Control points turn the dials.
//
// With the paper's signs (section 5) and ours, f = -F:
//
//     sphere       F = |x - c|^2 - r^2           q = [c, r]                               Dim + 1
//     spheres      F = b - sum_i g_i             q = [b, c^1, s^1, c^2, s^2, ...]         (Dim + 1) k + 1
//     cylinders    F = b - sum_i g_i             q = [b, a^1, b^1, s^1, a^2, ...]         (2 Dim + 1) k + 1
//
// g_i = exp(-d_i^2 / (s^i)^2), d_i the distance to a point or segment (blobby.h, blobby_cylinders.h). The
// bias b is our threshold t. To get blobs of equal radii freeze all s^i; to keep the level, the bias.
//
// Dynamics know nothing of radii that must be positive, and need not: all three are even in r and s^i, and q
// may pass through zero. (At s = 0 a blob is a point that no floating-point number meets.)
#pragma once

#include "core/implicit/blobby.h"
#include "core/implicit/blobby_cylinders.h"
#include "core/implicit/parametric.h"

namespace seesaw {

/// f = r^2 - |x - c|^2, not a distance. Names: "c.x", ..., "r".
template <int Dim>
class ParametricSphere final : public ParametricField<Dim> {
 public:
  ParametricSphere(const Point<Dim>& center, double radius);

  void evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values) const override;
  void evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values,
                Eigen::Ref<Points<Dim>> gradients) const override;
  using Field<Dim>::evaluate;
  /// Exact.
  double gradient_bound(const Box<Dim>& box) const override;
  /// With a twentieth of the diameter around the sphere.
  Box<Dim> bounding_box() const override;
  std::vector<std::string> names() const override;

  const Point<Dim>& center() const { return center_; }
  /// As q has it: the sphere's radius is its absolute value.
  double radius() const { return radius_; }

 private:
  Values all() const override;
  void set_all(const Values& values) override;
  Eigen::MatrixXd all_gradients(const PointsRef<Dim>& points) const override;

  Point<Dim> center_;
  double radius_;
};

/// A Shape (BlobbySpheres, BlobbyCylinders) whose q is known; the two below say which numbers are what.
template <int Dim, class Shape>
class ParametricBlobs : public ParametricField<Dim> {
 public:
  void evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values) const override {
    shape_.evaluate(points, values);
  }
  void evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values,
                Eigen::Ref<Points<Dim>> gradients) const override {
    shape_.evaluate(points, values, gradients);
  }
  using Field<Dim>::evaluate;
  double gradient_bound(const Box<Dim>& box) const override { return shape_.gradient_bound(box); }
  Box<Dim> bounding_box() const override { return shape_.bounding_box(); }

  /// The shape as it stands.
  const Shape& shape() const { return shape_; }

 protected:
  ParametricBlobs(const Shape& shape, const Values& all) : shape_(shape), all_(all) {
    this->start(all.size());
  }
  Values all() const override { return all_; }

  Shape shape_;
  Values all_;  // [b, a blob's numbers, the next one's, ...]; deviations of either sign
};

/// Names: "bias", "c0.x", ..., "s0", "c1.x", ... f_q costs K exponentials a point.
template <int Dim>
class ParametricBlobbySpheres final : public ParametricBlobs<Dim, BlobbySpheres<Dim>> {
 public:
  explicit ParametricBlobbySpheres(const BlobbySpheres<Dim>& shape);
  std::vector<std::string> names() const override;

 private:
  void set_all(const Values& values) override;
  Eigen::MatrixXd all_gradients(const PointsRef<Dim>& points) const override;
};

/// Names: "bias", "a0.x", ..., "b0.x", ..., "s0", "a1.x", ... f_q costs K exponentials a point. Where a
/// segment is a point, f has no derivative by its ends; what is given then moves both alike.
template <int Dim>
class ParametricBlobbyCylinders final : public ParametricBlobs<Dim, BlobbyCylinders<Dim>> {
 public:
  explicit ParametricBlobbyCylinders(const BlobbyCylinders<Dim>& shape);
  std::vector<std::string> names() const override;

 private:
  void set_all(const Values& values) override;
  Eigen::MatrixXd all_gradients(const PointsRef<Dim>& points) const override;
};

extern template class ParametricSphere<2>;
extern template class ParametricSphere<3>;
extern template class ParametricBlobbySpheres<2>;
extern template class ParametricBlobbySpheres<3>;
extern template class ParametricBlobbyCylinders<2>;
extern template class ParametricBlobbyCylinders<3>;

}  // namespace seesaw
