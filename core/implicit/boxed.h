// A field with another bounding box: where to look for its surface, said by somebody who knows better.
//
// Before it: a field whose own box is generous, such as an interpolant in a cage of exterior constraints.
// After it: renderers, which look in that box alone and so work less.
#pragma once

#include "core/implicit/booleans.h"

namespace seesaw {

template <int Dim>
class Boxed final : public Field<Dim> {
 public:
  /// `box` must not be empty; what of the surface lies beyond it is not looked for.
  Boxed(FieldPointer<Dim> field, const Box<Dim>& box) : field_(std::move(field)), box_(box) {
    SEESAW_CHECK_EQ(box_.isEmpty(), false);
  }

  void evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values) const override {
    field_->evaluate(points, values);
  }
  void evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values,
                Eigen::Ref<Points<Dim>> gradients) const override {
    field_->evaluate(points, values, gradients);
  }
  double gradient_bound(const Box<Dim>& box) const override { return field_->gradient_bound(box); }
  Box<Dim> bounding_box() const override { return box_; }

 private:
  FieldPointer<Dim> field_;
  Box<Dim> box_;
};

}  // namespace seesaw
