// Monomials of Dim variables in one order, worked out by the compiler.
//
// Before it: nothing.  After it: gradient_bound.cpp and the loops that feed it sum tensors as polynomials: a
// symmetric tensor T of degree n is the form T[u, ..., u] = sum_k ways_k T_k u^k over the monomials k.
//
// A monomial of degree n is a nondecreasing sequence of coordinates; those of degree n are those of degree n
// - 1, each extended by every coordinate from its last on. (Plain arrays and nothing that a linker might
// share: this is also compiled for instructions that other processors lack.)
#pragma once

namespace seesaw {

template <int Dim>
struct Monomials {
  static constexpr int degrees = 5;
  static constexpr int most = Dim == 2 ? 6 : Dim == 3 ? 21 : 56;  // of degree 5
  static_assert(2 <= Dim && Dim <= 4);

  int count[degrees + 1] = {};
  int parent[degrees + 1][most] = {};       ///< of degree n - 1: without the last coordinate
  int last[degrees + 1][most] = {};         ///< the last coordinate
  int ways[degrees + 1][most] = {};         ///< n! / (a! b! ...): as often the tensor holds it
  int raised[degrees + 1][most][Dim] = {};  ///< of degree n + 1: times coordinate d
};

template <int Dim>
consteval Monomials<Dim> make_monomials() {
  Monomials<Dim> m;
  int exponents[Monomials<Dim>::degrees + 1][Monomials<Dim>::most][Dim] = {};
  m.count[0] = m.ways[0][0] = 1;
  for (int n = 1; n <= Monomials<Dim>::degrees; ++n)
    for (int p = 0; p < m.count[n - 1]; ++p)
      for (int d = n == 1 ? 0 : m.last[n - 1][p]; d < Dim; ++d) {
        const int k = m.count[n]++;
        m.parent[n][k] = p;
        m.last[n][k] = d;
        for (int e = 0; e < Dim; ++e) exponents[n][k][e] = exponents[n - 1][p][e] + (e == d ? 1 : 0);
        // n! / (.. a! ..) from (n - 1)! / (.. (a - 1)! ..)
        m.ways[n][k] = m.ways[n - 1][p] * n / exponents[n][k][d];
      }
  for (int n = 0; n < Monomials<Dim>::degrees; ++n)
    for (int k = 0; k < m.count[n]; ++k)
      for (int d = 0; d < Dim; ++d)
        for (int other = 0; other < m.count[n + 1]; ++other) {
          bool same = true;
          for (int e = 0; e < Dim; ++e)
            same = same && exponents[n + 1][other][e] == exponents[n][k][e] + (e == d ? 1 : 0);
          if (same) m.raised[n][k][d] = other;
        }
  return m;
}

template <int Dim>
inline constexpr Monomials<Dim> monomials = make_monomials<Dim>();

}  // namespace seesaw
