#include "core/rbf/solve.h"

#include <Eigen/QR>
#include <array>

#include "core/base/check.h"
#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/rbf/dense.h"
#include "core/rbf/kernel_sums.h"

namespace seesaw {

namespace {

// The centers, one array a coordinate.
template <int Dim>
struct Columns {
  Eigen::Matrix<double, Eigen::Dynamic, Dim> numbers;
  std::array<const double*, Dim> starts;

  explicit Columns(const PointsRef<Dim>& centers) : numbers(centers.transpose()) {
    for (int d = 0; d < Dim; ++d) starts[static_cast<std::size_t>(d)] = numbers.col(d).data();
  }
  // Pointers to each coordinate from row `first` on.
  std::array<const double*, Dim> from(Index first) const {
    auto pointers = starts;
    for (auto& pointer : pointers) pointer += first;
    return pointers;
  }
};

// Phi V without ever storing Phi: the sums of eq. 5 at the centers, with V's columns for weights. Faster than
// reading the matrix back from memory, and the same whatever the number of threads.
template <int Dim>
Eigen::MatrixXd kernel_times(const Columns<Dim>& centers, Kernel kernel, const Eigen::MatrixXd& v) {
  const Index n = v.rows();
  Eigen::MatrixXd result(n, v.cols());
  constexpr Index block = 64;
  parallel_blocks(n, block, [&](Index begin, Index end) {
    std::array<std::array<double, block>, Dim> points{};
    std::array<double, block> sums;
    std::array<const double*, Dim> pointers;
    for (std::size_t d = 0; d < Dim; ++d) pointers[d] = points[d].data();
    for (Index first = begin; first < end; first += block) {
      const Index count = std::min(block, end - first);
      for (std::size_t d = 0; d < Dim; ++d) std::copy_n(centers.starts[d] + first, count, points[d].begin());
      for (Index k = 0; k < v.cols(); ++k) {
        kernel_sums().values(kernel, Dim, {centers.starts.data(), v.col(k).data(), n},
                             {pointers.data(), count}, sums.data());
        std::copy_n(sums.begin(), count, result.col(k).data() + first);
      }
    }
  });
  return result;
}

}  // namespace

template <int Dim>
Factorization<Dim>::Factorization(const PointsRef<Dim>& centers, Kernel kernel, double smoothing)
    : n_(centers.cols()), sign_(kernel == Kernel::linear ? -1.0 : 1.0) {
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
  const Columns<Dim> columns(centers);
  const Eigen::MatrixXd z = kernel_times<Dim>(columns, kernel, reflectors_) * triangle_;
  const Eigen::MatrixXd y = z - 0.5 * reflectors_ * (triangle_.transpose() * (reflectors_.transpose() * z));
  matrix_.resize(n_, n_);
  parallel_blocks(n_, 16, [&](Index begin, Index end) {
    for (Index j = begin; j < end; ++j) {
      const auto from = columns.from(j);
      const Index below = n_ - j;
      auto column = matrix_.col(j).tail(below);
      const Point<Dim> center = centers.col(j);
      kernel_sums().kernel_values(kernel, Dim, {from.data(), nullptr, below}, center.data(), column.data());
      column[0] += sign_ * smoothing;
      for (Index k = 0; k < rank_; ++k)
        column -= reflectors_.col(k).tail(below) * y(j, k) + y.col(k).tail(below) * reflectors_(j, k);
      column *= sign_;
    }
  });

  const Index free = n_ - rank_;
  double* trailing = matrix_.data() + rank_ * (n_ + 1);
  norm1_ = dense::norm1(trailing, free, n_);
  positive_definite_ = dense::cholesky(trailing, free, n_);
}

template <int Dim>
double Factorization<Dim>::reciprocal_condition() const {
  if (!positive_definite_) return 0.0;
  return dense::reciprocal_condition(matrix_.data() + rank_ * (n_ + 1), n_ - rank_, n_, norm1_);
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
Solution Factorization<Dim>::solve(const Eigen::Ref<const Values>& values) const {
  SEESAW_CHECK_EQ(values.size(), n_);
  SEESAW_CHECK_EQ(positive_definite_, true);
  const Index free = n_ - rank_;
  const Values rotated = apply_q_transposed(values);
  Values v = Values::Zero(n_);
  v.tail(free) = sign_ * rotated.tail(free);
  dense::solve(matrix_.data() + rank_ * (n_ + 1), free, n_, v.data() + rank_);

  Solution solution;
  // Q1' Phi w = (first block row of Q' Phi Q) v = B21' v, and B21 stands in the matrix's first columns.
  const Values from_weights = sign_ * matrix_.block(rank_, 0, free, rank_).transpose() * v.tail(free);
  solution.polynomial = polynomial_ * (rotated.head(rank_) - from_weights);
  solution.polynomial[0] -= solution.polynomial.template tail<Dim>().dot(mean_);
  solution.weights = apply_q(std::move(v));
  return solution;
}

template class Factorization<2>;
template class Factorization<3>;
template class Factorization<4>;

}  // namespace seesaw
