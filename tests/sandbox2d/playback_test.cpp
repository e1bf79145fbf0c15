#include "sandbox2d/playback.h"

#include <gtest/gtest.h>

#include "sandbox2d/gallery.h"

namespace seesaw {
namespace {

Session<2> a_drag_and_a_lever() {
  Desk desk(read_scene(gallery().front()));
  desk.start_recording();
  desk.view().resize(800, 600);
  const Point<2> at = desk.constraint(0).at;
  desk.handle(PointerDown{at});
  for (int i = 1; i <= 20; ++i) desk.handle(PointerMoved{at + Point<2>(0.01 * i, 0.005 * i)});
  desk.handle(PointerUp{at + Point<2>(0.2, 0.1)});
  for (int i = 1; i <= 10; ++i) desk.slide(SetValue{{4}, 1 + 0.1 * i});
  desk.let_go();
  desk.perform(DeskCommand::undo);
  return *desk.stop_recording();
}

TEST(Playback, DoesAgainWhatWasRecordedAndNotFasterThanAHand) {
  const Session<2> session = a_drag_and_a_lever();
  ASSERT_GT(session.commands.size(), 20u);
  Desk desk;
  Playback playback;
  playback.start(session, desk, 10.0);
  EXPECT_TRUE(desk.document() == session.start);
  double now = 10.0;
  int steps_with_change = 0;
  std::uint64_t before = desk.revision();
  for (; playback.running() && now < 20; now += 1.0 / 60) {
    playback.step(desk, now);
    steps_with_change += desk.revision() != before;
    before = desk.revision();
  }
  EXPECT_FALSE(playback.running());
  EXPECT_GT(now - 10.0, static_cast<double>(session.commands.size()) / 30);
  EXPECT_GT(steps_with_change, 20) << "one sees it move";
  EXPECT_EQ(desk.constraint(0).at, Point<2>(session.start.constraints[0].constraint.at + Point<2>(0.2, 0.1)));
  EXPECT_EQ(desk.constraint(4).value, 1) << "the lever was undone";
  desk.perform(DeskCommand::undo);
  EXPECT_TRUE(desk.document() == session.start) << "and so can the drag be";
}

TEST(Playback, StopsInTheMiddleOfAGestureAsOneStepToUndo) {
  const Session<2> session = a_drag_and_a_lever();
  Desk desk;
  Playback playback;
  playback.start(session, desk, 0);
  for (int i = 0; i < 6; ++i) playback.step(desk, 1.05 + i / 30.0);
  ASSERT_TRUE(playback.running());
  EXPECT_FALSE(desk.document() == session.start);
  playback.stop(desk);
  EXPECT_FALSE(playback.running());
  desk.perform(DeskCommand::undo);
  EXPECT_TRUE(desk.document() == session.start);
}

}  // namespace
}  // namespace seesaw
