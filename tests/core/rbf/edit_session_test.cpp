// Editing without refitting against fitting: the same functions, the same errors, whatever the edits.
#include "core/rbf/edit_session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <future>
#include <limits>

#include "tests/support/shapes.h"

namespace seesaw {
namespace {

using Full = EditReport::Full;
using Reason = ConstraintError::Reason;
using testing::ElementsAre;

// Bordered whenever it is possible at all, so that few constraints do for a test.
const EditOptions eager = {.smallest = 20};

constexpr double as_good_as_fit = 1e-8;  // of the values: what an edit may differ from a fit by

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

std::optional<ConstraintError> refusal_of(const std::function<void()>& work) {
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

template <class T>
class EditSessionIn : public testing::Test {};
template <int D>
struct InDimension {
  static constexpr int value = D;
};
using EditedDimensions = testing::Types<InDimension<2>, InDimension<3>>;
TYPED_TEST_SUITE(EditSessionIn, EditedDimensions);

TYPED_TEST(EditSessionIn, HundredsOfEditsGiveFitsFunction) {
  constexpr int Dim = TypeParam::value;
  for (const Kernel kernel : all_kernels)
    for (const double smoothing : {0.0, 0.01}) {
      Random random(1);
      const FitOptions options{.kernel = kernel, .smoothing = smoothing};
      auto constraints = random_constraints<Dim>(70, random);
      EditSession<Dim> session(constraints, options, eager);
      int bordered = 0;
      for (int k = 0; k < 300; ++k) {
        edit_at_random(constraints, random);
        const auto& edited = session.update(constraints);
        bordered += session.last().full == Full::no;
        if (k % 6 == 0) expect_as_fitted(edited, fit(constraints, options));
      }
      EXPECT_GE(bordered, 250) << name_of(kernel) << smoothing;
    }
}

// A ring of 60 boundary constraints, every other one with its normal, and something inside.
Constraints<2> ring() {
  Constraints<2> constraints;
  for (int i = 0; i < 60; ++i) {
    const Point<2> out(std::cos(i * M_PI / 30), std::sin(i * M_PI / 30));
    constraints.push_back(i % 2 ? boundary<2>(out, out) : boundary<2>(out));
  }
  constraints.push_back(interior<2>({0.1, 0.2}));
  return constraints;
}

TEST(EditSession, DocstringExample) {
  Constraints<2> shape = ring();
  EditSession<2> session(shape);
  shape[4].at = {0.9, 0.2};
  const Fit<2> moved = session.update(shape);
  EXPECT_EQ(session.last().solves, 2);
  EXPECT_LE(difference(moved.function, fit(shape).function), as_good_as_fit);
  shape[4].at = {0.9, 0.3};
  session.update(shape);
  EXPECT_EQ(session.last().solves, 1);
  EXPECT_EQ(session.last().full, Full::no);
  EXPECT_LE(difference(session.fit().function, fit(shape).function), as_good_as_fit);
}

TEST(EditSession, SolvesForWhatIsNewAndNothingElse) {
  Constraints<2> shape = ring();
  EditSession<2> session(shape);
  const auto solves = [&] {
    session.update(shape);
    EXPECT_EQ(session.last().full, Full::no);
    return session.last().solves;
  };
  EXPECT_EQ(solves(), 0);
  shape[1].at += Point<2>(0.01, 0);  // with its normal: two rows out, two in
  EXPECT_EQ(solves(), 4);
  shape[1].at += Point<2>(0.01, 0);
  EXPECT_EQ(solves(), 2);
  shape[1].normal->direction = {1, 0.1};  // the boundary row stays where it is
  EXPECT_EQ(solves(), 1);
  shape[60].value = 2;
  EXPECT_EQ(solves(), 1);
  shape[60].value = 3;
  EXPECT_EQ(solves(), 1);
  shape.push_back(boundary<2>({0, -0.5}));
  EXPECT_EQ(solves(), 1);
  shape.back().value = 0.25;  // of a row that was added: the border knows it by its position
  EXPECT_EQ(solves(), 0);
  shape.pop_back();
  EXPECT_EQ(solves(), 0);
  shape.erase(shape.begin());
  EXPECT_EQ(solves(), 1);
  expect_as_fitted(session.fit(), fit(shape));
}

TEST(EditSession, AnotherOrderIsNoChange) {
  Constraints<2> shape = ring();
  EditSession<2> session(shape);
  std::reverse(shape.begin(), shape.end());
  expect_as_fitted(session.update(shape), fit(shape));
  EXPECT_EQ(session.last().removed + session.last().added, 0);
  EXPECT_EQ(session.last().solves, 0);
}

TEST(EditSession, UndoneToTheStartIsTheStartToTheBit) {
  Random random(2);
  Constraints<3> constraints = random_constraints<3>(90, random);
  const Constraints<3> start = constraints;
  EditSession<3> session(constraints);
  const Fit<3> first = session.fit();
  for (int k = 0; k < 10; ++k) {
    edit_at_random(constraints, random);
    session.update(constraints);
    ASSERT_EQ(session.last().full, Full::no);
  }
  const Fit<3>& back = session.update(start);
  EXPECT_EQ(back.function.normalized_weights(), first.function.normalized_weights());
  EXPECT_EQ(back.function.normalized_polynomial(), first.function.normalized_polynomial());
  EXPECT_EQ(back.function.centers(), first.function.centers());
}

TEST(EditSession, SameEditsSameBits) {
  std::vector<Values> weights[2];
  for (auto& its : weights) {
    Random random(3);
    auto constraints = random_constraints<2>(80, random);
    EditSession<2> session(constraints, {}, eager);
    for (int k = 0; k < 40; ++k) {
      edit_at_random(constraints, random);
      its.push_back(session.update(constraints).function.normalized_weights());
    }
  }
  EXPECT_EQ(weights[0], weights[1]);
}

TEST(EditSession, TheFunctionIsOneLikeAnyOther) {
  Random random(4);
  auto constraints = random_constraints<3>(80, random);
  EditSession<3> session(constraints);
  constraints[10].at = anywhere<3>(random);
  constraints.erase(constraints.begin() + 20);
  const Interpolant<3>& f = session.update(constraints).function;
  ASSERT_EQ(session.last().full, Full::no);
  const Interpolant<3> g = fit(constraints).function;
  // Removed centers are gone, not there with weight zero; the side conditions of eq. 8 hold.
  EXPECT_EQ(f.size(), g.size());
  const Values w = f.weights();
  EXPECT_LE(std::abs(w.sum()), 1e-13 * w.cwiseAbs().sum());
  EXPECT_LE((f.centers() * w).cwiseAbs().maxCoeff(), 1e-13 * w.cwiseAbs().sum());
  EXPECT_LE((w - g.weights()).norm(), 1e-7 * w.norm());
  EXPECT_LE((f.polynomial() - g.polynomial()).norm(), 1e-7 * g.polynomial().norm());
  for (int k = 0; k < 20; ++k) {
    const Point<3> x = anywhere<3>(random);
    EXPECT_LE((f.gradient(x) - g.gradient(x)).norm(), 1e-7 * g.gradient(x).norm());
  }
  const Box<3> box(Point<3>(-0.1, -0.2, 0), Point<3>(0.1, 0.1, 0.3));
  EXPECT_NEAR(f.gradient_bound(box), g.gradient_bound(box), 1e-7 * g.gradient_bound(box));
  EXPECT_TRUE(f.bounding_box().isApprox(g.bounding_box()));
}

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

  EditSession<3> refining(constraints, {}, {.accuracy = 0.5 * residual});
  expect_as_fitted(refining.update(moved), fit(moved));
  EXPECT_EQ(refining.last().checked, refining.fit().report.rows);
  if (refining.last().full == Full::no) {
    EXPECT_TRUE(refining.last().refined);
    EXPECT_LT(refining.last().residual, measured.last().residual);
  } else {  // on two lanes a refinement may have nothing left to refine: the residual is rounding
    EXPECT_EQ(refining.last().full, Full::inaccurate);
  }

  EditSession<3> refitting(constraints, {}, {.accuracy = 1e-18});
  expect_as_fitted(refitting.update(moved), fit(moved));
  EXPECT_EQ(refitting.last().full, Full::inaccurate);
}

TEST(EditSession, ARefitIsHandedOverAmidEdits) {
  Random random(8);
  auto constraints = random_constraints<2>(150, random);
  EditSession<2> session(constraints);
  while (!session.wants_refit()) {
    edit_at_random(constraints, random);
    session.update(constraints);
  }
  EXPECT_GE(session.last().removed + session.last().added, EditOptions{}.refit_border);
  auto refit = std::async(std::launch::async, [job = session.refit_job()] { return job.run(); });
  for (int k = 0; k < 4; ++k) {
    edit_at_random(constraints, random);
    session.update(constraints);
  }
  const Index before = session.last().removed + session.last().added;
  const Handover handover = session.adopt(refit.get());
  EXPECT_TRUE(handover.adopted);
  EXPECT_LE(handover.difference, as_good_as_fit * 2);  // values are up to 2
  EXPECT_GT(handover.difference, 0.0);
  EXPECT_EQ(session.last().full, Full::no);
  EXPECT_LE(session.last().removed + session.last().added, 4 * 4);
  EXPECT_LT(session.last().removed + session.last().added, before);
  EXPECT_FALSE(session.wants_refit());
  expect_as_fitted(session.fit(), fit(constraints));
  edit_at_random(constraints, random);
  expect_as_fitted(session.update(constraints), fit(constraints));
}

TEST(EditSession, ARefitOfSomethingElseIsDeclined) {
  Constraints<2> shape = ring(), elsewhere = ring();
  EditSession<2> session(shape);
  shape[2].at *= 1.1;
  session.update(shape);
  const Values weights = session.fit().function.normalized_weights();
  EXPECT_FALSE(session.adopt(full_fit(shape, {.kernel = Kernel::cubic})).adopted);
  EXPECT_FALSE(session.adopt(full_fit(shape, {.smoothing = 0.1})).adopted);
  for (Constraint<2>& each : elsewhere) each.at *= 1.2;
  EXPECT_FALSE(session.adopt(full_fit(elsewhere)).adopted);
  EXPECT_EQ(session.fit().function.normalized_weights(), weights);
  EXPECT_TRUE(session.adopt(session.refit_job().run()).adopted);
  EXPECT_EQ(session.last().removed + session.last().added, 0);
}

TEST(EditSession, SmoothedMeasurementsAtOnePositionCountTwice) {
  Constraints<2> shape = ring();
  const FitOptions smooth{.smoothing = 0.05};
  shape.push_back(interior<2>(shape[3].at));
  EditSession<2> session(shape, smooth);
  shape[61].value = 2;
  shape[5].at *= 0.9;
  expect_as_fitted(session.update(shape), fit(shape, smooth));
  EXPECT_EQ(session.last().full, Full::no);
  shape.erase(shape.begin() + 3);
  expect_as_fitted(session.update(shape), fit(shape, smooth));
  shape.push_back(interior<2>(shape[8].at, 0.5));
  expect_as_fitted(session.update(shape), fit(shape, smooth));
  EXPECT_EQ(session.last().full, Full::close_rows);
}

TEST(EditSession, InFourDimensions) {
  Random random(9);
  auto constraints = random_constraints<4>(70, random);
  EditSession<4> session(constraints);
  for (int k = 0; k < 10; ++k) {
    edit_at_random(constraints, random);
    expect_as_fitted(session.update(constraints), fit(constraints));
    EXPECT_EQ(session.last().full, Full::no);
  }
}

TEST(LiveSolver, IsASolver) {
  const LiveSolver<2> live({.smallest = 20});
  const std::function<Fit<2>(const Constraints<2>&, const FitOptions&)> solver = live;
  EXPECT_EQ(live.session(), nullptr);
  EXPECT_TRUE(refusal_of([&] { solver({}, {}); }));
  EXPECT_EQ(live.session(), nullptr);
  Constraints<2> shape = ring();
  expect_as_fitted(solver(shape, {}), fit(shape));
  shape[0].at = {1.1, 0.1};
  expect_as_fitted(solver(shape, {}), fit(shape));
  ASSERT_NE(live.session(), nullptr);
  EXPECT_EQ(live.session()->last().full, Full::no);
  EXPECT_EQ(name_of(live.session()->last().full), "bordered");
}

}  // namespace
}  // namespace seesaw
