// What is inside, in a view that cuts the curve: closed rings around it, along the curve and the view's
// border.
//
// Before it: the polylines of core/contour, inside on the left, each closed or with both ends on the box.
// After it: core/scene/picture.h fills them.
#pragma once

#include <vector>

#include "core/mesh/polyline.h"

namespace seesaw {

/// 2 x N each, no point twice; to be filled by the even-odd rule. At the end of an open polyline the border
/// is followed counterclockwise to the next beginning: inside stays on the left. None for no polylines: all
/// of the box is then inside or none of it.
std::vector<Points<2>> inside_rings(const std::vector<Polyline>& polylines, const Box<2>& box);

}  // namespace seesaw
