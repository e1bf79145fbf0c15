// One table of loops for each instruction set that this build compiled. Private to core/rbf.
#pragma once

#include "core/rbf/kernel_sums.h"

namespace seesaw {

extern const KernelSums portable_kernel_sums;
#if defined(__x86_64__)
extern const KernelSums avx2_kernel_sums;
extern const KernelSums avx512_kernel_sums;
#endif

}  // namespace seesaw
