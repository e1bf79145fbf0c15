// Every tool, every gesture, every key of the desk: what it does, and that one undo takes all of it back.
#include "core/editing/desk.h"

#include <gmock/gmock.h>

#include "core/contour/contour.h"
#include "core/editing/replay.h"
#include "tests/core/editing/documents.h"
#include "tests/core/editing/hand.h"

namespace seesaw {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using K = DeskKey;
using C = DeskCommand;

constexpr double pixel_of_tests = 0.01;

/// Fig. 1 in spirit: 0 to 3 boundary, 4 interior. Far from all of them: (3, 2) and (-3, -2).
Document<2> small_scene() {
  Document<2> document;
  document.constraints = {{boundary<2>({-1, -0.2})},
                          {boundary<2>({0.3, -0.9})},
                          {boundary<2>({1, 0.1})},
                          {boundary<2>({-0.1, 0.8})},
                          {interior<2>({0, 0})}};
  document.title = "small";
  return document;
}

class DeskTest : public ::testing::Test {
 protected:
  DeskTest() : desk(small_scene()), hand{desk} {
    desk.view().resize(800, 600);
    desk.view().show(Box<2>(Point<2>(-4, -3), Point<2>(4, 3)));
    EXPECT_EQ(desk.view().pixel(), pixel_of_tests);
    start = bits_of(desk.document());
  }

  Point<2> place(Index i) const { return desk.constraint(i).at; }
  /// Runs `act`, which is to be one step to undo: expects that undo gives back every bit, and redo, too.
  template <class Act>
  void one_step(const Act& act) {
    const std::string before = bits_of(desk.document());
    const std::size_t steps = desk.editor().undo_size();
    act();
    ASSERT_FALSE(desk.editor().in_gesture());
    ASSERT_EQ(desk.editor().undo_size(), steps + 1) << desk.message().text;
    const std::string after = bits_of(desk.document());
    ASSERT_NE(after, before);
    hand.key(K::z, ctrl_key);
    ASSERT_EQ(bits_of(desk.document()), before);
    hand.key(K::y, ctrl_key);
    ASSERT_EQ(bits_of(desk.document()), after);
  }
  template <class Act>
  void no_step(const Act& act) {
    const std::string before = bits_of(desk.document());
    const std::size_t steps = desk.editor().undo_size();
    act();
    EXPECT_EQ(bits_of(desk.document()), before);
    EXPECT_EQ(desk.editor().undo_size(), steps);
    EXPECT_FALSE(desk.editor().in_gesture());
  }

  Desk desk;
  TestHand hand;
  std::string start;
};

TEST_F(DeskTest, ClicksSelect) {
  no_step([&] {
    hand.click({-1.03, -0.2});
    EXPECT_THAT(desk.selection().indices(), ElementsAre(0));
    hand.click(place(4), shift_key);
    EXPECT_THAT(desk.selection().indices(), ElementsAre(0, 4));
    hand.click(place(0), shift_key);
    EXPECT_THAT(desk.selection().indices(), ElementsAre(4));
    hand.click(place(2));
    EXPECT_THAT(desk.selection().indices(), ElementsAre(2));
    hand.click({3, 2});
    EXPECT_TRUE(desk.selection().empty());
    hand.key(K::a, ctrl_key);
    EXPECT_EQ(desk.selection().size(), 5);
    hand.click(place(1));
    EXPECT_THAT(desk.selection().indices(), ElementsAre(1)) << "of several, the one that is clicked";
    hand.key(K::b, shift_key);
    EXPECT_THAT(desk.selection().indices(), ElementsAre(0, 1, 2, 3));
    hand.key(K::i, shift_key);
    EXPECT_THAT(desk.selection().indices(), ElementsAre(4));
    hand.key(K::e, shift_key);
    EXPECT_TRUE(desk.selection().empty());
    hand.key(K::tab);
    hand.key(K::tab);
    EXPECT_THAT(desk.selection().indices(), ElementsAre(1));
    hand.key(K::tab, shift_key);
    hand.key(K::tab, shift_key);
    EXPECT_THAT(desk.selection().indices(), ElementsAre(4)) << "around the corner";
    hand.key(K::escape);
    EXPECT_TRUE(desk.selection().empty());
  });
}

TEST_F(DeskTest, ARubberBandSelects) {
  no_step([&] {
    hand.down({-1.5, -1.5});
    hand.to({0.1, 0.1});
    ASSERT_TRUE(desk.band());
    EXPECT_EQ(desk.band()->max(), Point<2>(0.1, 0.1));
    EXPECT_THAT(desk.selection().indices(), ElementsAre(0, 4)) << "while it is drawn";
    hand.to({0.4, 0.1});
    hand.up({0.4, 0.1});
    EXPECT_THAT(desk.selection().indices(), ElementsAre(0, 1, 4));
    EXPECT_FALSE(desk.band());
    hand.drag({1.5, 1.0}, {0.8, 0}, ctrl_key);
    EXPECT_THAT(desk.selection().indices(), ElementsAre(0, 1, 2, 4)) << "one that adds, drawn backward";
    hand.down({-1.5, -1.5});
    hand.to({2, 2});
    EXPECT_EQ(desk.selection().size(), 5);
    hand.key(K::escape);
    EXPECT_THAT(desk.selection().indices(), ElementsAre(0, 1, 2, 4)) << "Esc: as it was";
    hand.up({2, 2});
    EXPECT_THAT(desk.selection().indices(), ElementsAre(0, 1, 2, 4));
  });
}

TEST_F(DeskTest, ADragIsOneStep) {
  one_step([&] { hand.drag({1.02, 0.1}, {1.52, 0.4}); });
  EXPECT_LE((place(2) - Point<2>(1.5, 0.4)).norm(), 1e-15) << "it does not jump under the cursor";
  EXPECT_THAT(desk.selection().indices(), ElementsAre(2));
  EXPECT_STREQ(desk.editor().undo_name(), "move_to");
}

TEST_F(DeskTest, SeveralAreDraggedTogether) {
  hand.click(place(0));
  hand.click(place(4), shift_key);
  const Point<2> before[] = {place(0), place(4)};
  one_step([&] { hand.drag(place(4), {0.3, 0.7}); });
  EXPECT_LE((place(0) - before[0] - Point<2>(0.3, 0.7)).norm(), 1e-15);
  EXPECT_LE((place(4) - before[1] - Point<2>(0.3, 0.7)).norm(), 1e-15);
  EXPECT_THAT(desk.selection().indices(), ElementsAre(0, 4));
  one_step([&] { hand.drag(place(2), place(2) + Point<2>(0.5, 0)); });
  EXPECT_THAT(desk.selection().indices(), ElementsAre(2)) << "one that was not selected moves alone";
}

TEST_F(DeskTest, EscTakesADragBack) {
  for (const bool undo : {false, true})
    no_step([&] {
      hand.down(place(2));
      hand.to({2, 2});
      EXPECT_TRUE(desk.editor().in_gesture());
      EXPECT_EQ(place(2), Point<2>(2, 2));
      undo ? hand.key(K::z, ctrl_key) : hand.key(K::escape);
      EXPECT_EQ(desk.gesture(), Gesture::none);
      hand.to({3, 2});
      hand.up({3, 2});
    });
}

TEST_F(DeskTest, ADragThatComesBackIsNone) {
  no_step([&] {
    hand.down(place(2));
    hand.to({2, 2});
    hand.to({1, 0.1});
    hand.up({1, 0.1});
  });
  no_step([&] { hand.drag(place(2), place(2) + Point<2>(3 * pixel_of_tests, 0)); });  // A hand that trembles.
}

TEST_F(DeskTest, AnUnfinishedDragEndsWhereItIsWhenTheWindowLosesTheHand) {
  hand.down(place(2));
  hand.to({2, 2});
  desk.handle(FocusLost{});
  EXPECT_FALSE(desk.editor().in_gesture());
  EXPECT_EQ(place(2), Point<2>(2, 2));
  hand.up({3, 3});
  EXPECT_EQ(place(2), Point<2>(2, 2));
  EXPECT_EQ(desk.editor().undo_size(), 1u);
}

TEST_F(DeskTest, OtherButtonsDoNotDisturbADrag) {
  hand.down(place(2));
  hand.to({2, 2});
  desk.handle(PointerDown{{2, 2}, PointerButton::middle});
  desk.handle(PointerUp{{2, 2}, PointerButton::middle});
  hand.key(K::del);
  hand.key(K::k);
  hand.key(K::v, ctrl_key);
  EXPECT_EQ(desk.editor().size(), 5);
  hand.up({2, 1});
  EXPECT_EQ(place(2), Point<2>(2, 1));
  EXPECT_EQ(desk.editor().undo_size(), 1u);
}

TEST_F(DeskTest, ShiftDragsAlongAnAxisAndAltSnapsToNothing) {
  hand.key(K::g);
  ASSERT_EQ(desk.grid_step(), 0.5);
  one_step([&] { hand.drag(place(2), {1.83, 0.38}); });
  EXPECT_EQ(place(2), Point<2>(2, 0.5));
  one_step([&] { hand.drag(place(2), {1.13, 0.81}, no_keys, shift_key); });
  EXPECT_EQ(place(2), Point<2>(1, 0.5)) << "the axis of the larger way";
  one_step([&] { hand.drag(place(2), {1.13, 1.81}, no_keys, alt_key); });
  EXPECT_LE((place(2) - Point<2>(1.13, 1.81)).norm(), 1e-15);
  hand.key(K::comma);
  EXPECT_EQ(desk.grid_step(), 0.2);
  hand.key(K::period);
  hand.key(K::period);
  EXPECT_EQ(desk.grid_step(), 1);
  one_step([&] { hand.drag(place(2), {2.2, 1.3}); });
  EXPECT_EQ(place(2), Point<2>(2, 1));
  for (int i = 0; i < 100; ++i) hand.key(K::comma);
  EXPECT_GE(desk.grid_step(), 4 * pixel_of_tests) << "finer could not be seen";
  hand.key(K::g);
  EXPECT_FALSE(desk.grid().on);
}

TEST_F(DeskTest, AltClickGoesThroughAPile) {
  desk.apply(Add<2>{{{interior<2>({1, 0.1})}, {exterior<2>({1, 0.1})}}});
  EXPECT_FALSE(desk.shape().current()) << "three values in one place";
  desk.select({});
  hand.click({1, 0.1});
  EXPECT_THAT(desk.selection().indices(), ElementsAre(6)) << "the last is on top";
  for (const Index next : {5, 2, 6, 5}) {
    hand.click({1, 0.1}, alt_key);
    EXPECT_THAT(desk.selection().indices(), ElementsAre(next));
  }
  one_step([&] { hand.drag({1, 0.1}, {2, 2}, alt_key); });
  EXPECT_LE((place(2) - Point<2>(2, 2)).norm(), 1e-15) << "the one beneath 5";
}

TEST_F(DeskTest, AToolPlacesItsKind) {
  const struct {
    K key;
    ConstraintKind kind;
    double value;
  } cases[] = {{K::b, ConstraintKind::boundary, 0},
               {K::i, ConstraintKind::interior, 1},
               {K::e, ConstraintKind::exterior, -1}};
  for (const auto& each : cases) {
    hand.key(each.key);
    const double y = each.value + 1.5;
    one_step([&] { hand.click({2, y}); });
    const Index last = desk.editor().size() - 1;
    EXPECT_EQ(desk.constraint(last).kind, each.kind);
    EXPECT_EQ(desk.constraint(last).value, each.value);
    EXPECT_EQ(place(last), Point<2>(2, y));
    EXPECT_THAT(desk.selection().indices(), ElementsAre(last));
    one_step([&] { hand.drag({-2, y}, {-2.5, y}); });
    EXPECT_EQ(desk.editor().size(), last + 2);
    EXPECT_LE((place(last + 1) - Point<2>(-2.5, y)).norm(), 1e-15) << "placed and dragged in one";
    no_step([&] {
      hand.down({3, y});
      hand.to({2, y});
      EXPECT_EQ(desk.editor().size(), last + 3);
      hand.key(K::escape);
      hand.up({2, y});
    });
    one_step([&] { hand.drag({-2.5, y}, {-3, y}); });
    EXPECT_EQ(desk.editor().size(), last + 2) << "one that is there is dragged";
  }
  hand.key(K::escape);
  hand.key(K::escape);
  EXPECT_EQ(desk.tool(), Tool::select);
}

TEST_F(DeskTest, OnTheCurveNothingChanges) {
  hand.key(K::b);
  const auto before = desk.shape().function;
  const FitReport report = desk.shape().report;
  // Some pixels beside the curve.
  const Contour curve =
      contour(*before, Box<2>(Point<2>(-2, -2), Point<2>(2, 2)), boundary_points(desk.document()));
  ASSERT_EQ(curve.components, 1);
  const auto& vertices = curve.polylines[0].vertices;
  Index placed = 0;
  for (Index i = 0; i < vertices.cols(); i += vertices.cols() / 8) {
    const Point<2> at = vertices.col(i);
    const Point<2> beside = at - 4 * pixel_of_tests * before->gradient(at).normalized();
    hand.to(beside);
    if (desk.hover().over != Over::curve) continue;  // A constraint is near.
    EXPECT_LE((desk.hover().at - at).norm(), 2 * pixel_of_tests);
    one_step([&] { hand.click(beside); });
    ++placed;
    const Point<2> there = place(desk.editor().size() - 1);
    EXPECT_LE(std::abs(before->value(there)), 1e-14);
    EXPECT_LE((there - at).norm(), pixel_of_tests);
  }
  EXPECT_GE(placed, 4);
  const Box<2> box(Point<2>(-2, -2), Point<2>(2, 2));
  EXPECT_LE(greatest_change<2>(*before, *desk.shape().function, box),
            100 * (rounding<2>(report, *before, box) + rounding<2>(desk.shape().report, *before, box)));

  hand.key(K::v);
  const Point<2> at = vertices.col(vertices.cols() / 16);
  hand.to(at);
  ASSERT_EQ(desk.hover().over, Over::curve);
  one_step([&] { hand.click(at, {}, 2); });
  EXPECT_EQ(desk.editor().size(), 6 + placed) << "a double click with the select tool";
  // From there the curve is pulled.
  one_step([&] { hand.drag(at, 1.3 * at); });
  EXPECT_LE(std::abs(desk.shape().function->value(1.3 * at)), 1e-12);
}

TEST_F(DeskTest, ModifierKeysPlaceWithAnyToolAndMakeKinds) {
  const Held interior_keys{.shift = true, .ctrl = true}, exterior_keys{.ctrl = true, .alt = true};
  for (const K tool : {K::v, K::b, K::e, K::n, K::l, K::c, K::p, K::h}) {
    hand.key(tool);
    one_step([&] { hand.click({2, 2}, ctrl_key); });
    const Index last = desk.editor().size() - 1;
    EXPECT_EQ(desk.constraint(last).kind, ConstraintKind::boundary);
    one_step([&] { hand.click({2, 2}, interior_keys); });
    EXPECT_EQ(desk.editor().size(), last + 1);
    EXPECT_EQ(desk.constraint(last).kind, ConstraintKind::interior);
    EXPECT_EQ(desk.constraint(last).value, 1);
    one_step([&] { hand.click({2, 2}, exterior_keys); });
    EXPECT_EQ(desk.constraint(last).kind, ConstraintKind::exterior);
    EXPECT_EQ(desk.constraint(last).value, -1);
    no_step([&] { hand.click({2, 2}, exterior_keys); });
    EXPECT_THAT(desk.selection().indices(), ElementsAre(last));
    one_step([&] { hand.key(K::del); });
  }
  one_step([&] { hand.click({2, 2}, interior_keys); });
  one_step([&] { hand.click({2, -2}, exterior_keys); });
  EXPECT_EQ(desk.constraint(6).kind, ConstraintKind::exterior);
  hand.key(K::a, ctrl_key);
  one_step([&] { hand.key(K::i, ctrl_key); });
  EXPECT_EQ(all_of(desk.document(), ConstraintKind::interior).size(), 7u);
  one_step([&] { hand.key(K::e, ctrl_key); });
  one_step([&] { hand.key(K::b, ctrl_key); });
  EXPECT_EQ(all_of(desk.document(), ConstraintKind::boundary).size(), 7u);
  no_step([&] { hand.key(K::b, ctrl_key); });
}

TEST_F(DeskTest, NormalsAreGivenTurnedAndRemoved) {
  hand.key(K::n);
  const auto before = desk.shape().function;
  one_step([&] { hand.click(place(2)); });
  const NormalConstraint<2> given = *desk.constraint(2).normal;
  EXPECT_LE((given.direction + before->gradient(place(2)).normalized()).norm(), 1e-12);
  const Box<2> box(Point<2>(-2, -2), Point<2>(2, 2));
  EXPECT_LE(greatest_change<2>(*before, *desk.shape().function, box),
            100 * rounding<2>(desk.shape().report, *before, box));
  no_step([&] { hand.click(place(2)); });
  no_step([&] { hand.click(place(4)); });
  EXPECT_THAT(desk.message().text, HasSubstr("only a boundary constraint has a normal"));
  EXPECT_TRUE(desk.message().trouble);

  const auto spike = [&] { return spike_end(desk.constraint(2), 26, pixel_of_tests); };
  hand.to(spike());
  EXPECT_EQ(desk.hover().over, Over::spike);
  EXPECT_EQ(desk.hover().which, 2);
  hand.key(K::v);
  one_step([&] { hand.drag(spike(), place(2) + Point<2>(0.3, 0.4)); });
  EXPECT_LE((desk.constraint(2).normal->direction - Point<2>(0.6, 0.8)).norm(), 1e-15);
  EXPECT_EQ(desk.constraint(2).normal->value, given.value);
  EXPECT_EQ(desk.constraint(2).normal->offset, given.offset);
  one_step([&] { hand.drag(spike(), place(2) + Point<2>(0.0, 0.52), no_keys, ctrl_key); });
  EXPECT_NEAR(desk.constraint(2).normal->value, 2 * given.value, 1e-12 * std::abs(given.value))
      << "twice as long, twice the value";
  one_step([&] { hand.drag(spike(), place(2) + Point<2>(0.5, 0.05), no_keys, shift_key); });
  EXPECT_EQ(desk.constraint(2).normal->direction, Point<2>(1, 0)) << "steps of 15 degrees";
  no_step([&] {
    hand.down(spike());
    hand.to({2, 2});
    hand.key(K::escape);
  });

  hand.key(K::a, ctrl_key);
  one_step([&] { hand.key(K::n, {.shift = true, .ctrl = true}); });
  hand.key(K::n, shift_key);
  EXPECT_THAT(desk.selection().indices(), ElementsAre(0, 1, 2, 3));
  one_step([&] { hand.key(K::del, shift_key); });
  hand.key(K::n, shift_key);
  EXPECT_TRUE(desk.selection().empty());
  EXPECT_EQ(desk.editor().size(), 5);
}

TEST_F(DeskTest, TheNormalToolPlacesOneWithItsNormalAndTurnsIt) {
  hand.key(K::n);
  one_step([&] { hand.drag({2, 1}, {2, 2}); });
  ASSERT_EQ(desk.editor().size(), 6);
  EXPECT_EQ(place(5), Point<2>(2, 1));
  ASSERT_TRUE(desk.constraint(5).normal);
  EXPECT_LE((desk.constraint(5).normal->direction - Point<2>(0, 1)).norm(), 1e-15);
  no_step([&] {
    hand.down({-2, 1});
    EXPECT_TRUE(desk.constraint(6).normal);
    hand.to({-2, 2});
    hand.key(K::escape);
  });
}

TEST_F(DeskTest, LinesAndCirclesOfConstraints) {
  hand.key(K::i);
  hand.key(K::l);
  one_step([&] {
    hand.down({-2, 2});
    EXPECT_EQ(desk.preview().cols(), 0);
    hand.to({1, 2});
    EXPECT_EQ(desk.preview().cols(), 8);
    desk.handle(WheelTurned{{1, 2}, -1});
    hand.key(K::minus);
    hand.key(K::minus);
    hand.key(K::minus);
    EXPECT_EQ(desk.preview().cols(), 4);
    hand.up({1, 2});
  });
  ASSERT_EQ(desk.editor().size(), 9);
  for (Index i = 5; i < 9; ++i) {
    EXPECT_EQ(desk.constraint(i).kind, ConstraintKind::interior) << "the kind of the last placing tool";
    EXPECT_LE((place(i) - Point<2>(-2.0 + static_cast<double>(i - 5), 2)).norm(), 1e-15);
  }
  EXPECT_THAT(desk.selection().indices(), ElementsAre(5, 6, 7, 8));
  no_step([&] { hand.click({2, 2}); });
  no_step([&] {
    hand.down({-2, -2});
    hand.to({1, -2});
    hand.key(K::escape);
    hand.up({1, -2});
  });
  one_step([&] { hand.drag({-2, -2}, {1, -1.8}, no_keys, shift_key); });
  EXPECT_EQ(place(desk.editor().size() - 1).y(), -2) << "straight";

  hand.key(K::e);
  hand.key(K::c);
  desk.set_count(6);
  one_step([&] {
    hand.down({0, 0});
    hand.to({3, 0});
    hand.key(K::plus);
    hand.up({3, 0});
  });
  const Index n = desk.editor().size();
  for (Index i = n - 7; i < n; ++i) {
    EXPECT_EQ(desk.constraint(i).kind, ConstraintKind::exterior);
    EXPECT_NEAR(place(i).norm(), 3, 1e-15);
  }
  desk.set_count(7);
  no_step([&] { hand.drag({0, 0}, {3, 0}); });
  EXPECT_THAT(desk.message().text, HasSubstr("already"));
}

TEST_F(DeskTest, ACageByOneKey) {
  one_step([&] { hand.key(K::k); });
  EXPECT_EQ(all_of(desk.document(), ConstraintKind::exterior).size(), 8u);
  EXPECT_TRUE(desk.shape().current());
  no_step([&] { hand.key(K::k); });
  EXPECT_THAT(desk.message().text, HasSubstr("already"));
}

TEST_F(DeskTest, TheProfileLineIsDrawnAndMoved) {
  no_step([&] {
    hand.key(K::p);
    hand.drag({-2, 0.5}, {2, 0.5});
    ASSERT_TRUE(desk.profile());
    EXPECT_EQ(*desk.profile(), (ProfileLine{{-2, 0.5}, {2, 0.5}}));
    hand.drag({2, 0.5}, {2, 1});
    EXPECT_EQ(desk.profile()->to, Point<2>(2, 1));
    hand.key(K::v);
    hand.drag({-2, 0.5}, {-2, 1});
    EXPECT_EQ(desk.profile()->from, Point<2>(-2, 1));
    hand.drag({1.5, 1}, {1.5, 2});
    EXPECT_EQ(*desk.profile(), (ProfileLine{{-2, 2}, {2, 2}}));
    hand.down({-2, 2});
    hand.to({0, 0});
    hand.key(K::escape);
    EXPECT_EQ(*desk.profile(), (ProfileLine{{-2, 2}, {2, 2}}));
    hand.drag({2, 2}, {1.9, 1.8}, no_keys, shift_key);
    EXPECT_EQ(desk.profile()->to.y(), 2) << "along an axis";
    hand.key(K::p, shift_key);
    EXPECT_FALSE(desk.profile());
    hand.key(K::p, shift_key);
    EXPECT_TRUE(desk.profile());
  });
}

TEST_F(DeskTest, TheViewIsPannedZoomedAndFitted) {
  no_step([&] {
    const View2D view = desk.view();
    const auto centered_at = [&](const Point<2>& at) {
      EXPECT_LE((desk.view().center() - at).norm(), 1e-12);
      desk.view() = view;
    };
    // The hand tells scene points of the view as it was, so a drag in one move is exact.
    const auto pan = [&](Held held, PointerButton button) {
      hand.down({3, 2}, held, button);
      hand.to({2, 1.5}, held);
      EXPECT_EQ(desk.gesture(), Gesture::pan);
      desk.handle(PointerUp{*desk.cursor(), button, held});
      centered_at({1, 0.5});
    };
    pan({}, PointerButton::middle);
    pan({}, PointerButton::right);
    pan(shift_key, PointerButton::left);
    hand.key(K::h);
    pan({}, PointerButton::left);
    hand.key(K::b);
    desk.handle(KeyDown{K::space});
    desk.handle(KeyDown{K::space, {}, true});
    EXPECT_EQ(desk.tool(), Tool::pan);
    pan({}, PointerButton::left);
    desk.handle(KeyUp{K::space});
    EXPECT_EQ(desk.tool(), Tool::boundary);
    hand.key(K::v);
    hand.down({3, 2}, {}, PointerButton::middle);
    hand.to({2, 1.5});
    hand.key(K::escape);
    centered_at({0, 0});

    desk.handle(WheelTurned{{1, 1}, 4});
    EXPECT_NEAR(desk.view().pixel(), 0.005, 1e-17);
    centered_at({0.5, 0.5});
    desk.handle(WheelTurned{{1, 1}, 1, 0, shift_key});
    EXPECT_NEAR(desk.view().center().x(), -0.4, 1e-15);
    desk.view() = view;
    hand.click({-3, 2}, {}, 2);
    centered_at({-3, 2});
    hand.key(K::plus);
    EXPECT_NEAR(desk.view().pixel(), 0.008, 1e-17);
    hand.key(K::minus);
    centered_at({0, 0});
    hand.key(K::right);
    centered_at({0.4, 0});
    hand.key(K::up, shift_key);
    centered_at({0, 4});
    desk.view().pan({100, 100});
    hand.key(K::f);
    for (Index i = 0; i < 5; ++i) EXPECT_TRUE(desk.view().scene().contains(place(i)));
    EXPECT_LT(desk.view().scene().sizes().minCoeff(), 4);
  });
}

TEST_F(DeskTest, KeysNudgeAndAHeldKeyIsOneStep) {
  hand.click(place(2));
  one_step([&] { hand.key(K::left); });
  EXPECT_LE((place(2) - Point<2>(1 - pixel_of_tests, 0.1)).norm(), 1e-15);
  one_step([&] {
    desk.handle(KeyDown{K::up, shift_key});
    for (int i = 0; i < 9; ++i) desk.handle(KeyDown{K::up, shift_key, true});
    EXPECT_TRUE(desk.editor().in_gesture());
    desk.handle(KeyUp{K::up});
  });
  EXPECT_NEAR(place(2).y(), 1.1, 1e-12) << "ten times ten pixels";
  one_step([&] { desk.perform(C::nudge_right); });
  EXPECT_LE((place(2) - Point<2>(1, 1.1)).norm(), 1e-12);
  hand.key(K::g);
  one_step([&] { hand.key(K::down); });
  EXPECT_NEAR(place(2).y(), 0.6, 1e-12);
  no_step([&] {
    desk.handle(KeyDown{K::down});
    hand.key(K::escape);
  });
  // A press ends a nudge whose key was not let go.
  desk.handle(KeyDown{K::down});
  hand.click({3, 2});
  EXPECT_FALSE(desk.editor().in_gesture());
}

TEST_F(DeskTest, DeleteDuplicateAndTheSelectionAfterwards) {
  hand.click(place(1));
  hand.click(place(3), shift_key);
  one_step([&] { hand.key(K::d, ctrl_key); });
  EXPECT_THAT(desk.selection().indices(), ElementsAre(5, 6));
  EXPECT_LE((place(5) - place(1) - 12 * pixel_of_tests * Point<2>(1, -1)).norm(), 1e-15);
  desk.select({0, 4, 99, -1});
  one_step([&] { hand.key(K::del); });
  EXPECT_EQ(desk.editor().size(), 5);
  EXPECT_TRUE(desk.selection().empty());
  hand.key(K::z, ctrl_key);
  EXPECT_THAT(desk.selection().indices(), ElementsAre(0, 4)) << "what came back";
  no_step([&] {
    hand.key(K::escape);
    hand.key(K::del);
    hand.key(K::d, ctrl_key);
  });
}

TEST_F(DeskTest, ConstraintsAreCopiedAsJson) {
  desk.select({2, 4});
  no_step([&] { hand.key(K::c, ctrl_key); });
  one_step([&] { hand.key(K::v, ctrl_key); });
  EXPECT_THAT(desk.selection().indices(), ElementsAre(5, 6));
  EXPECT_EQ(desk.constraint(6).kind, ConstraintKind::interior);
  const Point<2> step = place(5) - place(2);
  EXPECT_NEAR(step.norm(), 12 * std::sqrt(2) * pixel_of_tests, 1e-15) << "beside the original";
  one_step([&] { hand.key(K::v, ctrl_key); });
  EXPECT_LE((place(7) - place(2) - 2 * step).norm(), 1e-15) << "and beside the first copy";
  desk.select({5, 6, 7, 8});
  one_step([&] { hand.key(K::x, ctrl_key); });
  one_step([&] { hand.key(K::v, ctrl_key); });
  EXPECT_EQ(desk.editor().size(), 9);
}

TEST_F(DeskTest, TheSceneIsCopiedAndPastedAndForeignTextIsRefused) {
  std::string text;
  DeskOptions options;
  options.clipboard = {[&](const std::string& t) { text = t; }, [&] { return text; }};
  options.most_constraints = 10;
  Desk other({}, options);
  other.start(small_scene());
  TestHand there{other};
  there.key(K::c, {.shift = true, .ctrl = true});
  EXPECT_EQ(text, start);
  there.key(K::a, ctrl_key);
  there.key(K::del);
  EXPECT_EQ(other.editor().size(), 0);
  there.key(K::v, {.shift = true, .ctrl = true});
  EXPECT_EQ(bits_of(other.document()), start);
  EXPECT_TRUE(other.selection().empty());
  EXPECT_EQ(other.editor().undo_size(), 2u);
  there.key(K::z, ctrl_key);
  EXPECT_EQ(other.editor().size(), 0);
  there.key(K::z, ctrl_key);
  EXPECT_EQ(bits_of(other.document()), start);

  const std::string whole = bits_of(other.document());
  for (const char* foreign :
       {"", "hello", "{}", "[1, 2]", R"({"seesaw": 1, "dimension": 3, "constraints": []})",
        R"({"seesaw": 1, "dimension": 2, "constraints": [{"kind": "boundary"}]})",
        R"({"seesaw": 1, "dimension": 2, "constraints": []})"}) {
    text = foreign;
    const auto number = other.message().number;
    there.key(K::v, ctrl_key);
    EXPECT_TRUE(other.message().trouble) << foreign;
    EXPECT_GT(other.message().number, number) << foreign;
    EXPECT_EQ(bits_of(other.document()), whole);
  }
  Document<2> large;
  for (int i = 0; i < 11; ++i) large.constraints.push_back({boundary<2>({0.1 * i, 3})});
  text = bits_of(large);
  EXPECT_FALSE(other.paste(text));
  EXPECT_FALSE(other.paste_scene(text));
  EXPECT_THAT(other.message().text, HasSubstr("11 constraints; up to 10 can be edited"));
  EXPECT_EQ(bits_of(other.document()), whole);
}

TEST_F(DeskTest, TheLeverIsOneStep) {
  hand.click(place(4));
  one_step([&] {
    for (double value = 1; value <= 3; value += 0.25) EXPECT_TRUE(desk.slide(SetValue{{4}, value}));
    EXPECT_NEAR(desk.shape().function->value(place(4)), 3, 1e-12) << "live";
    desk.let_go();
  });
  EXPECT_EQ(desk.constraint(4).value, 3);
  no_step([&] {
    desk.slide(SetValue{{4}, 2});
    hand.key(K::escape);
  });
  no_step([&] {
    EXPECT_FALSE(desk.slide(SetValue{{4}, -2}));
    EXPECT_THAT(desk.message().text, HasSubstr("expected a number above 0"));
    desk.let_go();
  });
  one_step([&] {
    desk.handle(KeyDown{K::right_bracket});
    desk.handle(KeyDown{K::right_bracket, {}, true});
    desk.handle(KeyUp{K::right_bracket});
  });
  EXPECT_NEAR(desk.constraint(4).value, 3 * 1.21, 1e-12);
  one_step([&] { hand.key(K::left_bracket); });
  EXPECT_NEAR(desk.constraint(4).value, 3 * 1.1, 1e-12);
  one_step([&] {
    desk.slide(SetSmoothing{0.1});
    desk.slide(SetSmoothing{0.2});
    desk.let_go();
  });
}

TEST_F(DeskTest, FieldsSetExactNumbers) {
  one_step([&] { EXPECT_TRUE(desk.apply(MoveTo<2>{2, {1.0 / 3, -0.125}})); });
  EXPECT_EQ(place(2), Point<2>(1.0 / 3, -0.125));
  one_step([&] { EXPECT_TRUE(desk.apply(SetValue{{4}, 0.3})); });
  one_step([&] { EXPECT_TRUE(desk.apply(SetKind{{2}, ConstraintKind::exterior, -0.5})); });
  one_step([&] { EXPECT_TRUE(desk.apply(SetKernel{Kernel::cubic})); });
  no_step([&] { EXPECT_FALSE(desk.apply(MoveTo<2>{2, {NAN, 0}})); });
  no_step([&] { EXPECT_FALSE(desk.apply(Delete{{17}})); });
  EXPECT_THAT(desk.message().text, HasSubstr("constraint 17 does not exist"));
}

TEST_F(DeskTest, CulpritsAreSelectedAndTheLastGoodCurveStays) {
  const auto good = desk.shape().function;
  hand.key(K::u);
  EXPECT_TRUE(desk.selection().empty());
  hand.drag(place(4), place(2));
  ASSERT_TRUE(desk.shape().impossible);
  EXPECT_NE(desk.shape().function, nullptr);
  hand.key(K::escape);
  hand.key(K::u);
  EXPECT_THAT(desk.selection().indices(), ElementsAre(2, 4));
  hand.key(K::z, ctrl_key);
  EXPECT_FALSE(desk.shape().impossible);
  EXPECT_EQ(bits_of(desk.document()), start);
  EXPECT_NE(good, nullptr);
}

TEST_F(DeskTest, BeforeAndAfterAndAnotherKernel) {
  no_step([&] {
    EXPECT_EQ(desk.other(), nullptr);
    hand.key(K::o);
    EXPECT_TRUE(desk.message().trouble) << "nothing is remembered yet";
    hand.key(K::m);
    hand.key(K::o);
  });
  EXPECT_EQ(desk.other(), desk.shape().function.get());
  EXPECT_EQ(desk.other_name(), "before");
  const Interpolant<2>* before = desk.other();
  hand.drag(place(4), {0.2, 0.1});
  EXPECT_EQ(desk.other(), before);
  EXPECT_NE(desk.other(), desk.shape().function.get());
  hand.key(K::o);
  EXPECT_EQ(desk.other(), nullptr);
  std::vector<std::string> names;
  for (int i = 0; i < 3; ++i) {
    hand.key(K::o, shift_key);
    names.push_back(desk.other_name());
    if (desk.other()) {
      EXPECT_NE(desk.other()->kernel(), desk.document().kernel);
      EXPECT_EQ(std::string(name_of(desk.other()->kernel())), desk.other_name());
      EXPECT_NEAR(desk.other()->value(place(4)), 1, 1e-9) << "it follows the document";
      hand.key(K::right);
      EXPECT_NEAR(desk.other()->value(place(4)), 1, 1e-9);
    }
  }
  EXPECT_EQ(names.back(), "");
  EXPECT_NE(names[0], names[1]);
}

TEST_F(DeskTest, WhatOnlyAProgramCanDoComesBack) {
  EXPECT_EQ(hand.key(K::s, ctrl_key), C::save);
  EXPECT_EQ(hand.key(K::f1), C::help);
  EXPECT_EQ(hand.key(K::w), C::toggle_weights);
  EXPECT_EQ(hand.key(K::b), std::nullopt);
  EXPECT_EQ(hand.key(K::j), std::nullopt);
  hand.key(K::v);
  EXPECT_EQ(hand.click(place(2), {}, 2), C::edit_values);
  EXPECT_EQ(desk.perform(C::quit), C::quit);
  EXPECT_EQ(desk.perform(C::toggle_field), std::nullopt);
}

TEST_F(DeskTest, WhatIsShownIsSavedButNotUndone) {
  no_step([&] {
    for (const K key : {K::digit1, K::digit2, K::digit3, K::digit4, K::digit5, K::digit6, K::digit7})
      hand.key(key);
  });
  const Display<2> defaults;
  for (const auto& each : display_switches<2>)
    EXPECT_EQ(desk.to_save().display.*each.member, !(defaults.*each.member)) << each.key;
  EXPECT_TRUE(desk.unsaved());
  hand.to(place(2));
  EXPECT_EQ(desk.hover().over, Over::curve) << "hidden constraints are not grabbed";
}

TEST_F(DeskTest, AScaleMakesEverythingLarger) {
  const Point<2> beside = place(2) + Point<2>(0.15, 0);
  hand.to(beside);
  EXPECT_EQ(desk.hover().over, Over::nothing);
  desk.set_scale(2);
  EXPECT_EQ(desk.hover().which, 2);
}

TEST_F(DeskTest, ASessionIsRecordedAndReplayed) {
  EXPECT_FALSE(desk.stop_recording());
  desk.start_recording();
  EXPECT_TRUE(desk.recording());
  hand.key(K::b);
  hand.drag({2, 1}, {2, 2});
  hand.key(K::k);
  hand.key(K::z, ctrl_key);
  const auto session = desk.stop_recording();
  ASSERT_TRUE(session);
  ReplayOptions<2> options;
  options.editor.solve_at_once = false;
  EXPECT_EQ(bits_of(replay(*session, options).document()), bits_of(desk.document()));
  desk.start_recording();
  hand.drag(place(0), {-2, 0});
  const std::string end = bits_of(desk.document());
  desk.start();
  EXPECT_FALSE(desk.recording());
  const auto second = desk.stop_recording();
  ASSERT_TRUE(second) << "another document ends it; nothing is lost";
  EXPECT_EQ(bits_of(replay(*second, options).document()), end);

  // Again, a command at a time, before an audience that interferes.
  Desk shown(small_scene());
  for (const RecordedCommand<2>& each : session->commands) EXPECT_TRUE(shown.do_again(each.command));
  EXPECT_EQ(bits_of(shown.document()), bits_of(replay(*session, options).document()));
  EXPECT_FALSE(shown.editor().in_gesture());
  shown.do_again(BeginGesture{});
  shown.do_again(Action<2>(Move<2>{{0}, {1, 0}}));
  TestHand{shown}.click({3, 2});
  EXPECT_TRUE(shown.do_again(Action<2>(Move<2>{{0}, {1, 0}})));
  EXPECT_TRUE(shown.do_again(EndGesture{}));
  EXPECT_FALSE(shown.do_again(Action<2>(Delete{{99}})));
  EXPECT_FALSE(shown.editor().in_gesture());
}

TEST_F(DeskTest, AReleaseFromNowhereStillLetsGo) {
  hand.down(place(2));
  hand.to({2, 2});
  hand.up({NAN, INFINITY});
  EXPECT_EQ(desk.gesture(), Gesture::none);
  EXPECT_EQ(place(2), Point<2>(2, 2));
}

TEST_F(DeskTest, ASliderAndAKeyAreTwoSteps) {
  hand.click(place(4));
  desk.slide(SetValue{{4}, 2});
  hand.key(K::left);
  EXPECT_EQ(desk.editor().undo_size(), 2u);
  desk.slide(SetValue{{4}, 3});
  hand.key(K::z, ctrl_key);
  EXPECT_EQ(desk.constraint(4).value, 2);
  desk.slide(Action<2>(Add<2>{{{boundary<2>({3, 3})}}}));
  EXPECT_THAT(desk.selection().indices(), ElementsAre(5));
  desk.cancel();
  EXPECT_TRUE(desk.selection().empty());
}

}  // namespace
}  // namespace seesaw
