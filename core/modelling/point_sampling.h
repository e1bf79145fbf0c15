// Which N of many points? The ones that leave no place far from all of them.
//
// Before it: a scan with more points than a dense solver can take.
// After it: model_constraints.h makes constraints of the chosen; adaptive_fit.h starts from them.
//
// Farthest-point sampling (Gonzalez 1985; Eldar et al. 1997): again and again the point farthest from all
// chosen ones. The chosen stand at least as far apart as the last choice was from the others, and no point is
// farther than that from the chosen: the covering radius is at most twice the best possible.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/base/types.h"

namespace seesaw {

struct PointSample {
  std::vector<Index> chosen;  ///< indices into the points, in the order of choice, each once
  /// No point is farther than this from the nearest chosen one, in scene units. 0 when every distinct
  /// position is chosen.
  double covering_radius = 0;
};

/// Chooses `count` of the N `points` (3 x N, finite), fewer where there are no more distinct positions. The
/// first is the one farthest from the middle of their box; `start` instead puts these in front. No random
/// numbers: the same points in the same order give the same choice. O(N count).
PointSample farthest_points(const PointsRef<3>& points, Index count, const std::vector<Index>& start = {},
                            const Progress& progress = {});

}  // namespace seesaw
