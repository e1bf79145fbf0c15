// From a point near a surface to the surface: how far off is it?
//
// Before it: a field, and points that should be on its zero set.
// After it: adaptive_fit.h adds centers where the distance is large; clearance.h walks onto surfaces.
//
//     first order   |f| / |grad f|                                  (Taubin 1991), one evaluation
//     the foot      x <- x - f grad f / |grad f|^2, until f is nothing: a point of the surface, so its
//                   distance is never less than the true one, and for points near the surface hardly more
//
// The first is right only where f is nearly linear up to the surface; the second is what it is checked with.
#pragma once

#include <optional>

#include "core/implicit/field.h"

namespace seesaw {

/// |f| / |grad f| at each point (3 x N), scene units; infinite where the gradient is zero and f is not.
Values first_order_distances(const Field<3>& field, const PointsRef<3>& points);

/// The distance from each point (3 x N) to its foot on f = 0. No step is longer than `reach`, scene units, >
/// 0. Where the walk does not arrive, the distance it has gone plus what first order says is left. Some three
/// to six evaluations for points near the surface.
Values foot_distances(const Field<3>& field, const PointsRef<3>& points, double reach);

/// The foot of one point, to |f| / |grad f| <= tolerance (scene units) or to rounding; nothing where the walk
/// does not arrive in 60 steps.
std::optional<Point<3>> foot_point(const Field<3>& field, const Point<3>& from, double tolerance);

}  // namespace seesaw
