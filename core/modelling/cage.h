// Cages: exterior constraints all around, within which a shape can be drawn with boundary constraints alone.
//
// Before it: where the shape will be, and how large.  After it: core/rbf/fit.h, with boundary constraints.
//
// Turk & O'Brien 2002, section 4.2: "creating a circle or sphere of negative-valued constraints is the
// approach that is best suited to interactive free-form design". Fig. 4 has a circle of 8 around; section 5
// sculpts within the 8 corners of a cube of side 6 around a unit tetrahedron.
//
//     Constraints<3> scene = cube_cage(Point<3>::Zero(), 6);
//     scene.push_back(boundary<3>({1, 0, 0}));  // and so on
#pragma once

#include "core/rbf/constraints.h"

namespace seesaw {

/// `count` >= 1 exterior constraints evenly on the circle, counter-clockwise from `center` + (radius, 0)
/// turned by `start` radians. `value` < 0.
Constraints<2> circle_cage(const Point<2>& center, double radius, int count = 8, double start = 0,
                           double value = -1);

/// `count` >= 1 exterior constraints on the sphere: a spiral in which each has the same area (Swinbank and
/// Purser 2006), so no two are nearer than about 3 radius / sqrt(count). Four or more are in no plane.
Constraints<3> sphere_cage(const Point<3>& center, double radius, int count = 32, double value = -1);

/// The 8 corners of the cube with that side; with `along` > 1, a grid of along x along on each face, corners
/// included: 6 (along - 1)^2 + 2 constraints.
Constraints<3> cube_cage(const Point<3>& center, double side, int along = 2, double value = -1);

}  // namespace seesaw
