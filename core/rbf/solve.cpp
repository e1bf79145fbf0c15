#include "core/rbf/solve.h"

#include <Eigen/QR>
#include <algorithm>
#include <array>

#include "core/base/check.h"
#include "core/base/tolerances.h"
#include "core/rbf/dense.h"
#include "core/rbf/kernel_sums.h"

namespace seesaw {

template <int Dim>
Factorization<Dim>::Factorization(const PointsRef<Dim>& centers, Kernel kernel, double smoothing,
                                  const Progress& progress)
    : n_(centers.cols()), sign_(kernel == Kernel::linear ? -1.0 : 1.0), matrix_(n_) {
  SEESAW_CHECK_LE(1, n_);
  SEESAW_CHECK_LE(0.0, smoothing);

  // P = Q R with column pivoting, which also tells P's rank. Linear functions are taken about the mean of the
  // centers, which lies on their line or plane if they have one: the polynomial of least norm is then level
  // across it.
  mean_ = centers.rowwise().mean();
  Eigen::MatrixXd p(n_, Dim + 1);
  p.col(0).setOnes();
  p.rightCols(Dim) = (centers.colwise() - mean_).transpose();
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(p);
  qr.setThreshold(tolerance::degenerate);
  rank_ = qr.rank();
  estimate_ = InverseNorm(n_ - rank_);

  // The reflectors one after the other, H_k = I - t_k v_k v_k', as one block: Q = I - V T V' (Schreiber & Van
  // Loan 1989).
  reflectors_ = qr.matrixQR().leftCols(rank_).template triangularView<Eigen::StrictlyLower>();
  reflectors_.topRows(rank_) += Eigen::MatrixXd::Identity(rank_, rank_);
  triangle_ = Eigen::MatrixXd::Zero(rank_, rank_);
  for (Index k = 0; k < rank_; ++k) {
    const double t = qr.hCoeffs()[k];
    triangle_(k, k) = t;
    const Values overlaps = reflectors_.leftCols(k).transpose() * reflectors_.col(k);
    triangle_.col(k).head(k) = -t * (triangle_.topLeftCorner(k, k) * overlaps).eval();
  }

  // Q1' P p = r has one solution or many; the pseudo-inverse takes the least-norm one.
  const Eigen::MatrixXd r =
      Eigen::MatrixXd(qr.matrixQR().topRows(rank_).template triangularView<Eigen::Upper>()) *
      qr.colsPermutation().transpose();
  polynomial_ = r.completeOrthogonalDecomposition().pseudoInverse();

  // Q' Phi Q = Phi - V Y' - Y V'  with  Z = Phi V T  and  Y = Z - V T' V' Z / 2.
  const Eigen::MatrixXd z = dense::fill_and_multiply(matrix_, columns_of(centers, kernel, smoothing),
                                                     reflectors_ * triangle_, share_of(progress, 0.0, 0.1));
  norm1_ = dense::subtract_products(
      matrix_, reflectors_, z - 0.5 * reflectors_ * (triangle_.transpose() * (reflectors_.transpose() * z)),
      rank_, share_of(progress, 0.1, 0.15));
  positive_definite_ = dense::cholesky(matrix_, rank_, share_of(progress, 0.15, 1.0));
}

template <int Dim>
dense::FillColumns Factorization<Dim>::columns_of(const PointsRef<Dim>& centers, Kernel kernel,
                                                  double smoothing) {
  // The loops want the centers as one array a coordinate.
  const Eigen::Matrix<double, Eigen::Dynamic, Dim> coordinates = centers.transpose();
  return [this, kernel, smoothing, coordinates](Index begin, Index count) {
    for (Index j = begin; j < begin + count; ++j) {
      std::array<const double*, Dim> from;
      for (int d = 0; d < Dim; ++d) from[static_cast<std::size_t>(d)] = coordinates.col(d).data() + j;
      const Point<Dim> center = coordinates.row(j);
      auto column = matrix_.column_from(j, j);
      kernel_sums().kernel_values(kernel, Dim, {from.data(), nullptr, n_ - j}, center.data(), column.data());
      if (sign_ < 0) column = -column;
      column[0] += smoothing;
    }
  };
}

template <int Dim>
Values Factorization<Dim>::apply_q(Values x) const {
  return x - reflectors_ * (triangle_ * (reflectors_.transpose() * x));
}

template <int Dim>
Values Factorization<Dim>::apply_q_transposed(Values x) const {
  return x - reflectors_ * (triangle_.transpose() * (reflectors_.transpose() * x));
}

template <int Dim>
Solution Factorization<Dim>::solve(const Eigen::Ref<const Values>& values) {
  SEESAW_CHECK_EQ(values.size(), n_);
  SEESAW_CHECK_EQ(positive_definite_, true);
  const Index free = n_ - rank_;
  const Values rotated = apply_q_transposed(values);
  Values v = Values::Zero(n_);
  v.tail(free) = sign_ * rotated.tail(free);
  // The condition's estimate needs solves of its own; they ride along, so that the matrix is read once for
  // both.
  Eigen::MatrixXd both(free, estimate_.wants_solve() ? 2 : 1);
  both.col(0) = v.tail(free);
  if (both.cols() == 2) both.col(1) = estimate_.next();
  dense::solve(matrix_, rank_, both);
  v.tail(free) = both.col(0);
  if (both.cols() == 2) estimate_.take(both.col(1));

  Solution solution;
  // Q1' Phi w = (first block row of Q' Phi Q) v = B21' v, and B21 stands in the matrix's first columns.
  Values from_weights(rank_);
  for (Index k = 0; k < rank_; ++k) from_weights[k] = sign_ * matrix_.column_from(rank_, k).dot(v.tail(free));
  solution.polynomial = polynomial_ * (rotated.head(rank_) - from_weights);
  solution.polynomial[0] -= solution.polynomial.template tail<Dim>().dot(mean_);
  solution.weights = apply_q(std::move(v));
  return solution;
}

template <int Dim>
Eigen::MatrixXd Factorization<Dim>::solve_all(const Eigen::MatrixXd& right_sides,
                                              const Progress& progress) const {
  SEESAW_CHECK_EQ(right_sides.rows(), n_ + Dim + 1);
  SEESAW_CHECK_EQ(positive_definite_, true);
  const Index free = n_ - rank_, m = right_sides.cols();
  Eigen::MatrixXd bottoms = right_sides.bottomRows(Dim + 1);
  bottoms.bottomRows(Dim) -= mean_ * bottoms.row(0);
  const Eigen::MatrixXd z = polynomial_.transpose() * bottoms;

  Eigen::MatrixXd rotated(n_, m), v(free, m);
  for (Index k = 0; k < m; ++k) {
    rotated.col(k) = apply_q_transposed(right_sides.col(k).head(n_));
    v.col(k) = sign_ * rotated.col(k).tail(free);
    for (Index i = 0; i < rank_; ++i) v.col(k) -= z(i, k) * matrix_.column_from(rank_, i);
  }
  dense::solve(matrix_, rank_, v, progress);

  Eigen::MatrixXd result(n_ + Dim + 1, m);
  for (Index k = 0; k < m; ++k) {
    Values left = rotated.col(k).head(rank_);  // Q1' (h - Phi w)
    for (Index i = 0; i < rank_; ++i) {
      left[i] -= sign_ * matrix_.column_from(rank_, i).dot(v.col(k));
      for (Index j = 0; j < rank_; ++j)
        left[i] -= sign_ * *matrix_.at(std::max(i, j), std::min(i, j)) * z(j, k);
    }
    Values w(n_);
    w << z.col(k), v.col(k);
    result.col(k).head(n_) = apply_q(std::move(w));
    auto p = result.col(k).tail(Dim + 1);
    p = polynomial_ * left;
    p[0] -= p.template tail<Dim>().dot(mean_);
  }
  return result;
}

template <int Dim>
double Factorization<Dim>::reciprocal_condition() {
  if (!positive_definite_) return 0.0;
  while (estimate_.wants_solve()) {
    Eigen::MatrixXd x = estimate_.next();
    dense::solve(matrix_, rank_, x);
    estimate_.take(x);
  }
  return n_ == rank_ ? 1.0 : 1.0 / (norm1_ * estimate_.value());
}

template class Factorization<2>;
template class Factorization<3>;
template class Factorization<4>;

}  // namespace seesaw
