// The loops for any processor: two lanes of SSE2 on x86-64, of NEON on arm64.
#include <xsimd/xsimd.hpp>

#include "core/rbf/kernel_sums.h"
#include "core/rbf/simd/instruction_sets.h"

namespace {

struct Lanes {
  using Batch = xsimd::batch<double, xsimd::default_arch>;
  static constexpr double smallest = 1e-300;
  static constexpr int value_registers = 2, gradient_registers = 1;
  struct Root {
    Batch root, inverse;
  };
  static Batch fma(Batch a, Batch b, Batch c) { return a * b + c; }
  template <int turn>
  static Root root(Batch s) {
    const Batch r = xsimd::sqrt(s);
    return {r, Batch(1.0) / r};
  }
  static Batch log(Batch s) { return xsimd::log(s); }
};

}  // namespace

#include "core/rbf/simd/kernel_sums.inc"

namespace seesaw {
extern const KernelSums portable_kernel_sums = sums_of("portable");
}
