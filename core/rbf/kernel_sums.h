// The program's hot loop: sums of w_j phi(|x - c_j|) over all centers j, for a batch of points x.
//
// Before it: core/rbf/interpolant.h brings points and centers into normalized coordinates (about unit size).
// After it: eq. 5 of Turk & O'Brien 2002 lacks only its polynomial.
//
// Points lie across the lanes of a vector register and the loop runs over centers, so there is no sum across
// lanes and nothing a compiler would have to reorder: without -ffast-math a plain loop over centers is three
// to four times slower, because floating-point addition may not be reassociated. A lane's arithmetic does not
// depend on its neighbors, so a point's value does not depend on the batch it came in.
//
// The same source (core/rbf/simd/kernel_sums.inc) is compiled once for each instruction set, and the best one
// the processor has is chosen when the program runs.
#pragma once

#include <cstdint>

#include "core/rbf/kernel.h"

namespace seesaw {

/// Centers as the loop wants them: one array a coordinate, and one of weights, each of `count` numbers.
struct CenterArrays {
  const double* const* coordinates = nullptr;
  const double* weights = nullptr;
  std::int64_t count = 0;
};

/// Points of a batch: one array a coordinate, each with room for `count` rounded up to `padding`; what stands
/// in the rest is read (so must be a finite number) but means nothing.
struct PointArrays {
  const double* const* coordinates = nullptr;
  std::int64_t count = 0;
  static constexpr std::int64_t padding = 8;
};

/// The loops for one instruction set. All pointers must be set and have room for the padded count.
struct KernelSums {
  const char* name;

  /// values[i] = sum_j w_j phi(|x_i - c_j|). Added up in blocks whose sums are added with their rounding
  /// errors kept, so that the error stays near 1e-16 of sum_j |w_j phi| however many centers there are.
  void (*values)(Kernel, int dimension, const CenterArrays&, const PointArrays&, double* values);

  /// As above, and gradients[d][i] = sum_j w_j phi'(r) / r (x_i - c_j)_d; a center on the point itself gives
  /// 0.
  void (*gradients)(Kernel, int dimension, const CenterArrays&, const PointArrays&, double* values,
                    double* const* gradients);

  /// hessians[k][i], k over the pairs a <= b of coordinates in the order 00 01 11 02 12 22 ..., of
  ///     sum_j w_j (g I + h d d'),  d = x_i - c_j,  g = phi'(r) / r,  h = (phi''(r) - g) / r^2.
  /// A center on the point itself gives 0: for r^2 log r and r the second derivatives do not exist there.
  void (*hessians)(Kernel, int dimension, const CenterArrays&, const PointArrays&, double* const* hessians);

  /// values[j] = phi(|x - c_j|), over centers; weights are not used. The rows of eq. 8's matrix.
  void (*kernel_values)(Kernel, int dimension, const CenterArrays&, const double* point, double* values);
};

/// The largest dimension the loops are compiled for.
inline constexpr int max_dimension = 4;

/// The loops for the best instruction set of this processor; "avx512", "avx2" or "portable". The environment
/// variable SEESAW_LOOPS may name a lesser one, for the same digits as on another machine; a name it lacks is
/// ignored.
const KernelSums& kernel_sums();

/// The loops by that name, or nullptr where the processor or the build lacks them. For tests and benchmarks.
const KernelSums* kernel_sums_named(const char* name);

/// Makes `kernel_sums()` answer these from now on, in this process. For tests and benchmarks.
void use_kernel_sums(const KernelSums& sums);

}  // namespace seesaw
