// Editing without refitting against fitting: the same functions, whatever the edits.
#include "core/rbf/edit_session.h"

#include <gmock/gmock.h>

#include <future>

#include "tests/core/rbf/edited.h"

namespace seesaw {
namespace {

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

TEST(EditSession, ARefitIsHandedOverAmidEdits) {
  Random random(8);
  auto constraints = random_constraints<2>(150, random);
  EditSession<2> session(constraints);
  while (!session.wants_refit()) {
    edit_at_random(constraints, random);
    session.update(constraints);
  }
  EXPECT_GE(session.last().removed + session.last().added, EditOptions{}.refit_border);
  auto refit = std::async(std::launch::async, [constraints] { return EditSession<2>(constraints); });
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
  EXPECT_FALSE(session.adopt(EditSession<2>(shape, {.kernel = Kernel::cubic})).adopted);
  EXPECT_FALSE(session.adopt(EditSession<2>(shape, {.smoothing = 0.1})).adopted);
  for (Constraint<2>& each : elsewhere) each.at *= 1.2;
  EXPECT_FALSE(session.adopt(EditSession<2>(elsewhere)).adopted);
  EXPECT_EQ(session.fit().function.normalized_weights(), weights);
  EXPECT_TRUE(session.adopt(EditSession<2>(shape)).adopted);
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
