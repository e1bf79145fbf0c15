// The parts that editing without refitting is made of: the solve with any bottom, small systems, matched
// rows.
#include "core/rbf/border.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "core/rbf/small_lu.h"
#include "tests/support/shapes.h"

namespace seesaw {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

double phi(Kernel kernel, double r) {
  if (r == 0.0) return 0.0;
  return kernel == Kernel::cubic ? r * r * r : kernel == Kernel::linear ? r : r * r * std::log(r);
}

// Eq. 8 as printed, with smoothing.
template <int Dim>
Eigen::MatrixXd matrix_of(const Points<Dim>& centers, Kernel kernel, double smoothing) {
  const Index n = centers.cols();
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(n + Dim + 1, n + Dim + 1);
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) k(i, j) = phi(kernel, (centers.col(i) - centers.col(j)).norm());
    k(i, i) += kernel == Kernel::linear ? -smoothing : smoothing;
    k(i, n) = k(n, i) = 1;
    for (int d = 0; d < Dim; ++d) k(i, n + 1 + d) = k(n + 1 + d, i) = centers(d, i);
  }
  return k;
}

TEST(SolveAll, MeetsEquation8WithAnyBottom) {
  for (const Kernel kernel : all_kernels)
    for (const double smoothing : {0.0, 0.05}) {
      Random random(1);
      const Points<3> centers = random.points_in<3>(Box<3>(Point<3>(-1, -1, -1), Point<3>(1, 0.5, 0.8)), 70);
      const Factorization<3> factorization(centers, kernel, smoothing);
      const Eigen::MatrixXd right =
          Eigen::MatrixXd::NullaryExpr(74, 5, [&] { return random.uniform(-1, 1); });
      const Eigen::MatrixXd x = factorization.solve_all(right);
      // Backward stable: what is left is rounding of the size of the sums.
      const double size = 4 * x.cwiseAbs().colwise().sum().maxCoeff();
      EXPECT_LE((matrix_of<3>(centers, kernel, smoothing) * x - right).cwiseAbs().maxCoeff(), 1e-15 * size);
    }
}

TEST(SolveAll, IsSolveWhereTheBottomIsZero) {
  Random random(2);
  const ScatteredData<2> data(100, random);
  Factorization<2> factorization(data.points, Kernel::thin_plate_spline, 0);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(103, 2);
  right.col(1).head(100) = data.values;
  const Eigen::MatrixXd all = factorization.solve_all(right);
  const Solution one = factorization.solve(data.values);
  EXPECT_EQ(all.col(0).cwiseAbs().maxCoeff(), 0.0);
  EXPECT_LE((all.col(1).head(100) - one.weights).norm(), 1e-12 * one.weights.norm());
  EXPECT_LE((all.col(1).tail(3) - one.polynomial).norm(), 1e-12 * one.polynomial.norm());
}

TEST(SmallLu, IndefiniteSystemsOfManySizes) {
  Random random(3);
  for (const Index n : {1, 2, 7, 40}) {
    Eigen::MatrixXd a = Eigen::MatrixXd::NullaryExpr(n, n, [&] { return random.uniform(-1, 1); });
    // Rows of very different sizes, and no pivot on the diagonal.
    for (Index i = 0; i < n; ++i) a.row(i) *= std::pow(10.0, random.uniform(-8, 8));
    if (n > 1) a.diagonal().setZero();
    const Values x = Values::NullaryExpr(n, [&] { return random.uniform(-1, 1); });
    const SmallLu lu(a);
    ASSERT_FALSE(lu.singular());
    EXPECT_LE((lu.solve(a * x) - x).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(SmallLu, TheNearlySingularPairOfAMoveByNothing) {
  // What a row dragged by almost nothing leaves: [e 1; 1 -k], e tiny and k huge. Its inverse is harmless.
  Eigen::MatrixXd a(2, 2);
  a << 1e-18, 1, 1, -1e6;
  const Values x = SmallLu(a).solve(Eigen::Vector2d(1, 0));
  EXPECT_NEAR(x[1], 1, 1e-12);
  EXPECT_NEAR(x[0], 1e6 / (1 + 1e-12), 1e-9);
}

TEST(SmallLu, SaysWhenNothingCanBeSolved) {
  Eigen::MatrixXd a(2, 2);
  a << 1, 2, 2, 4;
  EXPECT_TRUE(SmallLu(a).singular());
  EXPECT_TRUE(SmallLu(Eigen::MatrixXd::Zero(3, 3)).singular());
  EXPECT_TRUE(SmallLu(Eigen::MatrixXd::Constant(2, 2, std::nan(""))).singular());
}

TEST(RowFinder, InsertedErasedAndReordered) {
  Points<2> old(2, 5);
  old << 0, 1, 2, 3, 4, 0, 0, 0, 0, 0;
  const RowFinder<2> finder(old);
  EXPECT_EQ(finder.match(old).size(), 0);
  EXPECT_THAT(finder.match(old).old_row, ElementsAre(0, 1, 2, 3, 4));

  Points<2> changed(2, 5);  // 1 erased, 9 inserted, 4 moved to the front
  changed << 4, 0, 9, 2, 3, -0.0, 0, 0, 0, 0;
  const RowMatch match = finder.match(changed);
  EXPECT_THAT(match.old_row, ElementsAre(4, 0, -1, 2, 3));
  EXPECT_THAT(match.removed, ElementsAre(1));
  EXPECT_THAT(match.added, ElementsAre(2));
}

TEST(RowFinder, RepeatedPositionsAreMatchedOneByOne) {
  Points<2> old(2, 4);
  old << 1, 1, 0, 1, 5, 5, 0, 5;
  const RowFinder<2> finder(old);
  Points<2> now(2, 5);
  now << 1, 1, 1, 1, 0, 5, 5, 5, 5, 0;
  const RowMatch match = finder.match(now);
  EXPECT_THAT(match.old_row, ElementsAre(0, 1, 3, -1, 2));
  EXPECT_THAT(match.removed, IsEmpty());
  EXPECT_THAT(match.added, ElementsAre(3));
}

// The bordered system against the system of the rows that it stands for.
TEST(Border, IsTheSystemOfTheRowsThatAreThere) {
  for (const Kernel kernel : all_kernels)
    for (const double smoothing : {0.0, 0.05}) {
      Random random(4);
      const auto base = std::make_shared<const FullFit<2>>(
          full_fit(random_constraints<2>(60, random), {.kernel = kernel, .smoothing = smoothing}));
      const Index n = base->rows.values.size();
      Border<2> border(base);
      const std::vector<Index> removed = {0, 7, 31};
      const Points<2> added = random.points_in<2>(Box<2>(Point<2>(-1, -1), Point<2>(1, 1)), 4);
      Values values = base->rows.values;
      values[3] += 1;
      EXPECT_EQ(border.unknown(removed, added), 7);
      EXPECT_EQ(border.set(removed, added, values), 8);
      EXPECT_EQ(border.unknown(removed, added), 0);
      EXPECT_EQ(border.set(removed, added, values), 0);
      const Values added_values = Values::LinSpaced(4, -1, 1);
      const auto solved = border.solution(added_values);
      ASSERT_TRUE(solved);

      Points<2> centers(2, n + 1);
      Values expected(n + 1 + 3), weights(n + 1 + 3);
      Index count = 0;
      for (Index i = 0; i < n; ++i) {
        if (std::binary_search(removed.begin(), removed.end(), i)) {
          EXPECT_EQ(solved->old_weights[i], 0.0);
          continue;
        }
        centers.col(count) = base->fit.function.normalized_centers().col(i);
        expected[count] = values[i];
        weights[count++] = solved->old_weights[i];
      }
      centers.rightCols(4) = added;
      expected.tail(7) << added_values, 0, 0, 0;
      weights.tail(7) << solved->added_weights, solved->polynomial;
      const Values missed = matrix_of<2>(centers, kernel, base->smoothing) * weights - expected;
      // Unrefined: rounding of the sums, times what the columns of the border lose.
      EXPECT_LE(missed.cwiseAbs().maxCoeff(), 1e-14 * weights.cwiseAbs().sum()) << name_of(kernel);

      const auto other = border.solution_of(values, added_values);
      ASSERT_TRUE(other);
      EXPECT_LE((other->added_weights - solved->added_weights).norm(), 1e-9 * solved->added_weights.norm());
    }
}

}  // namespace
}  // namespace seesaw
