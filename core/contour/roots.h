// Where f = 0 on a segment whose ends differ in sign: to rounding, for many segments at once.
//
// Before it: edges of triangles (refine.h), or a corner and the hidden peak beside it (hidden.h).
// After it: the vertices of the curve.
//
// Newton's method along the segment, kept inside a bracket that always holds a change of sign. Where Newton
// leaves the bracket or does not halve its step (no gradient, a triple root, a jump), the bracket is halved
// instead. So four evaluations are usual for a smooth field, and about fifty the worst for any field at all.
#pragma once

#include "core/contour/sampler.h"

namespace seesaw {

struct Roots {
  Points<2> positions;  ///< 2 x N
  Points<2> gradients;  ///< 2 x N, grad f there; zero where there is none
  Values values;        ///< f - level there, N x 1
};

/// One root on each segment from inside.col(i), where the value inside_values[i] >= 0 is known, to
/// outside.col(i), where outside_values[i] < 0 (minus infinity allowed). A coordinate that both ends share is
/// shared by the root. An inside end that is exactly zero is the root. `tolerance` is how near to wait for,
/// in scene units.
Roots find_roots(Sampler& sampler, const Points<2>& inside, const Points<2>& outside,
                 const Values& inside_values, const Values& outside_values, double tolerance);

}  // namespace seesaw
