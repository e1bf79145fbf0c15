// The dense algebra beneath a fit, against Eigen's own; and the condition estimate against the true inverse.
#include "core/rbf/dense.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <atomic>

#include "core/base/random.h"
#include "core/rbf/inverse_norm.h"
#include "tests/core/rbf/dense_oracle.h"

namespace seesaw {
namespace {

Eigen::MatrixXd random_matrix(Index rows, Index columns, Random& random) {
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return random.uniform(-1, 1); });
}

// A symmetric matrix in our storage; what stands above its diagonal must never be read.
dense::Symmetric stored(const Eigen::MatrixXd& matrix) {
  const Index n = matrix.rows();
  dense::Symmetric result(n);
  std::fill_n(result.data(), result.stored(), std::nan(""));
  for (Index j = 0; j < n; ++j) result.column_from(j, j) = matrix.col(j).tail(n - j);
  return result;
}

class DenseTest : public testing::TestWithParam<std::tuple<Index, Index>> {
 protected:
  Index n = std::get<0>(GetParam()), first = std::min(std::get<1>(GetParam()), std::get<0>(GetParam()));
  Random random{5};
};

TEST_P(DenseTest, ProductsUpdatesAndNorms) {
  const Eigen::MatrixXd half = random_matrix(n, n, random), a = half + half.transpose();
  const Eigen::MatrixXd x = random_matrix(n, 4, random), y = random_matrix(n, 4, random);
  dense::Symmetric s = stored(Eigen::MatrixXd::Constant(n, n, std::nan("")));
  std::vector<std::atomic<int>> written(static_cast<std::size_t>(n));
  const auto fill = [&](Index begin, Index count) {
    for (Index j = begin; j < begin + count; ++j) {
      s.column_from(j, j) = a.col(j).tail(n - j);
      ++written[static_cast<std::size_t>(j)];
    }
  };
  EXPECT_LE((dense::fill_and_multiply(s, fill, x) - a * x).norm(), 1e-13 * static_cast<double>(n));
  for (const auto& times : written) EXPECT_EQ(times, 1);
  const double norm1 = dense::subtract_products(s, x, y, first);
  const Eigen::MatrixXd b = a - x * y.transpose() - y * x.transpose();
  for (Index j = 0; j < n; ++j)
    EXPECT_LE((Values(s.column_from(j, j)) - b.col(j).tail(n - j)).norm(), 1e-13 * static_cast<double>(n));
  const Index rest = n - first;
  const double expected =
      rest > 0 ? b.bottomRightCorner(rest, rest).cwiseAbs().colwise().sum().maxCoeff() : 0.0;
  EXPECT_NEAR(norm1, expected, 1e-12 * static_cast<double>(n));
}

TEST_P(DenseTest, CholeskySolvesTheTrailingBlock) {
  const Eigen::MatrixXd root = random_matrix(n, n, random);
  const Eigen::MatrixXd a = root * root.transpose() + Eigen::MatrixXd::Identity(n, n);
  const Index rest = n - first;
  dense::Symmetric s = stored(a);
  ASSERT_TRUE(dense::cholesky(s, first));
  const Eigen::MatrixXd block = a.bottomRightCorner(rest, rest);
  for (const Index columns : {3, 9}) {  // few and many go different ways
    const Eigen::MatrixXd b = random_matrix(rest + 2, columns, random);
    Eigen::MatrixXd x = b;
    dense::solve(s, first, x.topRows(rest));
    EXPECT_LE((block * x.topRows(rest) - b.topRows(rest)).norm(), 1e-11 * static_cast<double>(n));
    EXPECT_EQ(x.bottomRows(2), b.bottomRows(2));
  }
  // Rows and columns before the block are left as they were.
  for (Index j = 0; j < first; ++j) EXPECT_EQ(Values(s.column_from(j, j)), Values(a.col(j).tail(n - j)));
}

TEST_P(DenseTest, CholeskyRefusesWhatIsNotPositiveDefinite) {
  const Index rest = n - first;
  if (rest == 0) return;
  Eigen::MatrixXd a = Eigen::MatrixXd::Identity(n, n);
  a(n - 1, n - 1) = -1e-3;
  dense::Symmetric s = stored(a);
  EXPECT_FALSE(dense::cholesky(s, first));
}

INSTANTIATE_TEST_SUITE_P(Sizes, DenseTest,
                         testing::Combine(testing::Values<Index>(1, 2, 5, 31, 32, 96, 97, 250, 384, 385, 900),
                                          testing::Values<Index>(0, 3, 5)));

// What fits twice in a row, or a little more the second time, asks the system for memory once.
TEST(MatrixMemory, TheLastPieceIsKept) {
  constexpr Index count = 1 << 20;
  double* first = nullptr;
  {
    const dense::MatrixMemory memory = dense::matrix_memory(count);
    first = memory.get();
    first[count - 1] = 1.0;
  }
  EXPECT_EQ(dense::matrix_memory(count + count / 10).get(), first);
  EXPECT_NE(dense::matrix_memory(4 * count).get(), nullptr);  // another, and then the one that is kept
  const dense::MatrixMemory large = dense::matrix_memory(4 * count), other = dense::matrix_memory(4 * count);
  EXPECT_NE(large.get(), other.get());
  std::fill_n(large.get(), 4 * count, 1.0);
  std::fill_n(other.get(), 4 * count, 2.0);
  EXPECT_EQ(std::count(large.get(), large.get() + 4 * count, 1.0), 4 * count);
  EXPECT_NE(dense::matrix_memory(0).get(), nullptr);
}

TEST(InverseNorm, NeverAboveAndRarelyFarBelowTheTruth) {
  Random random(6);
  int exact = 0;
  const int trials = 200;
  for (int trial = 0; trial < trials; ++trial) {
    const Index n = 1 + random.index(30);
    const Eigen::MatrixXd root = random_matrix(n, n, random);
    const Eigen::MatrixXd inverse =
        inverse_by_lu(root * root.transpose() + 1e-6 * Eigen::MatrixXd::Identity(n, n));
    InverseNorm estimate(n);
    int solves = 0;
    while (estimate.wants_solve()) {
      estimate.take(inverse * estimate.next());
      ++solves;
    }
    EXPECT_LE(solves, 3);
    const double truth = inverse.cwiseAbs().colwise().sum().maxCoeff();
    EXPECT_LE(estimate.value(), truth * (1 + 1e-12));
    EXPECT_GE(estimate.value(), truth / 3);
    exact += estimate.value() > truth * (1 - 1e-9);
  }
  EXPECT_GT(exact, trials / 2);
}

TEST(InverseNorm, NothingToEstimate) { EXPECT_FALSE(InverseNorm(0).wants_solve()); }

}  // namespace
}  // namespace seesaw
