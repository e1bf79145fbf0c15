// A desk whose shapes are solved on another thread.
#include <gmock/gmock.h>

#include "core/editing/background_solver.h"
#include "tests/core/editing/desk_at_hand.h"

namespace seesaw {
namespace {

class DeskPending : public ::testing::Test {
 protected:
  DeskPending() : desk(small_scene(), options_of(solver, other)), hand{desk} {
    desk.view().resize(800, 600);
    desk.show_as_saved();
  }
  static DeskOptions options_of(const Solver<2>& solver, const Solver<2>& other) {
    DeskOptions options;
    options.editor.solver = solver;
    options.other_solver = other;
    return options;
  }
  void settle() {
    solver.wait();
    other.wait();
    desk.solve_again();
  }

  BackgroundSolver<2> solver{{.at_once = 0}}, other{{.at_once = 0}};
  Desk desk;
  TestHand hand;
};

TEST_F(DeskPending, ItCanBeWorkedWithBeforeThereIsAShape) {
  EXPECT_TRUE(desk.shape().pending);
  EXPECT_EQ(desk.shape().function, nullptr);
  desk.perform(DeskCommand::remember);
  EXPECT_TRUE(desk.message().trouble) << "there is nothing to remember";
  desk.perform(DeskCommand::select_culprits);
  EXPECT_THAT(desk.message().text, testing::HasSubstr("not known yet"));
  hand.click(desk.constraint(0).at);
  EXPECT_THAT(desk.selection().indices(), testing::ElementsAre(0));
  hand.drag(desk.constraint(0).at, {-1.5, 0});
  EXPECT_EQ(desk.constraint(0).at, Point<2>(-1.5, 0));
  settle();
  EXPECT_TRUE(desk.shape().current());
  EXPECT_NEAR(desk.shape().function->value({-1.5, 0}), 0, 1e-9);
  desk.perform(DeskCommand::select_culprits);
  EXPECT_THAT(desk.message().text, testing::HasSubstr("no culprit"));
}

TEST_F(DeskPending, TheCurveIsShownWholeOnceItIsThere) {
  const Box<2> before = desk.view().scene();
  settle();
  Desk at_once(small_scene());
  at_once.view().resize(800, 600);
  at_once.show_as_saved();
  EXPECT_NE(desk.view().scene().min(), before.min());
  EXPECT_EQ(desk.view().scene().min(), at_once.view().scene().min());
  EXPECT_EQ(desk.view().scene().max(), at_once.view().scene().max());
}

TEST_F(DeskPending, ButNotWhereAPersonHasMovedTheView) {
  desk.perform(DeskCommand::zoom_in);
  const Box<2> mine = desk.view().scene();
  settle();
  EXPECT_EQ(desk.view().scene().min(), mine.min());
  EXPECT_EQ(desk.view().scene().max(), mine.max());
}

TEST_F(DeskPending, TheOtherKernelsShapeComesLaterToo) {
  settle();
  desk.perform(DeskCommand::compare_kernels);
  EXPECT_EQ(desk.other(), nullptr);
  EXPECT_TRUE(desk.other_pending());
  settle();
  ASSERT_NE(desk.other(), nullptr);
  EXPECT_FALSE(desk.other_pending());
  EXPECT_EQ(std::string(name_of(desk.other()->kernel())), desk.other_name());
  desk.apply(MoveTo<2>{4, {0.1, 0.1}});
  EXPECT_NE(desk.other(), nullptr) << "that of before, meanwhile";
  EXPECT_TRUE(desk.other_pending());
  settle();
  ASSERT_NE(desk.other(), nullptr);
  EXPECT_NEAR(desk.other()->value({0.1, 0.1}), 1, 1e-9);
  EXPECT_FALSE(desk.other_pending());
  desk.perform(DeskCommand::compare_kernels);
  EXPECT_EQ(desk.other(), nullptr) << "never that of a third kernel";
}

TEST_F(DeskPending, AnotherDocumentBeginsWithoutAShape) {
  settle();
  Document<2> next = small_scene();
  for (SceneConstraint<2>& each : next.constraints) each.constraint.at += Point<2>(7, 7);
  desk.start(next);
  EXPECT_TRUE(desk.shape().pending);
  EXPECT_EQ(desk.shape().function, nullptr);
  settle();
  EXPECT_TRUE(desk.shape().current());
  EXPECT_NEAR(desk.shape().function->value({7, 7}), 1, 1e-9);
}

}  // namespace
}  // namespace seesaw
