// The loops for AVX2 with FMA3: four lanes.
#include <immintrin.h>

#include <xsimd/xsimd.hpp>

#include "core/rbf/kernel_sums.h"
#include "core/rbf/simd/instruction_sets.h"

namespace {

// 1 / (middle of interval k of [1, 2)), eight intervals, cut to 20 bits so that its lower word is zero; and
// minus its logarithm, correctly rounded, as upper and lower words.
alignas(32) constexpr unsigned inverse_words[8] = {
    0x3fee1e1e, 0x3feaf286, 0x3fe86186, 0x3fe642c8, 0x3fe47ae1, 0x3fe2f684, 0x3fe1a7b9, 0x3fe08421,
};
alignas(32) constexpr unsigned log_upper_words[8] = {
    0x3faf0a32, 0x3fc5ff33, 0x3fd1675c, 0x3fd739d8, 0x3fdc8ff8, 0x3fe0be74, 0x3fe307d7, 0x3fe52a2d,
};
alignas(32) constexpr unsigned log_lower_words[8] = {
    0xc01163a6, 0xf0a7a014, 0xebaba62e, 0xf6bbd207, 0xa79a9baa, 0x242530c3, 0xe34f12a2, 0x365bc5af,
};

struct Lanes {
  using Batch = xsimd::batch<double, xsimd::fma3<xsimd::avx2>>;
  // Square roots start in single precision, which holds numbers in this range only.
  static constexpr double smallest = 1e-37;
  static constexpr int value_registers = 3, gradient_registers = 2;
  struct Root {
    Batch root, inverse;
  };

  static Batch fma(Batch a, Batch b, Batch c) { return _mm256_fmadd_pd(a, b, c); }

  // One center's square root on the hardware's unit, the next center's as for AVX-512, from the 12 bits of
  // single precision's estimate: one step of third order (36 bits), one of second. Side by side they take
  // half again less time than either alone.
  template <int turn>
  static Root root(Batch s) {
    if constexpr (turn == 0) {
      const __m256d r = _mm256_sqrt_pd(s);
      return {r, _mm256_div_pd(_mm256_set1_pd(1.0), r)};
    }
    const __m256d y = _mm256_cvtps_pd(_mm_rsqrt_ps(_mm256_cvtpd_ps(s)));
    __m256d g = _mm256_mul_pd(s, y);
    const __m256d e = _mm256_fnmadd_pd(g, y, _mm256_set1_pd(1.0));  // 1 - s y^2
    const __m256d q = _mm256_mul_pd(e, _mm256_fmadd_pd(e, _mm256_set1_pd(0.375), _mm256_set1_pd(0.5)));
    g = _mm256_fmadd_pd(g, q, g);
    const __m256d h = _mm256_mul_pd(_mm256_set1_pd(0.5), _mm256_fmadd_pd(y, q, y));
    g = _mm256_fmadd_pd(_mm256_fnmadd_pd(g, g, s), h, g);
    const __m256d inverse = _mm256_add_pd(h, h);
    return {g, _mm256_fmadd_pd(inverse, _mm256_fnmadd_pd(g, inverse, _mm256_set1_pd(1.0)), inverse)};
  }

  // As for AVX-512, with eight intervals (what one permutation holds), so |r| < 1/15 and the series runs to
  // r^14.
  static Batch log(Batch s) {
    const __m256i bits = _mm256_castpd_si256(s);
    const __m256i exponent_bits = _mm256_srli_epi64(bits, 52);
    // The exponent as a double: its bits as the low bits of 2^52, less 2^52 and the bias.
    const __m256d e = _mm256_sub_pd(
        _mm256_castsi256_pd(_mm256_or_si256(exponent_bits, _mm256_set1_epi64x(0x4330000000000000))),
        _mm256_set1_pd(4503599627370496.0 + 1023.0));
    const __m256d m = _mm256_castsi256_pd(_mm256_or_si256(
        _mm256_and_si256(bits, _mm256_set1_epi64x(0xfffffffffffff)), _mm256_set1_epi64x(0x3ff0000000000000)));
    // Three bits of the mantissa pick the interval, in the upper word and in the lower word of each lane.
    const __m256i upper = _mm256_srli_epi64(bits, 17);
    const __m256i lower = _mm256_srli_epi64(bits, 49);
    const __m256i k = _mm256_blend_epi32(lower, upper, 0b10101010);
    const auto table = [](const unsigned* words, __m256i index) {
      return _mm256_permutevar8x32_epi32(_mm256_load_si256(reinterpret_cast<const __m256i*>(words)), index);
    };
    const __m256d c =
        _mm256_castsi256_pd(_mm256_blend_epi32(_mm256_setzero_si256(), table(inverse_words, k), 0b10101010));
    const __m256d log_c = _mm256_castsi256_pd(
        _mm256_blend_epi32(table(log_lower_words, k), table(log_upper_words, k), 0b10101010));
    const __m256d r = _mm256_fmsub_pd(m, c, _mm256_set1_pd(1.0));
    const __m256d r2 = _mm256_mul_pd(r, r);
    const __m256d r4 = _mm256_mul_pd(r2, r2);
    const auto pair = [&](double odd, double even) {
      return _mm256_fmadd_pd(_mm256_set1_pd(-1.0 / even), r, _mm256_set1_pd(1.0 / odd));
    };
    const __m256d p3 = _mm256_fmadd_pd(pair(5, 6), r2, pair(3, 4));
    const __m256d p7 = _mm256_fmadd_pd(pair(9, 10), r2, pair(7, 8));
    const __m256d p11 = _mm256_fmadd_pd(pair(13, 14), r2, pair(11, 12));
    __m256d p = _mm256_fmadd_pd(_mm256_fmadd_pd(p11, r4, p7), r4, p3);
    p = _mm256_fmadd_pd(p, r, _mm256_set1_pd(-0.5));
    const __m256d high = _mm256_fmadd_pd(e, _mm256_set1_pd(0x1.62e42fefa39efp-1), log_c);
    return _mm256_add_pd(high, _mm256_fmadd_pd(p, r2, r));
  }
};

}  // namespace

#include "core/rbf/simd/kernel_sums.inc"

namespace seesaw {
extern const KernelSums avx2_kernel_sums = sums_of("avx2");
}
