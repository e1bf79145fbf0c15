// Solving on another thread: the same answers as at once, whenever they come.
#include "core/editing/background_solver.h"

#include <gmock/gmock.h>

#include <atomic>
#include <thread>
#include <utility>

#include "core/editing/editor.h"
#include "tests/core/rbf/edited.h"

namespace seesaw {
namespace {

using ElsewhereReason = ConstraintError::Reason;

// Small enough for a test, and everything happens: full fits at once and elsewhere, borders, refits.
BackgroundOptions busy_options(Index at_once = 90) {
  return {.at_once = at_once, .edit = {.smallest = 20, .largest_border = 24, .refit_border = 8}};
}
/// Every full fit is made elsewhere; borders, too, where `border_at_once` is 0.
BackgroundOptions elsewhere(std::function<void()> arrived = {}, double border_at_once = infinity) {
  return {.at_once = 0,
          .border_at_once = border_at_once,
          .edit = {.smallest = 20},
          .arrived = std::move(arrived)};
}

template <int Dim>
Document<Dim> document_of(const Constraints<Dim>& constraints) {
  Document<Dim> document;
  for (const Constraint<Dim>& each : constraints) document.constraints.push_back({.constraint = each});
  return document;
}

template <int Dim>
Fit<Dim> fit_of(const Document<Dim>& document) {
  return fit(constraints_of(document), {.kernel = document.kernel, .smoothing = document.smoothing});
}

/// A document, its shape, and the solver between them.
template <int Dim>
struct Solved {
  Document<Dim> document;
  BackgroundSolver<Dim> solver;
  Shape<Dim> shape = {};
  std::uint64_t revision = 0;

  Solved(const Constraints<Dim>& constraints, BackgroundOptions options)
      : document(document_of(constraints)), solver(std::move(options)) {
    ask();
  }
  void ask() { solve<Dim>(shape, document, ++revision, solver); }
  void settle() {
    solver.wait();
    ask();
    EXPECT_FALSE(shape.pending);
  }
  void set(const Constraints<Dim>& constraints) {
    document.constraints = document_of(constraints).constraints;
  }
  void expect_settled_as_fitted() {
    settle();
    ASSERT_TRUE(shape.current());
    EXPECT_EQ(shape.revision, revision);
    expect_as_fitted<Dim>({*shape.function, shape.report}, fit_of(document));
  }
};

template <class T>
class BackgroundIn : public testing::Test {};
template <int D>
struct ElsewhereIn {
  static constexpr int value = D;
};
using ElsewhereDimensions = testing::Types<ElsewhereIn<2>, ElsewhereIn<3>>;
TYPED_TEST_SUITE(BackgroundIn, ElsewhereDimensions);

TYPED_TEST(BackgroundIn, WhateverIsEditedMeanwhileItIsFitsFunction) {
  constexpr int Dim = TypeParam::value;
  int pending = 0, bordered = 0;
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    Random random(seed);
    auto constraints = random_constraints<Dim>(75, random);
    BackgroundOptions options = busy_options();
    options.border_at_once = seed % 2 ? infinity : 2.5e4;  // two or three solves
    Solved<Dim> solved(constraints, options);
    for (int k = 0; k < 250; ++k) {
      if (random.index(12) == 0) solved.document.kernel = all_kernels[random.index(3)];
      if (random.index(12) == 0) solved.document.smoothing = random.index(2) ? 0.01 * random.uniform() : 0.0;
      for (Index edits = random.index(20) ? 1 : 12; edits > 0; --edits) edit_at_random(constraints, random);
      solved.set(constraints);
      solved.ask();
      ASSERT_FALSE(solved.shape.impossible);
      pending += solved.shape.pending;
      bordered += solved.shape.current() && solved.solver.session() &&
                  solved.solver.session()->last().full == Full::no;
      if (random.index(3) == 0) std::this_thread::sleep_for(std::chrono::microseconds(random.index(3000)));
      if (random.index(2) && solved.solver.poll()) solved.ask();
      if (solved.shape.current() && k % 4 == 0)
        expect_as_fitted<Dim>({*solved.shape.function, solved.shape.report}, fit_of(solved.document));
      if (random.index(10) == 0) solved.expect_settled_as_fitted();
      if (this->HasFailure()) FAIL() << "seed " << seed << ", edit " << k;
    }
    solved.expect_settled_as_fitted();
  }
  EXPECT_GE(pending, 50);
  EXPECT_GE(bordered, 200);
}

TEST(BackgroundSolver, SmallDocumentsNeverWait) {
  Random random(1);
  auto constraints = random_constraints<2>(100, random);
  std::atomic<int> arrived = 0;
  Solved<2> solved(constraints, {.arrived = [&] { ++arrived; }});
  for (int k = 0; k < 100; ++k) {
    edit_at_random(constraints, random);
    solved.set(constraints);
    if (k % 9 == 0) solved.document.kernel = all_kernels[(k / 9) % 3];
    solved.ask();
    ASSERT_TRUE(solved.shape.current());
    ASSERT_FALSE(solved.solver.busy());
    ASSERT_FALSE(solved.solver.poll());
  }
  EXPECT_EQ(arrived, 0);
}

TEST(BackgroundSolver, WhereEverythingIsQuickItIsALiveSolver) {
  const EditOptions edit{.smallest = 20};
  const BackgroundSolver<3> background({.at_once = 1'000'000, .edit = edit});
  const LiveSolver<3> live(edit);
  Random random(2);
  auto constraints = random_constraints<3>(120, random);
  for (int k = 0; k < 120; ++k) {
    edit_at_random(constraints, random);
    const FitOptions options{.smoothing = k > 60 ? 0.01 : 0.0};
    const Fit<3> a = background(constraints, options), b = live(constraints, options);
    ASSERT_EQ(a.function.normalized_weights(), b.function.normalized_weights()) << k;
    ASSERT_EQ(background.session()->last().full, live.session()->last().full);
    ASSERT_FALSE(background.busy());
  }
}

TEST(BackgroundSolver, WhileItIsPendingTheShapeOfBeforeStays) {
  Constraints<2> shape = ring();
  Solved<2> solved(shape, elsewhere());
  EXPECT_TRUE(solved.shape.pending);
  EXPECT_FALSE(solved.shape.current());
  EXPECT_EQ(solved.shape.function, nullptr);
  EXPECT_TRUE(solved.solver.busy());
  solved.settle();
  EXPECT_TRUE(solved.shape.current());
  EXPECT_FALSE(solved.solver.busy());
  const auto before = solved.shape;
  solved.document.kernel = Kernel::cubic;
  solved.ask();
  EXPECT_TRUE(solved.shape.pending);
  EXPECT_EQ(solved.shape.function, before.function);
  EXPECT_EQ(solved.shape.revision, before.revision);
  solved.expect_settled_as_fitted();
  EXPECT_EQ(solved.shape.function->kernel(), Kernel::cubic);
}

TEST(BackgroundSolver, WhatIsEditedMeanwhileIsBorderedFromWhatArrives) {
  Constraints<2> shape = ring();
  Solved<2> solved(shape, elsewhere());
  shape[4].at = {0.9, 0.2};
  solved.set(shape);
  solved.ask();
  solved.expect_settled_as_fitted();
  EXPECT_EQ(solved.solver.session()->last().full, Full::no);
  EXPECT_EQ(solved.solver.session()->last().removed, 1);
}

TEST(BackgroundSolver, UndoneBeforeItArrivesItIsNotWaitedFor) {
  Solved<2> solved(ring(), elsewhere());
  solved.settle();
  solved.document.kernel = Kernel::cubic;
  solved.ask();
  EXPECT_TRUE(solved.shape.pending);
  solved.document.kernel = Kernel::thin_plate_spline;
  solved.ask();
  EXPECT_TRUE(solved.shape.current());
  EXPECT_FALSE(solved.solver.wait()) << "nobody wants what arrives";
  solved.expect_settled_as_fitted();
}

TEST(BackgroundSolver, ABorderThatTakesLongIsMadeElsewhereToo) {
  Constraints<2> shape = ring();
  Solved<2> solved(shape, elsewhere({}, 0));
  solved.settle();
  const auto before = solved.shape.function;
  for (int k = 0; k < 40; ++k) {
    for (std::size_t i = 10; i < 12; ++i) shape[i].at *= 1.003;
    solved.set(shape);
    const bool idle = !solved.solver.busy();
    solved.ask();
    // Of a border that was under way the answer may have come by now, and have followed this very question.
    EXPECT_TRUE(solved.shape.pending || !idle);
    EXPECT_TRUE(solved.shape.pending ? solved.solver.busy() : solved.shape.current());
    if (k % 3 == 0 && solved.solver.poll()) solved.ask();
    if (k % 7 == 0) solved.expect_settled_as_fitted();
  }
  solved.expect_settled_as_fitted();
  EXPECT_NE(solved.shape.function, before);
  ASSERT_TRUE(solved.solver.session()) << "it is back";
  EXPECT_EQ(solved.solver.session()->last().full, Full::no);
}

// The session is away; what it would be asked for meanwhile is another document, and a small one.
TEST(BackgroundSolver, AnotherDocumentDoesNotWaitForASessionThatIsAway) {
  Constraints<2> shape = ring(), small(shape.begin(), shape.begin() + 3);
  BackgroundOptions options = elsewhere({}, 0);
  options.at_once = 10;
  Solved<2> solved(shape, options);
  solved.settle();
  shape[4].at *= 1.01;
  solved.set(shape);
  solved.ask();
  EXPECT_TRUE(solved.shape.pending);
  EXPECT_EQ(solved.solver.session(), nullptr);
  EXPECT_TRUE(solved.solver.fraction());
  solved.set(small);
  solved.ask();
  EXPECT_TRUE(solved.shape.current());
  EXPECT_FALSE(solved.solver.fraction()) << "nobody waits for it";
  EXPECT_FALSE(solved.solver.wait());
  solved.expect_settled_as_fitted();
  solved.set(shape);
  solved.ask();
  solved.expect_settled_as_fitted();
}

TEST(BackgroundSolver, OneAtATime) {
  Random random(3);
  std::atomic<int> works = 0;  // that have arrived, or nearly: each has a thread of its own
  const auto arrived = [&] {
    static thread_local bool counted = false;
    works += !std::exchange(counted, true);
  };
  Solved<2> solved(random_constraints<2>(500, random), elsewhere(arrived));
  solved.settle();
  EXPECT_EQ(works, 1);
  for (int k = 1; k <= 30; ++k) {
    solved.document.smoothing = 0.001 * k;
    solved.ask();
    EXPECT_TRUE(solved.shape.pending);
  }
  const int before = works;
  solved.settle();
  EXPECT_GE(works, 3) << "the first that was asked for, and the last";
  EXPECT_LE(works, before + 2) << "what was under way, and the last";
  EXPECT_EQ(solved.shape.report.smoothing, 0.03);
}

TEST(BackgroundSolver, ASliderIsFollowed) {
  Random random(4);
  Solved<2> solved(random_constraints<2>(400, random), elsewhere());
  solved.settle();
  const auto before = solved.shape.function;
  solved.document.smoothing = 0.01;
  solved.ask();
  solved.document.smoothing = 0.02;
  solved.ask();
  while (solved.shape.function == before)
    if (solved.solver.poll()) solved.ask();
  if (solved.shape.pending) {
    EXPECT_EQ(solved.shape.report.smoothing, 0.01);
  }
  solved.expect_settled_as_fitted();
}

TEST(BackgroundSolver, AnotherDocumentsShapeIsNotShown) {
  Random random(5);
  BackgroundSolver<2> solver(elsewhere());
  Shape<2> first, second;
  const auto one = document_of(random_constraints<2>(300, random));
  const auto other = document_of(random_constraints<2>(60, random));
  solve<2>(first, one, 0, solver);
  solve<2>(second, other, 0, solver);
  int asked = 0;
  while (!second.function) {
    EXPECT_TRUE(second.pending);
    if (solver.poll()) solve<2>(second, other, 0, solver), ++asked;
  }
  EXPECT_TRUE(second.current());
  EXPECT_EQ(asked, 1) << "the arrival of the first is no news for the second";
  EXPECT_LE(difference(*second.function, fit_of(other).function), as_good_as_fit);
}

TEST(BackgroundSolver, WhatIsFoundImpossibleElsewhereHasItsCulprits) {
  Constraints<2> shape = ring(), bad = shape;
  bad[2].at = bad[60].at + Point<2>(4e-12, 0);  // which only the factorization can tell
  for (const bool first : {true, false}) {
    Solved<2> solved(first ? bad : shape, elsewhere());
    if (!first) {
      solved.settle();
      solved.set(bad);
      solved.document.kernel = Kernel::cubic;
      solved.ask();
    }
    EXPECT_TRUE(solved.shape.pending);
    EXPECT_FALSE(solved.shape.impossible);
    EXPECT_TRUE(solved.solver.wait());
    solved.ask();
    EXPECT_FALSE(solved.shape.pending);
    ASSERT_TRUE(solved.shape.impossible);
    const auto by_fit = refusal_of([&] { fit_of(solved.document); });
    ASSERT_TRUE(by_fit);
    EXPECT_EQ(by_fit->reason(), ElsewhereReason::too_close);
    EXPECT_EQ(solved.shape.impossible->reason, by_fit->reason());
    EXPECT_EQ(solved.shape.impossible->culprits, by_fit->culprits());
    EXPECT_EQ(solved.shape.impossible->message, by_fit->what());
    solved.ask();
    EXPECT_TRUE(solved.shape.impossible) << "it stays so without another fit";
    EXPECT_FALSE(solved.solver.busy());

    // Asked for something else it is not known yet, which is not impossible.
    solved.document.kernel = Kernel::linear;
    solved.set(shape);
    solved.ask();
    EXPECT_FALSE(solved.shape.impossible);
    EXPECT_TRUE(solved.shape.pending);
    solved.expect_settled_as_fitted();
  }
}

TEST(BackgroundSolver, ARefusalIsForWhatWasRefusedOnly) {
  Constraints<2> shape = ring(), bad = shape;
  bad[2].at = bad[60].at + Point<2>(4e-12, 0);
  Solved<2> solved(bad, elsewhere());
  solved.set(shape);
  solved.ask();
  EXPECT_TRUE(solved.shape.pending);
  solved.expect_settled_as_fitted();
  solved.set(bad);
  solved.ask();
  solved.settle();
  EXPECT_TRUE(solved.shape.impossible);
}

TEST(BackgroundSolver, WhatCanBeRefusedAtOnceIs) {
  Constraints<2> shape = ring(), bad = shape;
  bad[4].at = bad[60].at;  // 0 and 1 in one place
  Solved<2> solved(bad, elsewhere());
  ASSERT_TRUE(solved.shape.impossible);
  EXPECT_EQ(solved.shape.impossible->reason, ElsewhereReason::contradictory);
  EXPECT_FALSE(solved.solver.busy());
  solved.set(shape);
  solved.ask();
  EXPECT_TRUE(solved.shape.pending);
  EXPECT_FALSE(solved.shape.impossible);
  solved.set(bad);
  solved.ask();
  EXPECT_TRUE(solved.shape.impossible);
  EXPECT_FALSE(solved.shape.pending);
  solved.settle();
  EXPECT_TRUE(solved.shape.impossible);
  solved.set(shape);
  solved.ask();
  EXPECT_TRUE(solved.shape.current()) << "it had arrived meanwhile";
  expect_as_fitted<2>({*solved.shape.function, solved.shape.report}, fit_of(solved.document));
}

TEST(BackgroundSolver, FlatSetsSettleToo) {
  Constraints<2> line;
  for (int i = 0; i < 70; ++i) line.push_back(interior<2>({0.02 * i, 0.01 * i}, 1 + i % 3));
  Solved<2> solved(line, elsewhere());
  for (int k = 0; k < 3; ++k) {
    solved.expect_settled_as_fitted();
    EXPECT_TRUE(solved.shape.report.degenerate);
    EXPECT_FALSE(solved.solver.busy());
    line[5].value += 1;
    solved.set(line);
    solved.ask();
  }
}

TEST(BackgroundSolver, RefitsNowAndThenAndSaysWhatThatChanged) {
  Random random(6);
  auto constraints = random_constraints<3>(120, random);
  Solved<3> solved(constraints, busy_options(0));
  solved.settle();
  EXPECT_FALSE(solved.solver.last_difference());
  while (!solved.solver.busy()) {
    edit_at_random(constraints, random);
    solved.set(constraints);
    solved.ask();
    ASSERT_TRUE(solved.shape.current());
  }
  edit_at_random(constraints, random);
  solved.set(constraints);
  solved.ask();
  const auto before = solved.shape.function;
  if (!solved.solver.last_difference()) {
    EXPECT_TRUE(solved.solver.wait());
  }
  solved.ask();
  EXPECT_NE(solved.shape.function, before);
  ASSERT_TRUE(solved.solver.last_difference());
  EXPECT_GT(*solved.solver.last_difference(), 0);
  EXPECT_LE(*solved.solver.last_difference(), 2 * as_good_as_fit);
  EXPECT_LE(solved.solver.session()->last().removed + solved.solver.session()->last().added, 4);
  EXPECT_FALSE(solved.solver.busy());
  solved.expect_settled_as_fitted();
}

TEST(BackgroundSolver, TellsWhenSomethingHasArrived) {
  std::atomic<int> arrived = 0;
  std::atomic<bool> elsewhere_thread = false;
  const auto here = std::this_thread::get_id();
  const BackgroundSolver<2> solver(elsewhere([&] {
    elsewhere_thread = std::this_thread::get_id() != here;
    ++arrived;
  }));
  const Solver<2> copy = solver;
  EXPECT_THROW(copy(ring(), {}), StillSolving<2>);
  int told = 0;
  do {  // more than once where it takes so long that it tells of its progress
    EXPECT_TRUE(solver.busy()) << "until it is polled";
    while (arrived == told) std::this_thread::yield();
    told = arrived;
    EXPECT_TRUE(elsewhere_thread);
  } while (!solver.poll());
  EXPECT_FALSE(solver.busy());
  EXPECT_FALSE(solver.poll());
  expect_as_fitted(copy(ring(), {}), fit(ring()));
}

TEST(BackgroundSolver, CanGoWhileItIsAtWork) {
  Random random(7);
  const auto constraints = random_constraints<3>(200, random);
  for (int k = 0; k < 10; ++k) {
    auto arrived = std::make_unique<std::atomic<int>>(0);
    Solved<3> solved(constraints, elsewhere([&count = *arrived] { ++count; }));
    EXPECT_TRUE(solved.shape.pending);
    solved.solver = BackgroundSolver<3>();
    arrived.reset();
  }
}

TEST(BackgroundSolver, AnEditorAsksAgainWithoutATrace) {
  Editor<2> untouched(document_of(ring()));
  const BackgroundSolver<2> solver(elsewhere());
  for (const bool at_once : {true, false}) {
    Editor<2> editor(document_of(ring()), {.solver = solver, .solve_at_once = at_once});
    editor.apply(Move<2>{{3}, {0.1, 0}});
    editor.apply(SetKernel{Kernel::cubic});
    editor.shape();
    int told = 0;
    editor.listen([&](const auto&, const auto&) { ++told; });
    const auto revision = editor.revision(), state = editor.state();
    solver.wait();
    editor.solve_again();
    EXPECT_TRUE(editor.shape().current());
    EXPECT_EQ(editor.shape().revision, revision);
    EXPECT_EQ(editor.revision(), revision);
    EXPECT_EQ(editor.state(), state);
    EXPECT_EQ(editor.undo_size(), 2u);
    EXPECT_EQ(told, 0);
    EXPECT_LE(difference(*editor.shape().function, fit_of(editor.document()).function), as_good_as_fit);
    editor.undo();
    EXPECT_FALSE(editor.shape().impossible);
  }
}

TEST(BackgroundSolver, WhatAsksTheShapeIsRefusedBeforeThereIsOne) {
  const BackgroundSolver<2> solver(elsewhere());
  Editor<2> editor(document_of(ring()), {.solver = solver});
  try {
    editor.apply(AddNormal{.which = 0});
    ADD_FAILURE() << "no shape, no normal";
  } catch (const Refused& refused) {
    EXPECT_THAT(refused.what(), testing::HasSubstr("still being solved"));
  }
  solver.wait();
  editor.solve_again();
  EXPECT_NO_THROW(editor.apply(AddNormal{.which = 0}));
}

}  // namespace
}  // namespace seesaw
