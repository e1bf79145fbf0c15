// Are two floaters neighbors on the surface, or only in space?
//
// Before it: two floaters that are near each other.
// After it: repulsion.h and integrals.h weigh every pair by it.
//
// Witkin & Heckbert measure distance straight through space. Where a surface comes near itself, across a
// thin wall, a gap or the valley between two components, that pushes floaters away from others that have
// nothing to do with them: two spheres that touch would bare each other, and the two sides of a slab would
// share one population. Normals tell, and cost nothing. Let r lead from j to i, and m be the sum of their
// outward unit normals. On a circle, any circle, r is square to m; and any piece of a smooth surface is
// nearly one.
//
//   - the sides of a slab, or two spheres face to face:  n_i . n_j = -1
//   - stacked sheets that look the same way:             r parallel to m
//
// So the weight is 1 where n_i . n_j > 1/2 and |r . m| < |r| |m| / 2, falls to 0 at -1/2 and 0.8, and is
// smooth between, since a jump would shake the floaters. A right-angled edge counts one half: floaters on
// both sides of it still keep apart. What a floater loses are partners more than 120 degrees around a limb
// that is thin for its radius; there only a few would fit anyway.
// Along a valley sharper than 70 degrees floaters of its two sides do not feel each other and still cross it:
// there a few are born and die all the time.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/base/types.h"

namespace seesaw {

/// 0 for x <= from, 1 for x >= to, and smooth between.
inline double smooth_step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// Between 0 (strangers) and 1 (neighbors), the same for (i, j) and (j, i). `from_j_to_i` any length, normals
/// of unit length.
inline double same_sheet(const Point<3>& from_j_to_i, const Point<3>& normal_i, const Point<3>& normal_j) {
  const double facing = normal_i.dot(normal_j);
  if (facing <= -0.5) return 0;
  const Point<3> m = normal_i + normal_j;
  const double along = from_j_to_i.dot(m), size = from_j_to_i.squaredNorm() * m.squaredNorm();
  // Most pairs are plain neighbors: no root for them.
  if (facing >= 0.5 && along * along <= 0.25 * size) return 1;
  return smooth_step(-0.5, 0.5, facing) * (1 - smooth_step(0.5, 0.8, std::abs(along) / std::sqrt(size)));
}

}  // namespace seesaw
