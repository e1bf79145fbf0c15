// Takes faces without area out of a mesh and leaves no cracks behind.
//
// Before it: faces that name three different vertices in three different places.
// After it: a mesh whose every face has a normal.
//
// Such a face is flat when its corners lie exactly on one line: one of them, m, between the other two, a and
// b. Dropped, it would leave a slit from a by m to b. So it is joined with the face (a, b, d) on the other
// side of its long edge, and the two become (a, m, d) and (m, b, d).
#pragma once

#include <array>
#include <vector>

#include "core/base/types.h"

namespace seesaw {

/// Removes the flat ones of `faces` in place and returns their number. One whose long edge has no neighbor,
/// or several, is dropped.
Index remove_flat_faces(const Eigen::Ref<const Points<3>>& points, std::vector<std::array<int, 3>>& faces);

}  // namespace seesaw
