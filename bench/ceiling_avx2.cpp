// The ceiling for AVX2 with FMA: 12 points in three registers, two centers at a time.
#include <immintrin.h>

#include "bench/ceiling.h"

namespace seesaw::bench {

namespace {

constexpr int wide = 3;
inline __m256d all(double x) { return _mm256_set1_pd(x); }

// s sqrt(s) on the hardware's square root, which runs beside the arithmetic units ...
inline __m256d cubic_by_hardware(__m256d s) { return _mm256_mul_pd(s, _mm256_sqrt_pd(s)); }

// ... and on the arithmetic units: 12 bits of 1 / sqrt(s) from single precision, one step of third order (36
// bits), one of second (to double). Taking turns keeps both kinds of units busy.
inline __m256d cubic_by_arithmetic(__m256d s) {
  const __m256d y = _mm256_cvtps_pd(_mm_rsqrt_ps(_mm256_cvtpd_ps(s)));
  const __m256d g = _mm256_mul_pd(s, y);
  const __m256d e = _mm256_fnmadd_pd(g, y, all(1.0));
  const __m256d q = _mm256_mul_pd(e, _mm256_fmadd_pd(e, all(0.375), all(0.5)));
  const __m256d root = _mm256_fmadd_pd(g, q, g);
  const __m256d half_inverse = _mm256_mul_pd(all(0.5), _mm256_fmadd_pd(y, q, y));
  const __m256d last = _mm256_fnmadd_pd(root, root, s);
  return _mm256_mul_pd(s, _mm256_fmadd_pd(last, half_inverse, root));
}

// s log(s): s = 2^e m with m in [sqrt(1/2), sqrt(2)), log m = 2 atanh(t) with t = (m - 1) / (m + 1), |t| <
// 0.172, by its series to t^21. The division runs beside the arithmetic units, as the square root does.
inline __m256d thin_plate(__m256d s) {
  const __m256i bits = _mm256_castpd_si256(s);
  // Shifts the boundary between two exponents from m = 1 to m = sqrt(1/2).
  const __m256i shifted = _mm256_sub_epi64(bits, _mm256_set1_epi64x(0x3fe6a09e00000000));
  const __m256i exponent =
      _mm256_and_si256(shifted, _mm256_set1_epi64x(static_cast<long long>(0xfff0000000000000)));
  const __m256d m = _mm256_castsi256_pd(_mm256_sub_epi64(bits, exponent));
  // The exponent as a double: an offset keeps it positive, and it becomes the low bits of 2^52.
  const __m256i positive =
      _mm256_srli_epi64(_mm256_add_epi64(exponent, _mm256_set1_epi64x(0x4000000000000000)), 52);
  const __m256d e =
      _mm256_sub_pd(_mm256_castsi256_pd(_mm256_or_si256(positive, _mm256_set1_epi64x(0x4330000000000000))),
                    all(4503599627370496.0 + 1024.0));
  const __m256d t = _mm256_div_pd(_mm256_sub_pd(m, all(1.0)), _mm256_add_pd(m, all(1.0)));
  const __m256d t2 = _mm256_mul_pd(t, t);
  __m256d p = all(2.0 / 21);
  for (int term = 19; term >= 1; term -= 2) p = _mm256_fmadd_pd(p, t2, all(2.0 / term));
  return _mm256_mul_pd(s, _mm256_fmadd_pd(e, all(0x1.62e42fefa39efp-1), _mm256_mul_pd(p, t)));
}

}  // namespace

void cubic_3d_avx2(const CenterArrays& centers, const PointArrays& points, double* values) {
  const double *cx = centers.coordinates[0], *cy = centers.coordinates[1], *cz = centers.coordinates[2];
  for (std::int64_t i = 0; i < points.count; i += 4 * wide) {
    __m256d x[wide], y[wide], z[wide], sum[wide];
    for (int u = 0; u < wide; ++u) {
      x[u] = _mm256_loadu_pd(points.coordinates[0] + i + 4 * u);
      y[u] = _mm256_loadu_pd(points.coordinates[1] + i + 4 * u);
      z[u] = _mm256_loadu_pd(points.coordinates[2] + i + 4 * u);
      sum[u] = _mm256_setzero_pd();
    }
    const auto squared = [&](std::int64_t j, int u) {
      const __m256d dx = _mm256_sub_pd(x[u], all(cx[j])), dy = _mm256_sub_pd(y[u], all(cy[j]));
      const __m256d dz = _mm256_sub_pd(z[u], all(cz[j]));
      return _mm256_fmadd_pd(dx, dx, _mm256_fmadd_pd(dy, dy, _mm256_mul_pd(dz, dz)));
    };
    for (std::int64_t j = 0; j < centers.count; j += 2) {
      for (int u = 0; u < wide; ++u) {
        sum[u] = _mm256_fmadd_pd(all(centers.weights[j]), cubic_by_hardware(squared(j, u)), sum[u]);
        sum[u] = _mm256_fmadd_pd(all(centers.weights[j + 1]), cubic_by_arithmetic(squared(j + 1, u)), sum[u]);
      }
    }
    for (int u = 0; u < wide; ++u) _mm256_storeu_pd(values + i + 4 * u, sum[u]);
  }
}

void thin_plate_2d_avx2(const CenterArrays& centers, const PointArrays& points, double* values) {
  const double *cx = centers.coordinates[0], *cy = centers.coordinates[1];
  for (std::int64_t i = 0; i < points.count; i += 4 * wide) {
    __m256d x[wide], y[wide], sum[wide];
    for (int u = 0; u < wide; ++u) {
      x[u] = _mm256_loadu_pd(points.coordinates[0] + i + 4 * u);
      y[u] = _mm256_loadu_pd(points.coordinates[1] + i + 4 * u);
      sum[u] = _mm256_setzero_pd();
    }
    for (std::int64_t j = 0; j < centers.count; ++j) {
      for (int u = 0; u < wide; ++u) {
        const __m256d dx = _mm256_sub_pd(x[u], all(cx[j])), dy = _mm256_sub_pd(y[u], all(cy[j]));
        const __m256d s = _mm256_fmadd_pd(dx, dx, _mm256_mul_pd(dy, dy));
        sum[u] = _mm256_fmadd_pd(all(centers.weights[j]), thin_plate(s), sum[u]);
      }
    }
    for (int u = 0; u < wide; ++u) _mm256_storeu_pd(values + i + 4 * u, _mm256_mul_pd(all(0.5), sum[u]));
  }
}

}  // namespace seesaw::bench
