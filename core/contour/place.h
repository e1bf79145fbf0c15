// Where a seed lies among the triangles, and what passes near it.
//
// Before it: crossings.h, seeds.h.  After it: trial.h and settle.cpp, which ask what passes; refine.h, which
// bisects.
#pragma once

#include <vector>

#include "core/contour/seeds.h"

namespace seesaw {

/// At the limit of size, what passes this near, in sizes of the last triangle, passes through the seed.
inline constexpr double last_reach = 64;

/// `v` turned by a quarter to the left.
inline Point<2> left_of(const Point<2>& v) { return {-v.y(), v.x()}; }

/// Length of the leaf's longest side, in scene units.
double size_of(const Triangulation& mesh, int t);

/// The leaves a seed lies in (several when on an edge), and the longest side of the smallest, in scene units.
struct Place {
  std::vector<int> leaves;
  double size = infinity;
};

/// The triangles are made if need be.
Place place_of(Triangulation& mesh, const Seed& seed);

/// The leaf whose passage is nearest to the seed, within `reach` (scene units), among those with their inside
/// on the seed's side; -1 for none.
int nearest_passage(const Crossings& curve, const Seed& seed, double reach);

}  // namespace seesaw
