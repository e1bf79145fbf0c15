// Where editing without refitting ends: what is refused, and what only a full fit can tell.
#include "core/rbf/edit_session.h"

#include <gmock/gmock.h>

#include <limits>

#include "tests/core/rbf/edited.h"

namespace seesaw {
namespace {

using Reason = ConstraintError::Reason;

TEST(EditSession, RefusesWhatFitRefusesAndStaysUsable) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Constraints<2> good = ring();
  std::vector<Constraints<2>> bad(8, good);
  bad[0].clear();
  bad[1][5].at.x() = nan;
  bad[2][5].value = infinity;
  bad[3][7].normal->direction = {0, 0};
  bad[4][3].at = bad[4][60].at;  // 0 and 1 at one place
  bad[5].push_back(exterior<2>(bad[5][8].at));
  bad[6][9].at = {1e120, 0};
  bad[7][2].at = bad[7][60].at + Point<2>(4e-12, 0);  // too close to be told apart
  const Reason reasons[] = {Reason::none_given,   Reason::not_finite,    Reason::not_finite,
                            Reason::no_direction, Reason::contradictory, Reason::contradictory,
                            Reason::out_of_range, Reason::too_close};

  EditSession<2> session(good);
  Constraints<2> moved = good;
  for (std::size_t k = 0; k < bad.size(); ++k) {
    moved[4].at += Point<2>(0.003, 0);
    session.update(moved);
    const Values before = session.fit().function.normalized_weights();
    const auto by_fit = refusal_of([&] { fit(bad[k]); });
    const auto by_session = refusal_of([&] { session.update(bad[k]); });
    ASSERT_TRUE(by_fit && by_session) << k;
    EXPECT_EQ(by_session->reason(), reasons[k]);
    EXPECT_EQ(by_session->reason(), by_fit->reason());
    EXPECT_EQ(by_session->culprits(), by_fit->culprits());
    EXPECT_STREQ(by_session->what(), by_fit->what());
    // What it was is what it is.
    EXPECT_EQ(session.fit().function.normalized_weights(), before);
    EXPECT_EQ(session.constraints()[4].at, moved[4].at);
    session.update(moved);
    EXPECT_EQ(session.last().full, Full::no);
    EXPECT_EQ(session.last().solves, 0);
  }
  expect_as_fitted(session.fit(), fit(moved));
  EXPECT_TRUE(refusal_of([&] { EditSession<2>{bad[0]}; }));
}

TEST(EditSession, DraggedOntoAnotherAndBeyond) {
  // Nearer and nearer to a constraint of the same value, onto it (where the two merge), and away again.
  Constraints<2> shape = ring();
  const Point<2> target = shape[10].at;
  EditSession<2> session(shape);
  for (const double distance : {0.1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 0.0, 1e-7, 1e-5, 1e-4, 1e-3, 0.1}) {
    shape[4].at = target + Point<2>(0.6 * distance, 0.8 * distance);
    const auto by_fit = refusal_of([&] { fit(shape); });
    const auto by_session = refusal_of([&] { session.update(shape); });
    ASSERT_EQ(by_fit.has_value(), by_session.has_value()) << distance;
    if (by_fit)
      EXPECT_EQ(by_fit->culprits(), by_session->culprits());
    else
      expect_as_fitted(session.fit(), fit(shape));
    if (distance == 0.0) {
      EXPECT_EQ(session.fit().report.merged, 1);
    }
  }
}

TEST(EditSession, MovedByNextToNothing) {
  // The row taken out and the row put in are then nearly one.
  Constraints<2> shape = ring();
  EditSession<2> session(shape);
  for (const double step : {1e-15, 1e-13, 1e-11, 1e-9, 1e-7, 1e-5, 1e-3}) {
    Constraints<2> moved = shape;
    moved[4].at += Point<2>(step, step);
    moved[7].at -= Point<2>(step, step);
    expect_as_fitted(session.update(moved), fit(moved));
    EXPECT_EQ(session.last().full, Full::no);
  }
}

TEST(EditSession, FromOneToManyAndBack) {
  Random random(5);
  const auto all = random_constraints<3>(80, random);
  EditSession<3> session({all.begin(), all.begin() + 1});
  const auto check = [&](std::ptrdiff_t count) {
    const Constraints<3> some(all.begin(), all.begin() + count);
    const auto& edited = session.update(some);
    if (edited.report.rows < EditOptions{}.smallest) {
      EXPECT_EQ(session.last().full, Full::few_rows) << count;
    }
    if (count < 8 || count % 7 == 0) expect_as_fitted(edited, fit(some));
    return session.last().full == Full::no;
  };
  int bordered = 0;
  for (std::ptrdiff_t count = 1; count <= 80; ++count) bordered += check(count);
  for (std::ptrdiff_t count = 79; count >= 1; --count) bordered += check(count);
  EXPECT_GE(bordered, 60);  // of the 70 with enough rows
}

TEST(EditSession, OnOneLineItIsAFit) {
  Random random(6);
  Constraints<2> constraints;
  for (int i = 0; i < 70; ++i) constraints.push_back(interior<2>({0.02 * i, 0.01 * i}, random.uniform(1, 2)));
  constraints.push_back(boundary<2>({0.5, 0.7}));
  EditSession<2> session(constraints);
  const Constraints<2> line(constraints.begin(), constraints.end() - 1);
  expect_as_fitted(session.update(line), fit(line));
  EXPECT_EQ(session.last().full, Full::flat);
  EXPECT_TRUE(session.fit().report.degenerate);
  expect_as_fitted(session.update(constraints), fit(constraints));
  EXPECT_EQ(session.last().full, Full::flat);
  constraints.back().at.x() += 0.1;
  session.update(constraints);
  EXPECT_EQ(session.last().full, Full::no);
}

TEST(EditSession, FarAwayIsAnotherExtent) {
  Constraints<2> shape = ring();
  EditSession<2> session(shape);
  shape[60].at = {3, 0};  // within reach of the coordinates of the start
  expect_as_fitted(session.update(shape), fit(shape));
  EXPECT_EQ(session.last().full, Full::no);
  shape[60].at = {30, 0};
  session.update(shape);
  EXPECT_EQ(session.last().full, Full::out_of_reach);
  shape[60].at = {31, 0};
  session.update(shape);
  EXPECT_EQ(session.last().full, Full::no);
  shape[60].at = {0, 0};
  expect_as_fitted(session.update(shape), fit(shape));
  EXPECT_EQ(session.last().full, Full::out_of_reach);
}

TEST(EditSession, OtherOptionsAndManyChangesAreFits) {
  Constraints<2> shape = ring();
  EditSession<2> session(shape);
  const FitOptions cubic{.kernel = Kernel::cubic}, smooth{.kernel = Kernel::cubic, .smoothing = 0.1};
  expect_as_fitted(session.update(shape, cubic), fit(shape, cubic));
  EXPECT_EQ(session.last().full, Full::options);
  expect_as_fitted(session.update(shape, smooth), fit(shape, smooth));
  EXPECT_EQ(session.last().full, Full::options);
  for (Constraint<2>& each : shape) each.at *= 1.01;
  expect_as_fitted(session.update(shape), fit(shape, smooth));
  EXPECT_EQ(session.last().full, Full::many_changes);
  // The papers' kernel by name is the papers' kernel.
  session.update(shape, {});
  shape[0].at *= 1.01;
  session.update(shape, {.kernel = Kernel::thin_plate_spline, .condition = false});
  EXPECT_EQ(session.last().full, Full::no);
  EXPECT_EQ(session.fit().report.reciprocal_condition, 1.0);
  session.update(shape, {});
  EXPECT_LT(session.fit().report.reciprocal_condition, 1.0);
}

TEST(EditSession, InaccurateIsRefinedOrFittedAgain) {
  Random random(7);
  auto constraints = random_constraints<3>(90, random);
  EditSession<3> measured(constraints);
  auto moved = constraints;
  moved[3].at = anywhere<3>(random);
  moved[6].value *= 3;
  measured.update(moved);
  const double largest = fit(moved).function.values(measured.fit().function.centers()).cwiseAbs().maxCoeff();
  const double residual = measured.last().residual / largest;
  ASSERT_GT(residual, 1e-14);

  EditSession<3> refining(constraints, {}, {.accuracy = 0.5 * residual, .rounding = 0});
  expect_as_fitted(refining.update(moved), fit(moved));
  EXPECT_EQ(refining.last().checked, refining.fit().report.rows);
  if (refining.last().full == Full::no) {
    EXPECT_TRUE(refining.last().refinements);
    EXPECT_LT(refining.last().residual, measured.last().residual);
  } else {  // on two lanes a refinement may have nothing left to refine: the residual is rounding
    EXPECT_EQ(refining.last().full, Full::inaccurate);
  }

  EditSession<3> refitting(constraints, {}, {.accuracy = 1e-18, .rounding = 0});
  expect_as_fitted(refitting.update(moved), fit(moved));
  EXPECT_EQ(refitting.last().full, Full::inaccurate);

  EditSession<3> as_good_as_can_be(constraints, {}, {.accuracy = 1e-18});
  expect_as_fitted(as_good_as_can_be.update(moved), fit(moved));
  EXPECT_EQ(as_good_as_can_be.last().full, Full::no);
}

TEST(EditSession, ABorderThatCostsTooMuchIsNotBegun) {
  Constraints<2> shape = ring();
  EditSession<2> session(shape);
  const double rows = static_cast<double>(session.fit().report.rows), solve = 2 * rows * rows;
  const FitOptions same;
  shape[4].at *= 0.99;  // one row goes, one comes
  try {
    session.update(shape, same, {.border = 1.9 * solve});
    ADD_FAILURE() << "two solves were made";
  } catch (const OverBudget& due) {
    EXPECT_EQ(due.reason(), Full::no);
    EXPECT_EQ(due.rows(), session.fit().report.rows);
  }
  expect_as_fitted(session.update(shape, same, {.border = 2 * solve}), fit(shape));
  shape[4].at *= 0.99;
  expect_as_fitted(session.update(shape, same, {.border = solve}), fit(shape));
  shape[20].value += 0.1;
  EXPECT_THROW(session.update(shape, same, {.border = 0}), OverBudget);
  expect_as_fitted(session.update(shape, same, {.border = solve}), fit(shape));
  expect_as_fitted(session.update(shape, same, {.border = 0}), fit(shape));
}

TEST(EditSession, StoppedItIsWhatItWas) {
  Constraints<2> shape = ring();
  EditSession<2> session(shape);
  const Values before = session.fit().function.normalized_weights();
  const FitOptions same, cubic{.kernel = Kernel::cubic};
  const Progress stop = [](double fraction) { return fraction < 0.6; };
  const auto other = shape;
  for (const auto& options : {same, cubic}) {
    for (std::size_t i = 0; i < 5; ++i) shape[i].at *= 1.01;
    EXPECT_THROW(session.update(shape, options, {}, stop), Cancelled);
    EXPECT_EQ(session.fit().function.normalized_weights(), before);
    EXPECT_EQ(session.options().kernel, std::nullopt);
  }
  EXPECT_THROW(EditSession<2>(shape, same, {}, stop), Cancelled);
  expect_as_fitted(session.update(other), fit(other));
  expect_as_fitted(session.update(shape), fit(shape));
}

TEST(EditSession, WhatCostsTooMuchIsNotBegun) {
  Constraints<2> shape = ring(), few(shape.begin(), shape.begin() + 30);
  const Index rows = fit(shape).report.rows;
  EditSession<2> session(shape);
  const Budget budget{.full = rows - 1};
  const FitOptions same;
  shape[4].at *= 0.9;
  session.update(shape, same, budget);
  EXPECT_EQ(session.last().full, Full::no) << "a border is none";
  const Values before = session.fit().function.normalized_weights();
  const FitOptions cubic{.kernel = Kernel::cubic};
  try {
    session.update(shape, cubic, budget);
    ADD_FAILURE() << "a full fit was made";
  } catch (const OverBudget& due) {
    EXPECT_EQ(due.reason(), Full::options);
    EXPECT_EQ(due.rows(), rows);
  }
  auto many = shape;
  for (Constraint<2>& each : many) each.at *= 1.01;
  EXPECT_THROW(session.update(many, same, budget), OverBudget);
  EXPECT_EQ(session.fit().function.normalized_weights(), before);
  EXPECT_EQ(session.options().kernel, std::nullopt);
  shape[5].at *= 0.9;
  expect_as_fitted(session.update(shape, same, budget), fit(shape));
  EXPECT_EQ(session.last().full, Full::no);
  expect_as_fitted(session.update(few, same, budget), fit(few));
  EXPECT_EQ(session.last().full, Full::few_rows);
}

}  // namespace
}  // namespace seesaw
