// The narrow waist: all that a renderer knows of a surface, and all that a surface promises a renderer.
//
// Before it: anything that has a value everywhere (an interpolant, a blobby, a union of two other fields).
// After it: contour (2D polylines), polygonize (meshes), raytrace (images), particles (floaters).
//
// Sign, everywhere in Seesaw, as in Turk & O'Brien 2002, section 2.1:
//     f > 0 inside,   f < 0 outside,   f = 0 on the curve or surface.
// So the gradient of f points *inward*, and the outward unit normal is -grad f / |grad f|.
//
// Points come in batches, because the cost of a field is in its inner loop and a batch fills it.
#pragma once

#include "core/base/check.h"
#include "core/base/types.h"

namespace seesaw {

template <int Dim>
class Field {
 public:
  virtual ~Field() = default;

  /// values[i] = f(points.col(i)). `points` is Dim x N in scene units, `values` has room for N.
  /// Called from many threads at once. A point's value does not depend on the batch it came in.
  virtual void evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values) const = 0;

  /// As `evaluate`, and gradients.col(i) = grad f at points.col(i), Dim x N, in value per scene unit. Where
  /// the gradient does not exist (the tip of a cone) it is the zero vector.
  virtual void evaluate(const PointsRef<Dim>& points, Eigen::Ref<Values> values,
                        Eigen::Ref<Points<Dim>> gradients) const = 0;

  /// A number that |grad f| exceeds nowhere in `box`; it shrinks with the box toward the true maximum.
  /// Infinite where no bound is known.
  virtual double gradient_bound(const Box<Dim>& box) const = 0;

  /// Where to look for the zero set: a box that holds what the field is about, with some room. Empty for
  /// none.
  virtual Box<Dim> bounding_box() const = 0;

  // Conveniences over the batches above.

  Values values(const PointsRef<Dim>& points) const {
    Values result(points.cols());
    evaluate(points, result);
    return result;
  }

  double value(const Point<Dim>& point) const {
    Values result(1);
    evaluate(point, result);
    return result[0];
  }

  Point<Dim> gradient(const Point<Dim>& point) const {
    Values value(1);
    Points<Dim> result(Dim, 1);
    evaluate(point, value, result);
    return result;
  }

 protected:
  static void check_shapes(const PointsRef<Dim>& points, const Eigen::Ref<Values>& values) {
    SEESAW_CHECK_EQ(points.cols(), values.size());
  }
};

}  // namespace seesaw
