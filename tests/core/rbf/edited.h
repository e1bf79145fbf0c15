// Constraints that are edited at random, and what an edited function owes to a fitted one.
#pragma once

#include <gtest/gtest.h>

#include <functional>

#include "core/rbf/edit_session.h"
#include "tests/support/shapes.h"

namespace seesaw {

using Full = EditReport::Full;

// Bordered whenever it is possible at all, so that few constraints do for a test.
inline const EditOptions eager = {.smallest = 20};

inline constexpr double as_good_as_fit = 1e-8;  // of the values: what an edit may differ from a fit by

template <int Dim>
Box<Dim> arena() {
  return {Point<Dim>::Constant(-1.2), Point<Dim>::Constant(1.2)};
}

/// The largest difference at 60 points, relative to the largest value.
template <int Dim>
double difference(const Interpolant<Dim>& f, const Interpolant<Dim>& g) {
  Random random(77);
  const Points<Dim> x = random.points_in<Dim>(arena<Dim>(), 60);
  const Values expected = g.values(x);
  return (f.values(x) - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
}

template <int Dim>
void expect_as_fitted(const Fit<Dim>& edited, const Fit<Dim>& fitted) {
  EXPECT_LE(difference(edited.function, fitted.function), as_good_as_fit);
  EXPECT_EQ(edited.function.centers(), fitted.function.centers());
  const FitReport &a = edited.report, &b = fitted.report;
  EXPECT_EQ(a.kernel, b.kernel);
  EXPECT_EQ(a.smoothing, b.smoothing);
  EXPECT_EQ(a.boundary, b.boundary);
  EXPECT_EQ(a.interior, b.interior);
  EXPECT_EQ(a.exterior, b.exterior);
  EXPECT_EQ(a.normal, b.normal);
  EXPECT_EQ(a.rows, b.rows);
  EXPECT_EQ(a.merged, b.merged);
  EXPECT_EQ(a.polynomial_rank, b.polynomial_rank);
  EXPECT_EQ(a.degenerate, b.degenerate);
  EXPECT_NEAR(a.energy, b.energy, 1e-7 * b.energy);
  EXPECT_NEAR(a.max_residual, b.max_residual, 1e-7 * std::max(1.0, b.max_residual));
}

inline std::optional<ConstraintError> refusal_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const ConstraintError& error) {
    return error;
  }
  return std::nullopt;
}

template <int Dim>
Point<Dim> anywhere(Random& random) {
  return random.points_in<Dim>(Box<Dim>(Point<Dim>::Constant(-1), Point<Dim>::Constant(1)), 1).col(0);
}

/// One thing that a user may do.
template <int Dim>
void edit_at_random(Constraints<Dim>& constraints, Random& random) {
  const Index i = random.index(static_cast<Index>(constraints.size()));
  Constraint<Dim>& one = constraints[slot(i)];
  switch (random.index(6)) {
    case 0: {
      const Constraints<Dim> three = random_constraints<Dim>(3, random);
      constraints.insert(constraints.begin() + i, three[slot(random.index(3))]);
      break;
    }
    case 1:
      if (constraints.size() > 50) constraints.erase(constraints.begin() + i);
      break;
    case 2:
      one.at = anywhere<Dim>(random);
      break;
    case 3:  // a drag's step
      one.at += 0.01 * random.direction<Dim>();
      break;
    case 4:
      if (one.kind == ConstraintKind::boundary)
        one.normal = NormalConstraint<Dim>{random.direction<Dim>(), 0.02, random.uniform(0.5, 2)};
      else
        one.value *= random.uniform(0.5, 2);
      break;
    case 5:
      one.normal.reset();
      break;
  }
}

// A ring of 60 boundary constraints, every other one with its normal, and something inside.
inline Constraints<2> ring() {
  Constraints<2> constraints;
  for (int i = 0; i < 60; ++i) {
    const Point<2> out(std::cos(i * M_PI / 30), std::sin(i * M_PI / 30));
    constraints.push_back(i % 2 ? boundary<2>(out, out) : boundary<2>(out));
  }
  constraints.push_back(interior<2>({0.1, 0.2}));
  return constraints;
}

}  // namespace seesaw
