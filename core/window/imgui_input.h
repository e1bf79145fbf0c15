// Inside core/window: a frame's events as Dear ImGui wants to hear them, and who they belong to.
//
// Dear ImGui's own SDL backend asks SDL where the mouse is, so a scripted mouse would press a slider and
// never move it. This glue tells it what our events say and nothing else. Version 1.87 (18700) changed how
// it is told: that is the one switch.
#pragma once

#include <array>

#include "core/window/input.h"

namespace seesaw::detail {

/// Tells Dear ImGui how keys are numbered; once a context.
void start_imgui_input();
/// Tells it of the event, before its NewFrame.
void tell_imgui(const InputEvent& event);

/// Whether the key, one that Dear ImGui knows, went down in this frame, or repeats.
bool pressed_now(Key key, bool repeat = false);

/// Decides, after NewFrame, whether an event is the user interface's: a press, by what is under the pointer;
/// a release and the moves of a drag, by who got the press; keys and text, by whether something is typed.
class InputRouter {
 public:
  bool for_ui(const InputEvent& event);

 private:
  enum class Owner { nobody, ui, program };
  std::array<Owner, 3> owners_ = {};
  bool any(Owner owner) const;
};

}  // namespace seesaw::detail
