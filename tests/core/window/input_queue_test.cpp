#include "core/window/input_queue.h"

#include <gtest/gtest.h>

namespace seesaw {
namespace {

std::vector<std::size_t> frame_sizes(InputQueue& queue) {
  std::vector<std::size_t> sizes;
  while (!queue.empty()) sizes.push_back(queue.next_frame().size());
  return sizes;
}

TEST(InputQueue, APressAndReleaseAreTwoFrames) {
  InputQueue queue;
  queue.push(MouseMoved{});
  queue.push(MousePressed{});
  queue.push(MouseReleased{});
  queue.push(MousePressed{.clicks = 2});
  EXPECT_EQ(frame_sizes(queue), (std::vector<std::size_t>{2, 1, 1}));
  queue.push(KeyPressed{Key::a});
  queue.push(KeyPressed{Key::b});
  queue.push(KeyPressed{.key = Key::b, .repeat = true});
  queue.push(KeyReleased{Key::a});
  EXPECT_EQ(frame_sizes(queue), (std::vector<std::size_t>{3, 1}));
}

TEST(InputQueue, AMoveAfterAPressWaitsAndMovesInARowAreOne) {
  InputQueue queue;
  for (int x = 0; x <= 100; ++x) queue.push(MouseMoved{{x, 0}});
  queue.push(MousePressed{{100, 0}});
  for (int x = 100; x <= 200; ++x) queue.push(MouseMoved{{x, 0}});
  queue.push(MouseMoved{{300, 0}, {.shift = true}});
  const auto first = queue.next_frame(), second = queue.next_frame();
  ASSERT_EQ(first.size(), 2u);
  EXPECT_EQ(std::get<MouseMoved>(first[0]).at.x(), 100);
  // Another modifier is another move: a snapped one, perhaps.
  ASSERT_EQ(second.size(), 2u);
  EXPECT_EQ(std::get<MouseMoved>(second[0]).at.x(), 200);
  EXPECT_EQ(std::get<MouseMoved>(second[1]).at.x(), 300);
  EXPECT_TRUE(queue.next_frame().empty());
}

// Whatever a hand does, nothing but moves that were overtaken is lost, the order is kept, and in no frame
// does a button or key change twice.
TEST(InputQueue, NothingIsLostAndTheOrderIsKept) {
  InputQueue queue;
  unsigned state = 1;
  const auto random = [&](unsigned n) { return ((state = state * 1664525u + 1013904223u) >> 16) % n; };
  std::vector<int> pushed, seen;
  for (int i = 0; i < 3000; ++i) {
    const auto button = static_cast<MouseButton>(random(3));
    switch (random(4)) {
      case 0:
        queue.push(MouseMoved{{i, 0}});
        continue;
      case 1:
        queue.push(MousePressed{{i, 0}, button});
        break;
      case 2:
        queue.push(MouseReleased{{i, 0}, button});
        break;
      default:
        queue.push(WheelMoved{{i, 0}});
    }
    pushed.push_back(i);
  }
  double last = -1;
  while (!queue.empty()) {
    int changes[3] = {};
    const auto frame = queue.next_frame();
    ASSERT_FALSE(frame.empty());
    for (const InputEvent& event : frame) {
      const auto* pressed = std::get_if<MousePressed>(&event);
      const auto* released = std::get_if<MouseReleased>(&event);
      const auto* moved = std::get_if<MouseMoved>(&event);
      const auto* wheel = std::get_if<WheelMoved>(&event);
      if (pressed) {
        EXPECT_EQ(++changes[static_cast<int>(pressed->button)], 1);
      }
      if (released) {
        EXPECT_EQ(++changes[static_cast<int>(released->button)], 1);
      }
      const double x = pressed    ? pressed->at.x()
                       : released ? released->at.x()
                       : moved    ? moved->at.x()
                                  : wheel->at.x();
      EXPECT_GT(x, last);
      last = x;
      if (!moved) seen.push_back(static_cast<int>(x));
    }
  }
  EXPECT_EQ(seen, pushed);
}

}  // namespace
}  // namespace seesaw
