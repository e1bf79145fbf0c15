// The loops for AVX-512 (F, DQ, VL): eight lanes.
//
// xsimd 8.1 has no fused multiply-add for this instruction set, and its rsqrt is one that only Xeon Phi
// executes; so these three functions name their instructions.
#include <immintrin.h>

#include <xsimd/xsimd.hpp>

#include "core/rbf/kernel_sums.h"
#include "core/rbf/simd/instruction_sets.h"

namespace {

// -log(c) for the sixteen c below, correctly rounded; c is 1 / (middle of interval k of [1, 2)) cut to float.
alignas(64) constexpr double inverse_table[16] = {
    0x1.f07c200000000p-1, 0x1.d41d420000000p-1, 0x1.bacf920000000p-1, 0x1.a41a420000000p-1,
    0x1.8f9c180000000p-1, 0x1.7d05f40000000p-1, 0x1.6c16c20000000p-1, 0x1.5c98820000000p-1,
    0x1.4e5e0a0000000p-1, 0x1.4141420000000p-1, 0x1.3521d00000000p-1, 0x1.29e4120000000p-1,
    0x1.1f70480000000p-1, 0x1.15b1e60000000p-1, 0x1.0c97140000000p-1, 0x1.0410420000000p-1,
};
alignas(64) constexpr double log_table[16] = {
    0x1.f82990e783380p-6, 0x1.6f0d272e56b4dp-4, 0x1.29552c41ff52ep-3, 0x1.9525a80f456b8p-3,
    0x1.fb918bd5e3e44p-3, 0x1.2e8e2bee11d31p-2, 0x1.5d1bda55809d0p-2, 0x1.89a33a8c14264p-2,
    0x1.b44f791cc8f66p-2, 0x1.dd469dec1c4acp-2, 0x1.025529da5d100p-1, 0x1.154c3e3f4d5eep-1,
    0x1.2795e0e89b11bp-1, 0x1.393e0d2562a1ap-1, 0x1.4a4f87bb03ec9p-1, 0x1.5ad402d359f3cp-1,
};

struct Lanes {
  using Batch = xsimd::batch<double, xsimd::avx512f>;
  static constexpr double smallest = 1e-300;
  static constexpr int value_registers = 4, gradient_registers = 2;
  struct Root {
    Batch root, inverse;
  };

  static Batch fma(Batch a, Batch b, Batch c) { return _mm512_fmadd_pd(a, b, c); }

  // The hardware's square root costs three times the rest of the loop. Instead: 14 bits of 1 / sqrt(s), then
  // Goldschmidt's iteration (g -> sqrt(s), h -> 1 / (2 sqrt(s)), each step doubling the bits).
  template <int turn>
  static Root root(Batch s) {
    const __m512d half = _mm512_set1_pd(0.5);
    const __m512d y = _mm512_rsqrt14_pd(s);
    __m512d g = _mm512_mul_pd(s, y);
    __m512d h = _mm512_mul_pd(half, y);
    __m512d e = _mm512_fnmadd_pd(g, h, half);
    g = _mm512_fmadd_pd(g, e, g);
    h = _mm512_fmadd_pd(h, e, h);
    g = _mm512_fmadd_pd(_mm512_fnmadd_pd(g, g, s), h, g);
    // 1 / sqrt(s) = 2 h, made exact by one more step: y (1 + (1 - g y)).
    const __m512d inverse = _mm512_add_pd(h, h);
    return {g, _mm512_fmadd_pd(inverse, _mm512_fnmadd_pd(g, inverse, _mm512_set1_pd(1.0)), inverse)};
  }

  // s = 2^e m with m in [1, 2); interval k of m from its first four bits; r = m c_k - 1 exact but for one
  // rounding, |r| < 1/31;  log s = e ln 2 - log c_k + log1p(r), the last by its series to r^10 (the next term
  // is below 2^-57).
  static Batch log(Batch s) {
    const __m512d m = _mm512_getmant_pd(s, _MM_MANT_NORM_1_2, _MM_MANT_SIGN_zero);
    const __m512d e = _mm512_getexp_pd(s);
    const __m512i k = _mm512_srli_epi64(_mm512_castpd_si512(s), 48);  // permutex2var reads the low four bits
    const __m512d c =
        _mm512_permutex2var_pd(_mm512_load_pd(inverse_table), k, _mm512_load_pd(inverse_table + 8));
    const __m512d log_c = _mm512_permutex2var_pd(_mm512_load_pd(log_table), k, _mm512_load_pd(log_table + 8));
    const __m512d r = _mm512_fmsub_pd(m, c, _mm512_set1_pd(1.0));
    const __m512d r2 = _mm512_mul_pd(r, r);
    const __m512d p3 = _mm512_fmadd_pd(_mm512_set1_pd(-1.0 / 4), r, _mm512_set1_pd(1.0 / 3));
    const __m512d p5 = _mm512_fmadd_pd(_mm512_set1_pd(-1.0 / 6), r, _mm512_set1_pd(1.0 / 5));
    const __m512d p7 = _mm512_fmadd_pd(_mm512_set1_pd(-1.0 / 8), r, _mm512_set1_pd(1.0 / 7));
    const __m512d p9 = _mm512_fmadd_pd(_mm512_set1_pd(-1.0 / 10), r, _mm512_set1_pd(1.0 / 9));
    __m512d p = _mm512_fmadd_pd(_mm512_fmadd_pd(p9, r2, p7), r2, p5);
    p = _mm512_fmadd_pd(_mm512_fmadd_pd(p, r2, p3), r, _mm512_set1_pd(-0.5));
    const __m512d high = _mm512_fmadd_pd(e, _mm512_set1_pd(0x1.62e42fefa39efp-1), log_c);
    return _mm512_add_pd(high, _mm512_fmadd_pd(p, r2, r));
  }
};

}  // namespace

#include "core/rbf/simd/kernel_sums.inc"

namespace seesaw {
extern const KernelSums avx512_kernel_sums = sums_of("avx512");
}
