// Points of a scan that do not belong to it, and normals that their neighbors contradict.
//
// Before it: a cloud as a scanner left it.  After it: fit_model.h chooses points; the strays would be first,
// since they are farthest from everything.
//
// Both are judged by each point's 12 nearest neighbors, so that neither a scan's unit nor its density
// matters:
//
//     stray          its 4th neighbor is 4 times as far as its neighbors' own 4th neighbors are from them
//     (the
//                    median of these), or 8 times as far as is usual in the whole cloud. If more than 3 in
//                    100 points are so, they are a part that was scanned thinly, and stay
//     contradicted   more than 3 in 4 of the neighbors that have a normal look the other way. On the sheets
//     of a
//                    thin plate half of them do.
#pragma once

#include "core/mesh/triangle_mesh.h"

namespace seesaw {

struct CleanCloud {
  PointCloud cloud;  ///< without the strays, in the same order; contradicted normals are zero
  Index strays = 0;
  Index contradicted = 0;
};

/// Clouds of fewer than 50 points come back as they are. About 10 microseconds a point and core.
CleanCloud cleaned(const PointCloud& cloud);

}  // namespace seesaw
