// What is selected and dragged, and that one undo takes all of it back.
#include "core/editing/desk.h"

#include <gmock/gmock.h>

#include "tests/core/editing/desk_at_hand.h"

namespace seesaw {
namespace {

using ::testing::ElementsAre;
using K = DeskKey;

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

}  // namespace
}  // namespace seesaw
