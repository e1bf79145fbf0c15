// F1: every key and gesture, from the table by which the desk acts.
//
// Before it: core/editing/desk_bindings.h. After it: nothing.
#pragma once

namespace seesaw {

class HelpDialog {
 public:
  /// Opens at the next frame().
  void ask();
  /// Each frame, outside of all panels; the window's size.
  void frame(double width, double height);
};

}  // namespace seesaw
