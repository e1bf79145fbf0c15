// A first point on a surface of which nothing is known but its field.
//
// Before it: a Field, and perhaps points that somebody believes to be on it (boundary constraints).
// After it: floaters.h, whose population begins there.
//
// "The system starts up with a single floater positioned arbitrarily in the bounding box of the surface"
// (Witkin & Heckbert 1994, section 5), and feedback brings it onto the surface. So it is here, by Newton
// along the gradient; only, far from a blobby there is no gradient to follow. Then points are drawn until one
// is inside and one outside: on the way between them f = 0.
#pragma once

#include <optional>

#include "core/base/random.h"
#include "core/implicit/field.h"

namespace seesaw {

/// A point with f = 0 in field.bounding_box(); none where there is no sign change among some 30,000 points,
/// or, with `brief`, where eight Newton walks from random points lead nowhere.
std::optional<Point<3>> some_point_on(const Field<3>& field, Random& random, bool brief = false);

}  // namespace seesaw
