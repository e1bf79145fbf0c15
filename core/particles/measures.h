// How good is a sampling? The numbers that figures print beside the discs.
//
// Before it: floaters.h, or any points on a surface.  After it: reports for people, and tests.
//
// "Uniform" is measured by the distance from each floater to its nearest neighbor: its coefficient of
// variation (standard deviation over mean) is 0 for a perfect hexagonal packing, 3 % for floaters at rest on
// a sphere, where no packing is perfect, and 52 % for points thrown at random. It sees crowds and not holes;
// so there is the largest gap, the radius of the largest empty circle on the surface (by distances through
// space). Its center can be anywhere: points dense on the whole surface must be handed in, such as the
// vertices of its polygonization, and the answer is short by at most half their spacing. In a perfect
// packing two radii apart it is 2 / sqrt 3 = 1.15 radii.
#pragma once

#include "core/particles/floaters.h"

namespace seesaw {

/// Distances to the nearest other floater, scene units; all 0 for fewer than two.
struct Spacing {
  double mean = 0;
  double least = 0;
  double variation = 0;  ///< coefficient of variation
};

struct FloaterMeasures {
  Index floaters = 0;
  Spacing spacing;
  double mean_radius = 0;  ///< of sigma_i, scene units
  double most_off = 0;     ///< max |f| / |grad f|, scene units; infinite where a gradient is zero off f = 0
  double most_off_radii = 0;  ///< max of the same over the floater's own radius
  double mean_speed = 0;      ///< scene units per unit of time, of what the last step did
  double most_speed = 0;
  Index astray = 0;
  FloaterCounts counts;
};

/// `normals` (3 x N, unit) or 3 x 0: with them only neighbors of the same sheet count (same_sheet.h).
/// O(N log N).
Spacing spacing_of(const PointsRef<3>& positions, const PointsRef<3>& normals = Points<3>(3, 0));

/// Everything at once; one evaluation of the field a floater.
FloaterMeasures measure(const Floaters& floaters, const Field<3>& field);

/// The largest distance from a point of `surface` (3 x M, dense) to the nearest of `positions` (3 x N), scene
/// units; infinite for N = 0, 0 for M = 0. O(M log N).
double largest_gap(const PointsRef<3>& positions, const PointsRef<3>& surface);

}  // namespace seesaw
