// The ceiling for AVX-512: 32 points in four registers, one center at a time.
#include <immintrin.h>

#include "bench/ceiling.h"

namespace seesaw::bench {

namespace {

constexpr int wide = 4;
inline __m512d all(double x) { return _mm512_set1_pd(x); }

// s sqrt(s): the estimate y of 1 / sqrt(s) has 14 bits; with e = 1 - s y^2, sqrt(s) = s y (1 - e)^(-1/2), and
// three terms of that series make 56 bits of them.
inline __m512d cubic(__m512d s) {
  const __m512d y = _mm512_rsqrt14_pd(s);
  const __m512d g = _mm512_mul_pd(s, y);
  const __m512d e = _mm512_fnmadd_pd(g, y, all(1.0));
  const __m512d p = _mm512_fmadd_pd(_mm512_fmadd_pd(all(0.3125), e, all(0.375)), e, all(0.5));
  return _mm512_mul_pd(s, _mm512_fmadd_pd(_mm512_mul_pd(g, e), p, g));
}

// The middle of interval k of [1, 2), k = 0 .. 15, is (33 + 2 k) / 32: c is its inverse cut to 24 bits, l =
// -log c.
alignas(64) constexpr double c[16] = {
    0x1.f07c200000000p-1, 0x1.d41d420000000p-1, 0x1.bacf920000000p-1, 0x1.a41a420000000p-1,
    0x1.8f9c180000000p-1, 0x1.7d05f40000000p-1, 0x1.6c16c20000000p-1, 0x1.5c98820000000p-1,
    0x1.4e5e0a0000000p-1, 0x1.4141420000000p-1, 0x1.3521d00000000p-1, 0x1.29e4120000000p-1,
    0x1.1f70480000000p-1, 0x1.15b1e60000000p-1, 0x1.0c97140000000p-1, 0x1.0410420000000p-1,
};
alignas(64) constexpr double l[16] = {
    0x1.f82990e783380p-6, 0x1.6f0d272e56b4dp-4, 0x1.29552c41ff52ep-3, 0x1.9525a80f456b8p-3,
    0x1.fb918bd5e3e44p-3, 0x1.2e8e2bee11d31p-2, 0x1.5d1bda55809d0p-2, 0x1.89a33a8c14264p-2,
    0x1.b44f791cc8f66p-2, 0x1.dd469dec1c4acp-2, 0x1.025529da5d100p-1, 0x1.154c3e3f4d5eep-1,
    0x1.2795e0e89b11bp-1, 0x1.393e0d2562a1ap-1, 0x1.4a4f87bb03ec9p-1, 0x1.5ad402d359f3cp-1,
};

// s log(s): s = 2^e m, r = c m - 1, log s = e log 2 + l + log(1 + r), the last by its series to r^10.
inline __m512d thin_plate(__m512d s, __m512d c0, __m512d c1, __m512d l0, __m512d l1) {
  const __m512d m = _mm512_getmant_pd(s, _MM_MANT_NORM_1_2, _MM_MANT_SIGN_zero);
  const __m512d e = _mm512_getexp_pd(s);
  const __m512i k = _mm512_srli_epi64(_mm512_castpd_si512(s), 48);
  const __m512d r = _mm512_fmsub_pd(m, _mm512_permutex2var_pd(c0, k, c1), all(1.0));
  const __m512d high = _mm512_fmadd_pd(e, all(0x1.62e42fefa39efp-1), _mm512_permutex2var_pd(l0, k, l1));
  __m512d p = all(-1.0 / 10);
  for (int term = 9; term >= 1; --term) p = _mm512_fmadd_pd(p, r, all((term % 2 ? 1.0 : -1.0) / term));
  return _mm512_mul_pd(s, _mm512_fmadd_pd(p, r, high));
}

}  // namespace

void cubic_3d_avx512(const CenterArrays& centers, const PointArrays& points, double* values) {
  const double *cx = centers.coordinates[0], *cy = centers.coordinates[1], *cz = centers.coordinates[2];
  for (std::int64_t i = 0; i < points.count; i += 8 * wide) {
    __m512d x[wide], y[wide], z[wide], sum[wide];
    for (int u = 0; u < wide; ++u) {
      x[u] = _mm512_loadu_pd(points.coordinates[0] + i + 8 * u);
      y[u] = _mm512_loadu_pd(points.coordinates[1] + i + 8 * u);
      z[u] = _mm512_loadu_pd(points.coordinates[2] + i + 8 * u);
      sum[u] = _mm512_setzero_pd();
    }
    for (std::int64_t j = 0; j < centers.count; ++j) {
      for (int u = 0; u < wide; ++u) {
        const __m512d dx = _mm512_sub_pd(x[u], all(cx[j])), dy = _mm512_sub_pd(y[u], all(cy[j]));
        const __m512d dz = _mm512_sub_pd(z[u], all(cz[j]));
        const __m512d s = _mm512_fmadd_pd(dx, dx, _mm512_fmadd_pd(dy, dy, _mm512_mul_pd(dz, dz)));
        sum[u] = _mm512_fmadd_pd(all(centers.weights[j]), cubic(s), sum[u]);
      }
    }
    for (int u = 0; u < wide; ++u) _mm512_storeu_pd(values + i + 8 * u, sum[u]);
  }
}

void thin_plate_2d_avx512(const CenterArrays& centers, const PointArrays& points, double* values) {
  const double *cx = centers.coordinates[0], *cy = centers.coordinates[1];
  const __m512d c0 = _mm512_load_pd(c), c1 = _mm512_load_pd(c + 8);
  const __m512d l0 = _mm512_load_pd(l), l1 = _mm512_load_pd(l + 8);
  for (std::int64_t i = 0; i < points.count; i += 8 * wide) {
    __m512d x[wide], y[wide], sum[wide];
    for (int u = 0; u < wide; ++u) {
      x[u] = _mm512_loadu_pd(points.coordinates[0] + i + 8 * u);
      y[u] = _mm512_loadu_pd(points.coordinates[1] + i + 8 * u);
      sum[u] = _mm512_setzero_pd();
    }
    for (std::int64_t j = 0; j < centers.count; ++j) {
      for (int u = 0; u < wide; ++u) {
        const __m512d dx = _mm512_sub_pd(x[u], all(cx[j])), dy = _mm512_sub_pd(y[u], all(cy[j]));
        const __m512d s = _mm512_fmadd_pd(dx, dx, _mm512_mul_pd(dy, dy));
        sum[u] = _mm512_fmadd_pd(all(centers.weights[j]), thin_plate(s, c0, c1, l0, l1), sum[u]);
      }
    }
    for (int u = 0; u < wide; ++u) _mm512_storeu_pd(values + i + 8 * u, _mm512_mul_pd(all(0.5), sum[u]));
  }
}

}  // namespace seesaw::bench
