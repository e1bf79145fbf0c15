#include "core/rbf/kernel_sums.h"

#include <atomic>
#include <cstdlib>
#include <cstring>

#include "core/rbf/simd/instruction_sets.h"

namespace seesaw {

namespace {

// The compiler's own test of the processor also asks whether the operating system saves the wide registers.
const KernelSums& best() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl"))
    return avx512_kernel_sums;
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return avx2_kernel_sums;
#endif
  return portable_kernel_sums;
}

const KernelSums& asked_for_or_best() {
  const char* name = std::getenv("SEESAW_LOOPS");
  const KernelSums* asked = name ? kernel_sums_named(name) : nullptr;
  return asked ? *asked : best();
}

std::atomic<const KernelSums*>& chosen() {
  static std::atomic<const KernelSums*> sums{&asked_for_or_best()};
  return sums;
}

}  // namespace

const KernelSums& kernel_sums() { return *chosen().load(std::memory_order_relaxed); }

const KernelSums* kernel_sums_named(const char* name) {
  // Whatever the best can run, the lesser can too.
  const KernelSums* candidates[] = {
#if defined(__x86_64__)
    &avx512_kernel_sums,
    &avx2_kernel_sums,
#endif
    &portable_kernel_sums
  };
  bool runs = false;
  for (const KernelSums* candidate : candidates) {
    runs = runs || candidate == &best();
    if (runs && std::strcmp(candidate->name, name) == 0) return candidate;
  }
  return nullptr;
}

void use_kernel_sums(const KernelSums& sums) { chosen().store(&sums, std::memory_order_relaxed); }

}  // namespace seesaw
