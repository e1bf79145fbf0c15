// What a person says about a shape: here the curve passes, here is inside, here is outside, here is the
// normal.
//
// Before it: a click, a polygon model, a document.
// After it: core/rbf/system.h, row i of eq. 8 is our constraint i.
//
// Turk & O'Brien 2002, section 4:
//   boundary   f = 0 here (4.1); with an optional normal constraint (4.3)
//   interior   f = a positive value here (4.1); the papers use 1
//   exterior   f = a negative value here (4.2); the papers use -1
//   normal     belongs to a boundary constraint at c with outward unit normal n: f = value at
//              c - offset * n, a little inside (4.3). The papers ask only that the value be positive, and
//              place them 0.01 units from their boundary constraints "for objects that fit within a unit
//              cube".
#pragma once

#include <optional>
#include <vector>

#include "core/base/types.h"

namespace seesaw {

enum class ConstraintKind { boundary, interior, exterior };

/// A boundary constraint's companion, section 4.3.
template <int Dim>
struct NormalConstraint {
  /// The outward normal; of any length but zero, used as a unit vector.
  Point<Dim> direction = Point<Dim>::UnitX();
  /// How far inside the boundary constraint its normal constraint stands, in scene units. Negative stands
  /// outside (and then wants a negative value).
  double offset = 0.01;
  /// f at `at - offset * direction`.
  double value = 1.0;
};

/// One constraint of a document. `value` is f at `at`: 0 for boundary, positive for interior, negative for
/// exterior.
template <int Dim>
struct Constraint {
  ConstraintKind kind = ConstraintKind::boundary;
  Point<Dim> at = Point<Dim>::Zero();
  double value = 0.0;
  /// Only boundary constraints have one.
  std::optional<NormalConstraint<Dim>> normal = std::nullopt;
};

template <int Dim>
using Constraints = std::vector<Constraint<Dim>>;

template <int Dim>
Constraint<Dim> boundary(const Point<Dim>& at) {
  return {ConstraintKind::boundary, at, 0.0, std::nullopt};
}
template <int Dim>
Constraint<Dim> boundary(const Point<Dim>& at, const Point<Dim>& normal, double offset = 0.01,
                         double value = 1.0) {
  return {ConstraintKind::boundary, at, 0.0, NormalConstraint<Dim>{normal, offset, value}};
}
template <int Dim>
Constraint<Dim> interior(const Point<Dim>& at, double value = 1.0) {
  return {ConstraintKind::interior, at, value, std::nullopt};
}
template <int Dim>
Constraint<Dim> exterior(const Point<Dim>& at, double value = -1.0) {
  return {ConstraintKind::exterior, at, value, std::nullopt};
}

/// Where the normal constraint of a boundary constraint stands: at - offset n, to the bit as the solver has it.
/// Not a number for a direction of length zero.
template <int Dim>
Point<Dim> normal_center(const Point<Dim>& at, const NormalConstraint<Dim>& normal) {
  // stableNorm: a direction of length 1e-200 is a direction.
  return at - (normal.offset / normal.direction.stableNorm()) * normal.direction;
}

/// The positions of the boundary constraints, Dim x N: points that the curve or surface passes through, from
/// which contours and polygonizers start.
template <int Dim>
Points<Dim> boundary_points(const Constraints<Dim>& constraints) {
  Points<Dim> points(Dim, static_cast<Index>(constraints.size()));
  Index count = 0;
  for (const Constraint<Dim>& each : constraints)
    if (each.kind == ConstraintKind::boundary) points.col(count++) = each.at;
  return points.leftCols(count);
}

}  // namespace seesaw
