// Solids from text: "(0 | 1) - 2".
//
// Numbers name the solids of a list, counted from 0. | is union, & is intersection, - is difference; & binds
// tighter than | and -, which go from left to right: "0 - 1 & 2" is "0 - (1 & 2)".
//
// Before it: a command line. After it: solid.h.
#pragma once

#include <string_view>
#include <vector>

#include "core/raytrace/solid.h"

namespace seesaw {

/// Throws Error with the place marked:
///     expected a number or "(" here
///         0 - & 1
///             ^
Solid csg_solid(std::string_view expression, const std::vector<Solid>& solids);

}  // namespace seesaw
