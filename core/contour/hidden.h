// Components that slip between the lattice corners, and how the corners still betray them.
//
// Before it: the lattice's values.  After it: points on the curve, which refine.h takes as seeds.
//
// A small island of f > 0 in a sea of f < 0 raises the sea around it: some corner near it is higher than all
// eight around it, yet below zero. From such a corner we climb (and from the mirror image, a positive valley,
// descend) by Newton's method in a trust region, the Hessian started from the corner's neighbors and improved
// on the way (BFGS). Most corners turn out to stand beside a summit below zero, and three steps show that;
// where the climb crosses zero, the curve lies between the corner and the climber. The same along the box's
// sides, where a curve may poke into the box between two corners.
#pragma once

#include "core/contour/lattice.h"

namespace seesaw {

/// Points on the zero set (2 x N), one on each small component found. `tolerance` as for find_roots.
Points<2> hidden_points(const Lattice& lattice, Sampler& sampler, double tolerance);

}  // namespace seesaw
