// The panel at the right: what the constraints ask for, what the function does, what is shown. Every number
// is live, and every number that can be typed or dragged changes the document as a hand on the canvas would,
// one step to undo each.
//
// Before it: a Desk, and what a frame was measured to take. After it: nothing; it acts on the desk.
#pragma once

#include <functional>
#include <optional>

#include "core/contour/contour.h"
#include "core/editing/desk.h"

namespace seesaw {

/// What the desk itself does not know.
struct LiveNumbers {
  Contour curve;  ///< of the picture that is shown; its polylines are not looked at
  /// Nothing for scripts, whose pictures are the same in every run.
  std::optional<double> solve_seconds;
  std::optional<double> draw_seconds;  ///< of the scene's picture
  /// By how much editing without refitting was off when a fresh fit came last; units of the values.
  std::optional<double> refit_difference;
  /// A fit is being made in the background.
  bool solving = false;
};

/// What is shown besides what Display has.
struct Shown {
  bool weights = false;
  bool plate = false;
};

class SidePanel {
 public:
  /// `act` does a command, wherever it belongs.
  void draw(const Rect& place, Desk& desk, Shown& shown, const LiveNumbers& numbers,
            const std::function<void(DeskCommand)>& act);

 private:
  void function(Desk& desk, const std::function<void(DeskCommand)>& act);
  void selection(Desk& desk, const std::function<void(DeskCommand)>& act);
  void one_constraint(Desk& desk, Index which, const std::function<void(DeskCommand)>& act);
  void several(Desk& desk, const std::function<void(DeskCommand)>& act);
  void lever(Desk& desk, ConstraintKind kind);
  void normal(Desk& desk, Index which);
  void their_normals(Desk& desk);

  double reach_[2] = {3, 3};  // the sliders' far ends, interior and exterior, kept while they are dragged
};

/// Constraints by kind, the function's report, the curve's measures, times.
void draw_numbers(Desk& desk, const LiveNumbers& numbers);
/// Switches for everything that can be seen.
void draw_switches(Desk& desk, Shown& shown, const std::function<void(DeskCommand)>& act);

}  // namespace seesaw
