// Vertices in one place become one vertex.
//
// Before it: the vertices of a file; STL, and exporters that split vertices along creases, have each several
// times. After it: mesh_repair.h names the first of them wherever another stood.
#pragma once

#include <vector>

#include "core/base/types.h"

namespace seesaw {

/// For each column of `points` (3 x N, finite) the first column with exactly equal coordinates (0 equals -0),
/// which may be itself. O(N log N).
std::vector<int> first_of_equals(const Eigen::Ref<const Points<3>>& points);

}  // namespace seesaw
