// The derivative of an interpolating surface by its constraints, against fitting again.
#include "core/rbf/parametric_interpolant.h"

#include <gtest/gtest.h>

#include "tests/support/differences.h"
#include "tests/support/parametric.h"
#include "tests/support/shapes.h"

namespace seesaw {
namespace {

template <int Dim>
Box<Dim> cube() {
  return {Point<Dim>::Constant(-1), Point<Dim>::Constant(1)};
}

template <int Dim>
void expect_f_q_matches(Kernel kernel, double smoothing) {
  Random random(1);
  ParametricInterpolant<Dim> f(random_constraints<Dim>(9, random),
                               {.kernel = kernel, .smoothing = smoothing});
  ASSERT_EQ(f.parameters(), 9 * (Dim + 1) + 3);
  // Normals stand 0.02 inside, so f_q goes up to some hundreds, and in relation to it the differences' own
  // error is (step / 0.02)^2; a fit is good to some 1e-11 (fit_test.cpp), which step divides.
  expect_q_gradients_match_differences<Dim>(f, random.points_in<Dim>(cube<Dim>(), 8), 1e-5, 1e-6);
}

TEST(ParametricInterpolant, GradientsMatchRefitting) {
  for (const Kernel kernel : all_kernels)
    for (const double smoothing : {0.0, 0.05}) {
      SCOPED_TRACE(std::string(name_of(kernel)) + (smoothing > 0 ? " smoothed" : ""));
      expect_f_q_matches<2>(kernel, smoothing);
      expect_f_q_matches<3>(kernel, smoothing);
    }
}

// Moving all constraints moves the surface: sum_i df/dc_i = -grad f. Cardinal functions reproduce f itself,
// and what the polynomial reproduces: constants.
TEST(ParametricInterpolant, WhatMustHoldOfAllTogether) {
  Random random(2);
  for (const Kernel kernel : all_kernels) {
    ParametricInterpolant<3> f(random_constraints<3>(30, random), {.kernel = kernel});
    const Points<3> x = random.points_in<3>(cube<3>(), 10);
    const Eigen::MatrixXd all = f.q_gradients(x);
    const Values q = f.q();
    for (Index k = 0; k < x.cols(); ++k) {
      Point<3> moved = f.gradient(x.col(k));
      double value = -f.value(x.col(k)), one = -1;
      for (Index i = 0; i < 30; ++i) {
        moved += all.col(k).segment<3>(f.position_parameter(i));
        one += all(f.value_parameter(i), k);
        value += all(f.value_parameter(i), k) * q[f.value_parameter(i)];
        if (const auto normal = f.normal_value_parameter(i)) {
          one += all(*normal, k);
          value += all(*normal, k) * q[*normal];
        }
      }
      const double rounding = 1e-10 * std::max(1.0, all.col(k).cwiseAbs().maxCoeff());
      EXPECT_LT(moved.norm(), rounding);
      EXPECT_LT(std::abs(value), rounding);
      EXPECT_LT(std::abs(one), rounding);
    }
  }
}

// f stays h_i at c_i whatever moves; only its own position and value count there.
TEST(ParametricInterpolant, AtACenterOnlyItsOwnConstraintCounts) {
  Random random(3);
  ParametricInterpolant<3> f(random_constraints<3>(20, random));
  for (const Index i : {0, 1, 2, 19}) {
    const Point<3> at = f.constraints()[static_cast<std::size_t>(i)].at;
    Values expected = Values::Zero(f.parameters());
    expected.segment<3>(f.position_parameter(i)) = -f.gradient(at);
    expected[f.value_parameter(i)] = 1;
    EXPECT_LT((f.q_gradients(at) - expected).cwiseAbs().maxCoeff(), 1e-9 * (1 + f.gradient(at).norm()));
  }
}

TEST(ParametricInterpolant, DoesNotDependOnWhereTheOriginIs) {
  Random random(4);
  Constraints<2> shape = random_constraints<2>(12, random);
  const ParametricInterpolant<2> here(shape);
  const Point<2> shift(1 << 22, -(1 << 21)), x(0.25, -0.375);
  for (auto& each : shape) each.at += shift;
  const ParametricInterpolant<2> there(shape);
  const Eigen::MatrixXd expected = here.q_gradients(x);
  // Coordinates near 4e6 have 1e-9 of a unit, and normals stand 0.02 inside.
  EXPECT_LT((there.q_gradients(x + shift) - expected).cwiseAbs().maxCoeff(),
            1e-6 * expected.cwiseAbs().maxCoeff());
}

TEST(ParametricInterpolant, FrozenParametersDoNotMove) {
  Random random(5);
  ParametricInterpolant<3> f(random_constraints<3>(9, random));
  expect_freezing_works<3>(f, random);
  f.freeze_values();
  EXPECT_EQ(f.parameters(), 3 * 9);
  f.freeze_positions();
  EXPECT_EQ(f.parameters(), 0);
  f.freeze_values(false);
  EXPECT_EQ(f.parameters(), 9 + 3);
  EXPECT_EQ(f.names()[static_cast<std::size_t>(*f.normal_value_parameter(0))], "c0.normal_value");
}

// Two constraints meet with different values: refused in words, and the last good surface stays.
TEST(ParametricInterpolant, KeepsTheLastGoodSurface) {
  ParametricInterpolant<2> f(four_around_one());
  const Values before = f.q();
  const Point<2> x(0.3, 0.4);
  const double value = f.value(x);
  Values q = before;
  q.segment<2>(f.position_parameter(0)) = q.segment<2>(f.position_parameter(4));
  try {
    f.set_q(q);
    FAIL() << "accepted";
  } catch (const ConstraintError& error) {
    EXPECT_EQ(error.reason(), ConstraintError::Reason::contradictory);
    EXPECT_EQ(error.culprits(), (std::vector<Index>{0, 4}));
  }
  EXPECT_EQ(f.q(), before);
  EXPECT_EQ(f.value(x), value);
  expect_q_gradients_match_differences<2>(f, Points<2>(x), 1e-6, 1e-7);
}

// All on one plane: f is level across it, and derivatives along it are what they are.
TEST(ParametricInterpolant, OnAPlaneMovesAlongIt) {
  Random random(6);
  Constraints<3> flat;
  for (int i = 0; i < 8; ++i) {
    const Point<2> at = random.points_in<2>(cube<2>(), 1).col(0);
    flat.push_back(i % 2 ? interior<3>({at.x(), at.y(), 2}) : boundary<3>({at.x(), at.y(), 2}));
  }
  ParametricInterpolant<3> f(flat);
  ASSERT_TRUE(f.report().degenerate);
  const Points<3> x = random.points_in<3>(Box<3>(Point<3>(-1, -1, 1), Point<3>(1, 1, 3)), 5);
  const Eigen::MatrixXd all = f.q_gradients(x);
  const Values everywhere = Values::LinSpaced(f.parameters(), -1, 2);  // across the plane, too
  EXPECT_LT((f.rates(x, everywhere) - all.transpose() * everywhere).cwiseAbs().maxCoeff(), 1e-9);
  for (Index i = 0; i < 8; ++i) {
    EXPECT_LT(all.row(f.position_parameter(i) + 2).cwiseAbs().maxCoeff(), 1e-9);
    f.freeze(f.position_parameter(i) + 2);
  }
  expect_q_gradients_match_differences<3>(f, x, 1e-6, 1e-6);
}

TEST(ParametricInterpolant, FewOrTwiceTheSameConstraints) {
  ParametricInterpolant<2> one({interior<2>({1, 2}, 3)});
  EXPECT_EQ(one.q_gradients(Point<2>(5, 5)), (Values{{0, 0, 1}}));

  Constraints<2> twice = four_around_one();
  twice.push_back(twice[1]);
  ParametricInterpolant<2> f(twice), once(four_around_one());
  const Point<2> x(0.5, 0.6);
  const Eigen::MatrixXd all = f.q_gradients(x), expected = once.q_gradients(x);
  EXPECT_EQ(all.topRows(expected.rows()), expected);
  EXPECT_EQ(all.bottomRows(3), Values::Zero(3));
}

}  // namespace
}  // namespace seesaw
