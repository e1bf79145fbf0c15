// Cuts a stream of events into frames, so that nothing a hand does between two frames is lost.
//
// A user interface that is drawn anew each frame knows a button by its state: is it down now, was it down
// before? A press and release within one frame would never have happened, and a press at one place followed
// by a move would seem to have been at another. So a frame ends before an event that the frame cannot tell
// from those before it,
//
//     a button or key that changes a second time,   a move after a button has changed,
//
// and the rest waits for the next. Moves in a row become one, the last: whoever drags wants to know where
// the pointer is, and a mouse tells it a thousand times a second. The program is given the same frames, so
// that it and the user interface never disagree.
//
// Before it: sdl_input.h. After it: window.cpp, which shows a frame's events to the user interface and then
// to the program.
#pragma once

#include <deque>
#include <vector>

#include "core/window/input.h"

namespace seesaw {

class InputQueue {
 public:
  void push(InputEvent event) { waiting_.push_back(std::move(event)); }
  bool empty() const { return waiting_.empty(); }

  /// The next frame's events, in order; empty where none wait.
  std::vector<InputEvent> next_frame();

 private:
  std::deque<InputEvent> waiting_;
};

}  // namespace seesaw
