// A desk with a small scene on it, and a hand; and what every step of it must keep.
#pragma once

#include <gtest/gtest.h>

#include "tests/core/editing/documents.h"
#include "tests/core/editing/hand.h"

namespace seesaw {

inline constexpr double pixel_of_tests = 0.01;

/// Fig. 1 in spirit: 0 to 3 boundary, 4 interior. Far from all of them: (3, 2) and (-3, -2).
inline Document<2> small_scene() {
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
    hand.key(DeskKey::z, ctrl_key);
    ASSERT_EQ(bits_of(desk.document()), before);
    hand.key(DeskKey::y, ctrl_key);
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

}  // namespace seesaw
