// How large can symbols be where there are thousands of them?
//
// Before it: a document, and how large a scene unit is on the page.  After it: PictureOptions' symbol_size
// and spike_length, and where an editor looks for the free ends of spikes.
#pragma once

#include "core/scene/document.h"

namespace seesaw {

/// The usual distance from a constraint to the one nearest to it, scene units: the median of a hundred of
/// them, evenly over the list. Infinite below 100 constraints. O(100 N).
double usual_spacing(const Document<2>& document);

/// What part of its size a symbol that would be `wanted` points wide should have, so that symbols do not hide
/// the curve: 1 where two neighbors have room side by side, and never below 0.3, so that it can be seen.
/// `scale`: points in a scene unit.
double symbol_share(double usual_spacing, double scale, double wanted);

}  // namespace seesaw
