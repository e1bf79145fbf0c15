#include "bench/ceiling.h"

#include <cstring>

namespace seesaw::bench {

CeilingLoop ceiling_loop(const char* instruction_set, Kernel kernel, int dimension) {
  const bool cubic = kernel == Kernel::cubic && dimension == 3;
  const bool thin_plate = kernel == Kernel::thin_plate_spline && dimension == 2;
  // Where core/rbf has loops for this processor, ours run too: they are compiled for the same instructions.
  if (kernel_sums_named(instruction_set) == nullptr || !(cubic || thin_plate)) return nullptr;
#if defined(__x86_64__)
  if (std::strcmp(instruction_set, "avx2") == 0) return cubic ? cubic_3d_avx2 : thin_plate_2d_avx2;
  if (std::strcmp(instruction_set, "avx512") == 0) return cubic ? cubic_3d_avx512 : thin_plate_2d_avx512;
#endif
  return nullptr;
}

}  // namespace seesaw::bench
