// Is the curve under the cursor, and where exactly?
//
// Before it: the function as it is, and a cursor some pixels away.  After it: core/editing/hit_test.h; a
// boundary constraint at the foot, which asks for nothing that f does not do already.
//
// core/editing/pick.h answers "where is the curve nearest?" for any distance, and contours the whole of it.
// A hand that hovers asks a hundred times a second whether it is *near*. A few evaluations say so: each step
//     x <- x - f grad f / |grad f|^2 + (what of p - x lies along the curve)
// goes onto the curve (Newton) and along it to where p stands perpendicularly off it.
#pragma once

#include <optional>

#include "core/implicit/field.h"

namespace seesaw {

/// The foot on f = 0 of the perpendicular from `p`, f = 0 to rounding, where it is no farther than `reach`
/// from p; else nothing. Meant for a `reach` below the curve's radius of curvature. Some ten evaluations.
std::optional<Point<2>> curve_foot(const Field<2>& field, const Point<2>& p, double reach);

}  // namespace seesaw
