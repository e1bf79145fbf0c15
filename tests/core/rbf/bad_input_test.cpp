// What people do to a solver: nothing, too little, the same twice, the impossible, the huge and the tiny.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "core/rbf/fit.h"
#include "tests/support/shapes.h"

namespace seesaw {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Reason = ConstraintError::Reason;

ConstraintError error_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const ConstraintError& error) {
    return error;
  }
  ADD_FAILURE() << "was not refused";
  return {Reason::none_given, "", {}};
}

TEST(BadInput, EmptySetIsRefused) {
  const auto error = error_of([] { fit(Constraints<2>{}); });
  EXPECT_EQ(error.reason(), Reason::none_given);
  EXPECT_TRUE(error.culprits().empty());
}

TEST(BadInput, OneConstraintGivesAConstant) {
  const auto fitted = fit(Constraints<2>{interior<2>({5, 7})});
  EXPECT_TRUE(fitted.report.degenerate);
  EXPECT_EQ(fitted.report.polynomial_rank, 1);
  EXPECT_EQ(fitted.function.value({5, 7}), 1.0);
  EXPECT_EQ(fitted.function.value({-100, 3}), 1.0);
  EXPECT_EQ(fitted.function.gradient({1, 2}).norm(), 0.0);
}

TEST(BadInput, TwoConstraintsGiveALinearFunctionAlongThem) {
  const auto fitted = fit(Constraints<2>{boundary<2>({1, 1}), interior<2>({3, 2})});
  EXPECT_TRUE(fitted.report.degenerate);
  EXPECT_EQ(fitted.report.polynomial_rank, 2);
  const Point<2> along(2, 1), across(-1, 2);
  EXPECT_NEAR(fitted.function.value({1, 1}), 0, 1e-15);
  EXPECT_NEAR(fitted.function.value({3, 2}), 1, 1e-15);
  EXPECT_LE((fitted.function.gradient({0, 0}) - along / 5).norm(), 1e-14);
  EXPECT_NEAR(fitted.function.value(Point<2>(1, 1) + 10 * across), 0, 1e-13);
}

TEST(BadInput, CollinearConstraintsAreConstantAcrossTheirLine) {
  for (const Kernel kernel : all_kernels) {
    Constraints<2> constraints;
    const Point<2> from(0.3, -0.7), along(0.6, 0.8), across(-0.8, 0.6);
    const double values[] = {-1, 0, 1, 0.5, -2};
    for (int i = 0; i < 5; ++i)
      constraints.push_back({ConstraintKind::interior, from + i * along, values[i], {}});
    const auto fitted = fit(constraints, {.kernel = kernel});
    EXPECT_TRUE(fitted.report.degenerate);
    EXPECT_EQ(fitted.report.polynomial_rank, 2);
    EXPECT_LT(fitted.report.max_residual, 1e-13);
    // Symmetric about the line: the least-norm polynomial does not lean across it.
    for (double t = 0.15; t < 4; t += 0.3) {  // never a center, where the gradient of r does not exist
      const Point<2> on = from + t * along;
      EXPECT_NEAR(fitted.function.value(on + 0.7 * across), fitted.function.value(on - 0.7 * across), 1e-12);
      EXPECT_NEAR(fitted.function.gradient(on).dot(across), 0, 1e-10);
    }
  }
}

TEST(BadInput, CoplanarConstraintsIn3D) {
  Random random(1);
  Constraints<3> constraints;
  for (int i = 0; i < 20; ++i) {
    const Point<2> p = random.points_in<2>(Box<2>(Point<2>(-1, -1), Point<2>(1, 1)), 1).col(0);
    constraints.push_back(
        {ConstraintKind::interior, {p[0], p[1], 2 * p[0] - p[1] + 3}, random.uniform(-1, 1), {}});
  }
  const auto fitted = fit(constraints);
  EXPECT_EQ(fitted.report.polynomial_rank, 3);
  EXPECT_LT(fitted.report.max_residual, rounding_of(fitted.function));
  const Point<3> across = Point<3>(2, -1, -1).normalized();
  EXPECT_NEAR(fitted.function.gradient({0.1, 0.2, 3.0}).dot(across), 0, 1e-10);
}

TEST(BadInput, CoincidentEqualConstraintsAreMerged) {
  auto constraints = four_around_one();
  const auto once = fit(constraints);
  constraints.push_back(constraints[1]);
  constraints.push_back(constraints[4]);
  constraints.push_back(constraints[1]);
  const auto fitted = fit(constraints);
  EXPECT_EQ(fitted.report.merged, 3);
  EXPECT_EQ(fitted.report.rows, 5);
  EXPECT_EQ(fitted.report.boundary, 6);
  EXPECT_EQ(fitted.function.value({0.3, 0.4}), once.function.value({0.3, 0.4}));
}

TEST(BadInput, SameBoundaryPointWithTwoNormalsKeepsBoth) {
  auto constraints = four_around_one();
  constraints.push_back(boundary<2>({2, 2}, {1, 0}));
  constraints.push_back(boundary<2>({2, 2}, {0, 1}));
  const auto fitted = fit(constraints);
  EXPECT_EQ(fitted.report.merged, 1);
  EXPECT_NEAR(fitted.function.value({1.99, 2}), 1, 1e-11);
  EXPECT_NEAR(fitted.function.value({2, 1.99}), 1, 1e-11);
}

TEST(BadInput, ContradictionsNameTheirCulprits) {
  auto constraints = four_around_one();
  constraints.push_back(interior<2>(constraints[2].at));
  constraints.push_back(exterior<2>(constraints[0].at, -3));
  const auto error = error_of([&] { fit(constraints); });
  EXPECT_EQ(error.reason(), Reason::contradictory);
  EXPECT_THAT(error.culprits(), ElementsAre(0, 2, 5, 6));
  EXPECT_THAT(error.what(), HasSubstr("0, 2, 5, 6"));
}

TEST(BadInput, WithSmoothingContradictionsAreMeasurements) {
  auto constraints = four_around_one();
  constraints.push_back(interior<2>(constraints[2].at));
  const auto fitted = fit(constraints, {.smoothing = 0.1});
  EXPECT_EQ(fitted.report.rows, 6);
  EXPECT_GT(fitted.function.value(constraints[2].at), 0);
  EXPECT_LT(fitted.function.value(constraints[2].at), 1);
}

TEST(BadInput, NotFiniteNumbersNameTheirCulprits) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = infinity;
  for (const double bad : {nan, inf, -inf}) {
    auto constraints = four_around_one();
    constraints[3].at[1] = bad;
    constraints[4].value = bad;
    const auto error = error_of([&] { fit(constraints); });
    EXPECT_EQ(error.reason(), Reason::not_finite);
    EXPECT_THAT(error.culprits(), ElementsAre(3, 4));
    auto normal = four_around_one();
    normal[1].normal = NormalConstraint<2>{{bad, 0}, 0.01, 1};
    EXPECT_THAT(error_of([&] { fit(normal); }).culprits(), ElementsAre(1));
  }
}

TEST(BadInput, NormalOfLengthZeroIsRefused) {
  auto constraints = four_around_one();
  constraints[2].normal = NormalConstraint<2>{{0, 0}, 0.01, 1};
  const auto error = error_of([&] { fit(constraints); });
  EXPECT_EQ(error.reason(), Reason::no_direction);
  EXPECT_THAT(error.culprits(), ElementsAre(2));
}

TEST(BadInput, CentersTooCloseNameThePair) {
  // Twice the distance that counts as coincident, asking for different values: solvable on paper only.
  for (const Kernel kernel : {Kernel::thin_plate_spline, Kernel::cubic}) {
    auto constraints = four_around_one();
    constraints.push_back(boundary<2>({0.5, 0.5}));
    constraints.push_back(interior<2>({0.5 + 4e-12, 0.5}));
    const auto error = error_of([&] { fit(constraints, {.kernel = kernel}); });
    EXPECT_EQ(error.reason(), Reason::too_close);
    EXPECT_THAT(error.culprits(), ElementsAre(5, 6));
  }
}

TEST(BadInput, OneThatIsFarAwayIsTheCulpritAndNotAllOthers) {
  for (const double far : {1e13, 1e20, 1e90})
    for (const bool normal : {false, true}) {
      auto constraints = four_around_one();
      constraints.insert(constraints.begin() + 2,
                         normal ? boundary<2>({far, 0}, {1, 0}, 1e-3 * far) : boundary<2>({far, 0}));
      const auto error = error_of([&] { fit(constraints); });
      EXPECT_EQ(error.reason(), Reason::too_close);
      EXPECT_THAT(error.culprits(), ElementsAre(2)) << far;
      EXPECT_THAT(error.what(), HasSubstr("away from all others, which lie within 2"));
    }
  // Not where two really contradict each other.
  auto constraints = four_around_one();
  constraints.push_back(interior<2>(constraints[0].at));
  constraints.push_back(boundary<2>({1e6, 0}));
  const auto error = error_of([&] { fit(constraints); });
  EXPECT_EQ(error.reason(), Reason::contradictory);
  EXPECT_THAT(error.culprits(), ElementsAre(0, 5));
}

TEST(BadInput, FarFromTheOriginAndVerySmall) {
  Random random(2);
  const auto constraints = random_constraints<2>(30, random);
  const auto here = fit(constraints).function;
  const Points<2> x = random.points_in<2>(here.bounding_box(), 200);
  const Values expected = here.values(x);
  struct Case {
    double scale;
    Point<2> shift;
    double tolerance;
  };
  // Moved by 1e7 the coordinates keep 1e-9 of a unit, which the steep normals (slope 50 and more) magnify.
  for (const Case& c : {Case{1, {1e7, -1e7}, 1e-5}, Case{1, {4.5e6, 4.5e6}, 1e-5}, Case{1e-9, {0, 0}, 1e-9},
                        Case{1e9, {0, 0}, 1e-9}, Case{1e-9, {1e-2, 0}, 1e-5}, Case{1e90, {0, 0}, 1e-9},
                        Case{1e-90, {0, 0}, 1e-9}}) {
    auto moved = constraints;
    for (auto& constraint : moved) {
      constraint.at = c.scale * constraint.at + c.shift;
      if (constraint.normal) constraint.normal->offset *= c.scale;
    }
    const auto there = fit(moved);
    EXPECT_LT(there.report.max_residual, 1e-10);
    const Values values = there.function.values((c.scale * x).colwise() + c.shift);
    EXPECT_LE((values - expected).cwiseAbs().maxCoeff(), c.tolerance * expected.cwiseAbs().maxCoeff())
        << c.scale;
  }
}

TEST(BadInput, AValueThatDoublesCannotSumIsRefusedForWhatItIs) {
  for (const double value : {1e101, -1e308}) {
    auto constraints = four_around_one();
    constraints[2].value = value;
    constraints[2].kind = value > 0 ? ConstraintKind::interior : ConstraintKind::exterior;
    const auto error = error_of([&] { fit(constraints); });
    EXPECT_EQ(error.reason(), Reason::out_of_range);
    EXPECT_EQ(error.culprits(), std::vector<Index>{2});
    EXPECT_THAT(error.what(), testing::StartsWith("constraint 2: a value is beyond 1e100"));
  }
}

TEST(BadInput, SizesThatDoublesCannotCubeAreRefused) {
  for (const double scale : {1e-300, 1e-120, 1e120, 8e307}) {
    for (const double smoothing : {0.0, 0.1}) {
      auto constraints = four_around_one();
      for (auto& constraint : constraints) constraint.at *= scale;
      const auto error = error_of([&] { fit(constraints, {.smoothing = smoothing}); });
      EXPECT_EQ(error.reason(), Reason::out_of_range);
      EXPECT_FALSE(error.culprits().empty());
      EXPECT_THAT(error.what(), HasSubstr("unit of length"));
    }
  }
}

TEST(BadInput, AnisotropyOfAMillion) {
  Random random(3);
  for (const Kernel kernel : all_kernels) {
    ScatteredData<2> data(50, random);
    data.points.row(1) *= 1e-6;
    const auto fitted = fit_values<2>(data.points, data.values, {.kernel = kernel});
    EXPECT_FALSE(fitted.report.degenerate);
    EXPECT_LT(fitted.report.max_residual, 1e-6);
  }
}

TEST(BadInput, EvaluationFarAwayStaysTheFormula) {
  const auto f = fit(four_around_one()).function;
  const Values p = f.polynomial();
  for (const double far : {1e3, 1e6, 1e9, 1e16, 1e30}) EXPECT_TRUE(std::isfinite(f.value({far, 0.5 * far})));
  // The linear term wins over the logarithm, until rounding (1e-16 of r^2 log r) wins over both.
  for (const double far : {1e6, 1e7, 1e8})
    EXPECT_NEAR(f.value({far, 0.5 * far}) / (p[1] + 0.5 * p[2]) / far, 1, 1e-3);
  // A far point among near ones does not disturb them.
  Points<2> x(2, 3);
  x << 0.1, 1e20, 0.2, 0.3, 1e20, -0.4;
  const Values values = f.values(x);
  EXPECT_EQ(values[0], f.value({0.1, 0.3}));
  EXPECT_EQ(values[2], f.value({0.2, -0.4}));
}

}  // namespace
}  // namespace seesaw
