// The torus, with an exact answer for everything: what tests of surfaces with a hole measure against.
//
// Before it: nothing.  After it: core/implicit/field.h and every renderer behind it.
//
// With rho the distance from the axis and z the height over the plane of the core circle,
//     f(x) = r - |(rho - R, z)|
// is the signed distance to the surface (f > 0 inside), so |grad f| = 1 and the closest point is x - f grad
// f. Its area is 4 pi^2 R r, its volume 2 pi^2 R r^2, its Euler characteristic 0.
#pragma once

#include "core/implicit/field.h"

namespace seesaw {

/// A ring torus in space, any place and any direction.
class Torus final : public Field<3> {
 public:
  /// The core circle has `center`, radius `major` and is perpendicular to `axis` (any length but zero); the
  /// tube has radius `minor`. 0 < minor < major, all in scene units.
  Torus(const Point<3>& center, const Point<3>& axis, double major, double minor);

  void evaluate(const PointsRef<3>& points, Eigen::Ref<Values> values) const override;
  /// The gradient is zero where there is none: on the core circle and on the axis.
  void evaluate(const PointsRef<3>& points, Eigen::Ref<Values> values,
                Eigen::Ref<Points<3>> gradients) const override;
  double gradient_bound(const Box<3>& box) const override;
  Box<3> bounding_box() const override;

  const Point<3>& center() const { return center_; }
  /// A unit vector.
  const Point<3>& axis() const { return axis_; }
  double major() const { return major_; }
  double minor() const { return minor_; }

 private:
  Point<3> center_, axis_;
  double major_, minor_;
};

}  // namespace seesaw
