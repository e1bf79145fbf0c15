// Bisects triangles until the pieces of curve are the curve.
//
// Before it: crossings.h (what is seen), seeds.h (what must be seen).  After it: trace.h.
//
// In rounds, so that each round's new vertices are one batch for the field. A mixed triangle is bisected when
//   - the gradients at its two crossings, or a gradient and the chord's left side, differ by more than 45
//     degrees: then it joins two curves that only pass each other (or holds a corner), and finding out may
//     take it down to 2^-20 of the extent; so may a smaller turn within a small corner of the triangle;
//   - they differ by more than the angle tolerance, and the triangle may still be bisected for that;
//   - a seed in it is not satisfied: down to 2^-31 of the extent.
#pragma once

#include "core/contour/contour.h"
#include "core/contour/seeds.h"

namespace seesaw {

/// Returns false when options.max_refined_vertices stopped it. Reports `from` to 1 on the way.
bool refine(Crossings& curve, std::vector<Seed>& seeds, const ContourOptions& options,
            const Progress& progress, double from);

}  // namespace seesaw
