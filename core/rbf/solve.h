// From rows to weights: the linear system of eq. 8, solved.
//
// Before it: core/rbf/system.h, the rows.  After it: core/rbf/interpolant.h, a function.
//
// Turk & O'Brien 2002, eq. 8, with Phi_ij = phi(|c_i - c_j|), P = [1 c'] of N x (Dim + 1), weights w,
// polynomial p:
//
//     [ Phi + s lambda I   P ] [w]   [h]
//     [        P'          0 ] [p] = [0]          s = +1 for r^2 log r and r^3, -1 for r
//
// with lambda the smoothing.
//
// The matrix is symmetric but indefinite, so neither Cholesky nor a plain L D L' may touch it (the latter
// returns garbage without a word). The paper uses LU. Better: the side conditions P' w = 0 say that w lies in
// the null space of P'. With P = Q R (Householder), Q = [Q1 Q2], every such w is Q2 v, and
//
//     s Q2' (Phi + s lambda I) Q2 v = s Q2' h           is positive definite: Cholesky solves it;
//     R p = Q1' (h - Phi w)                             then gives the polynomial.
//
// That is half the multiplications of LU of eq. 8, at a reciprocal condition (N = 1600) of 4e-9 instead of
// 1e-12.
//
// Right sides [h; b] with P' w = b are met by w = Q1 z + Q2 v with R' z = b: what Q1 z adds to the top goes
// to the right. core/rbf/border.h and sensitivity.h need these.
//
// Where all centers lie on one line (2D) or plane (3D), P has no full rank: the weights are determined all
// the same and the polynomial is not. Among those that fit, the one of least norm is taken: it is constant
// across the line, so f is the same on both sides.
#pragma once

#include "core/base/progress.h"
#include "core/base/types.h"
#include "core/rbf/dense.h"
#include "core/rbf/inverse_norm.h"
#include "core/rbf/kernel.h"

namespace seesaw {

/// Weights and polynomial in the coordinates of `centers`, which should be normalized (core/rbf/system.h).
struct Solution {
  Values weights;     ///< N
  Values polynomial;  ///< Dim + 1: constant, then the linear part
};

/// Factors the system of N centers once, and solves it for any values. Memory: N^2 / 2 doubles. Time: N^3 / 3
/// multiplications in Cholesky and little besides.
template <int Dim>
class Factorization {
 public:
  /// `centers` Dim x N, N >= 1, normalized and pairwise distinct; `smoothing` >= 0 in their units. Throws
  /// Cancelled where `progress` says stop.
  Factorization(const PointsRef<Dim>& centers, Kernel kernel, double smoothing,
                const Progress& progress = {});

  /// False when Cholesky failed: two centers are too near to be told apart. Nothing can be solved then.
  bool positive_definite() const { return positive_definite_; }
  /// Dim + 1 for centers in general position, less for centers on one line or plane.
  Index polynomial_rank() const { return rank_; }

  /// Weights and polynomial for values h (N). Needs positive_definite(). 2 N^2 multiplications. Not const:
  /// the first calls also carry the condition's estimate forward.
  Solution solve(const Eigen::Ref<const Values>& values);
  /// [w; p] for many right sides [h; b] at once, (N + Dim + 1) x m, whose bottoms need not be zero: P' w = b
  /// may ask for any sums over the weights (for centers on one line or plane: for what sums there can be, the
  /// nearest). The matrix is read once for all of them. Needs positive_definite(). 2 N^2 multiplications
  /// each. Throws Cancelled where `progress` says stop.
  Eigen::MatrixXd solve_all(const Eigen::MatrixXd& right_sides, const Progress& progress = {}) const;
  /// Of s Q2' (Phi + s lambda I) Q2 in the 1-norm, estimated; three solves, less those that rode along above.
  double reciprocal_condition();

 private:
  using Skinny = Eigen::MatrixXd;  // N x rank

  // What fills matrix_ with s Phi + lambda I.
  dense::FillColumns columns_of(const PointsRef<Dim>& centers, Kernel kernel, double smoothing);
  Values apply_q(Values x) const;             // Q x
  Values apply_q_transposed(Values x) const;  // Q' x

  Index n_, rank_;
  double sign_, norm1_ = 0.0;
  bool positive_definite_ = true;
  Point<Dim> mean_;             // linear functions are taken about it
  Skinny reflectors_;           // V: Q = I - V T V'
  Eigen::MatrixXd triangle_;    // T
  Eigen::MatrixXd polynomial_;  // (Dim + 1) x rank, takes Q1' (h - Phi w) to p
  dense::Symmetric matrix_;     // s Q' Phi Q; its trailing block factored in place
  InverseNorm estimate_{0};     // of that block's inverse
};

extern template class Factorization<2>;
extern template class Factorization<3>;
extern template class Factorization<4>;

}  // namespace seesaw
