// The loop that everyone writes first: what eq. 5 of Turk & O'Brien 2002 costs without any care.
//
// Compiled with the project's ordinary flags. A compiler may not reorder floating-point additions (that is
// what -ffast-math would allow), so this sum stays scalar and waits for each addition to finish.
#pragma once

#include "core/rbf/kernel_sums.h"

namespace seesaw::bench {

/// The arguments of KernelSums::values.
void plain_loop(Kernel kernel, int dimension, const CenterArrays& centers, const PointArrays& points,
                double* values);

}  // namespace seesaw::bench
