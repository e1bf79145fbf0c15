// Seeded random numbers, the same on every machine and with every compiler.
//
// The standard's engines are exact but its distributions are not: two libraries draw different numbers from
// one seed. So the bits come from std::mt19937_64 and everything after is ours.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "core/base/types.h"

namespace seesaw {

/// A generator is always passed in, never global. Same seed, same numbers.
class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}

  /// Uniform in [0, 1): 53 random bits.
  double uniform() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
  /// Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Uniform in 0 .. n - 1, n >= 1. The bias, n / 2^64, is beyond any test of ours.
  Index index(Index n) { return static_cast<Index>(bits_() % static_cast<std::uint64_t>(n)); }
  std::uint64_t bits() { return bits_(); }

  /// Standard normal, by Box and Muller's transformation.
  double normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(6.283185307179586 * uniform());
  }

  /// N points uniform in `box`, Dim x N.
  template <int Dim>
  Points<Dim> points_in(const Box<Dim>& box, Index n) {
    Points<Dim> points(Dim, n);
    for (Index i = 0; i < n; ++i)
      for (int d = 0; d < Dim; ++d) points(d, i) = uniform(box.min()[d], box.max()[d]);
    return points;
  }

  /// A direction uniform on the unit circle or sphere.
  template <int Dim>
  Point<Dim> direction() {
    Point<Dim> v;
    do {
      for (int d = 0; d < Dim; ++d) v[d] = normal();
    } while (v.squaredNorm() < 1e-12);
    return v.normalized();
  }

 private:
  std::mt19937_64 bits_;
};

}  // namespace seesaw
