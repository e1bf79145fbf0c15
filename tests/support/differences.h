// Derivatives against central differences: the checker every field's test uses.
#pragma once

#include <gtest/gtest.h>

#include "core/implicit/field.h"

namespace seesaw {

/// Expects gradient(x) to agree with central differences of f with step `step`, to `tolerance` relative to
/// the largest of the gradient's size and `floor`. The differences' own error is O(step^2 f''') + O(eps f /
/// step).
template <int Dim>
void expect_gradient_matches_differences(const Field<Dim>& field, const Point<Dim>& x, double step,
                                         double tolerance, double floor = 1e-3) {
  const Point<Dim> gradient = field.gradient(x);
  Point<Dim> differences;
  for (int d = 0; d < Dim; ++d) {
    const Point<Dim> h = step * Point<Dim>::Unit(d);
    differences[d] = (field.value(x + h) - field.value(x - h)) / (2 * step);
  }
  EXPECT_LE((gradient - differences).norm(), tolerance * std::max(floor, gradient.norm()))
      << "at " << x.transpose() << "\n  gradient    " << gradient.transpose() << "\n  differences "
      << differences.transpose();
}

/// Expects |grad f| at `samples` random points of `box` to stay under the field's bound for it.
template <int Dim, class Random>
void expect_gradient_bound_holds(const Field<Dim>& field, const Box<Dim>& box, Index samples,
                                 Random& random) {
  const Points<Dim> points = random.template points_in<Dim>(box, samples);
  Values values(samples);
  Points<Dim> gradients(Dim, samples);
  field.evaluate(points, values, gradients);
  EXPECT_LE(gradients.colwise().norm().maxCoeff(), field.gradient_bound(box) * (1 + 1e-15))
      << "box " << box.min().transpose() << " .. " << box.max().transpose();
}

}  // namespace seesaw
