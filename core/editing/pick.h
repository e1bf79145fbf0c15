// Where on the shape does a person point?
//
// Before it: a ray through the cursor (T&O 2002, section 5), or the cursor itself in the plane.
// After it: core/editing/resolve.h, a boundary constraint there.
//
// In space the first surface point of the ray is found by core/raytrace/rigorous_tracer.h, which cannot step
// through a sheet, however thin to a millionth of the scene. In the plane the curve is taken from
// core/contour, all its components, and the vertex nearest to the cursor is walked to the foot of the
// perpendicular.
#pragma once

#include <memory>
#include <optional>

#include "core/implicit/field.h"

namespace seesaw {

/// The first point from `from` on along `direction` (any length but zero) where f changes sign, f = 0 to
/// rounding; nothing where there is none within the field's bounding box.
std::optional<Point<3>> first_on_surface(std::shared_ptr<const Field<3>> field, const Point<3>& from,
                                         const Point<3>& direction);

/// The point of the curve f = 0 nearest to `near`, f = 0 to rounding; nothing where there is no curve in the
/// field's bounding box, grown to hold `near`. `seeds` is 2 x N: points known to be on the curve.
std::optional<Point<2>> nearest_on_curve(const Field<2>& field, const Point<2>& near,
                                         const PointsRef<2>& seeds);

}  // namespace seesaw
