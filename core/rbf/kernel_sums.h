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
#include "core/rbf/monomials.h"

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

/// A ball, and what its neighborhood is: centers up to `near` from the middle.
struct Ball {
  const double* middle = nullptr;
  double radius = 0, near = 0;
};

/// Where each part stands in what `KernelSums::ball` sums up. With x = middle - c_j and a_q(r) the q-fold
/// (1/r d/dr) of phi, moment (q, n) is sum_j w_j a_q(r_j) x_j^k over the monomials k of degree n
/// (monomials.h). The derivatives of order 1 .. 5 take (order - p, order - 2 p), p = 0 .. order / 2.
template <int Dim>
struct BallSums {
  static constexpr int orders = 5;
  int moment[orders + 1][orders + 1] = {};  ///< [q][n]: where it starts
  int remainder = 0;                        ///< sum_j |w_j| / (r_j - radius)^{6 - growth}, not near
  int near = 0;                             ///< sum_j |w_j|, near
  int magnitude = 0;                        ///< of all that was added up, for the rounding
  int count = 0;
};
template <int Dim>
consteval BallSums<Dim> make_ball_sums() {
  BallSums<Dim> s;
  for (int order = 1; order <= BallSums<Dim>::orders; ++order)
    for (int p = 0; 2 * p <= order; ++p) {
      s.moment[order - p][order - 2 * p] = s.count;
      s.count += monomials<Dim>.count[order - 2 * p];
    }
  s.remainder = s.count++;
  s.near = s.count++;
  s.magnitude = s.count++;
  return s;
}
template <int Dim>
inline constexpr BallSums<Dim> ball_sums = make_ball_sums<Dim>();

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

  /// The sums that bound |grad f| in a ball (gradient_bound.h), as BallSums lays them out. Near centers count
  /// in the derivatives that exist across them: up to the second for r^3, the first for r^2 log r, none for
  /// r. Logarithms are of r / radius (of r for a ball without one).
  void (*ball)(Kernel, int dimension, const CenterArrays&, const Ball&, double* sums);
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
