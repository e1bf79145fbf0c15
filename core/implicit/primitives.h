// The simplest surfaces, with exact answers: what tests measure against, and CSG's building blocks.
#pragma once

#include "core/implicit/field.h"

namespace seesaw {

/// The circle (2D) or sphere (3D) of T&O 2002, section 2.1, for any center c and radius r: f(x) = r - |x -
/// c|. Its |grad f| is 1 everywhere but at the center, where the gradient does not exist and is given as
/// zero.
template <int Dim>
class Sphere final : public Field<Dim> {
 public:
  /// `radius` > 0, in scene units.
  Sphere(const Point<Dim>& center, double radius);

  void evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values) const override;
  void evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values,
                Eigen::Ref<Points<Dim>> gradients) const override;
  double gradient_bound(const Box<Dim>& box) const override;
  Box<Dim> bounding_box() const override;

 private:
  Point<Dim> center_;
  double radius_;
};

extern template class Sphere<2>;
extern template class Sphere<3>;

}  // namespace seesaw
