// The numbers of a constraint, to be typed exactly: place, kind, value, normal.
//
// Before it: Enter, or a double click on a constraint. After it: one step to undo, when it is said to be
// right.
#pragma once

#include "core/editing/desk.h"

namespace seesaw {

class ValuesDialog {
 public:
  /// For the first constraint of the selection; says so where there is none. Opens at the next frame().
  void ask(Desk& desk);
  /// Each frame, outside of all panels.
  void frame(Desk& desk);

 private:
  void read(const Desk& desk);
  bool write(Desk& desk);

  Index which_ = -1;
  Constraint<2> c_;
  bool has_normal_ = false;
  NormalConstraint<2> normal_;
  double degrees_ = 0;
  std::string trouble_;
  bool fresh_ = false;
  bool asked_ = false;
};

}  // namespace seesaw
