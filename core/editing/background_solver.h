// Solving without letting a window wait: what is quick is done at once, what is not on another thread.
//
//     BackgroundSolver<2> solver({.arrived = [&] { window.wake(); }});
//     Editor<2> editor(document, {.solver = solver});       // copies of a solver are the same solver
//     ... each frame:
//     if (solver.poll()) editor.solve_again();
//     if (editor.shape().pending) ...                       // say so; the picture is that of a moment ago
//
// Turk & O'Brien 2002, section 5, solve after every change. A border of the last factorization takes 3 ms at
// 3000 rows (core/rbf/edit_session.h), but its first factorization 0.3 s, as does another kernel or
// smoothing, or a change of many constraints; and a window that stands still for a tenth of a second is felt.
// So a full fit of more than `at_once` rows is begun elsewhere, and the shape is *pending*. There is never
// more than one under way. What has changed when it arrives becomes its border, where a border can say it;
// otherwise the next full fit begins, of the constraints as they are then, and its elder is shown meanwhile.
// So a slider that is dragged is followed as quickly as the computer can.
//
// The answer does not depend on any of this: once nothing is under way the function is that of the present
// constraints, fit()'s to some 1e-9 of the values, or the set is impossible for fit()'s reason and culprits,
// wherever that was found out.
//
// Before it: an Editor asks. After it: core/editing/shape.h, a Shape that may be pending.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "core/editing/shape.h"
#include "core/rbf/edit_session.h"

namespace seesaw {

struct BackgroundOptions {
  /// Full fits of up to so many rows are made when they are asked for: 10 ms at 700.
  Index at_once = 700;
  /// Of the sessions; its largest_full is at_once.
  EditOptions edit = {};
  /// Called from another thread when poll() has something to do: Window::wake. It must not throw, nor call
  /// the solver, nor wait for the thread that does; and must live as long as the solver has work.
  std::function<void()> arrived = {};
};

/// A Solver<Dim>. One thread calls it and its functions; copies share everything. The last copy to go waits
/// for the fit that is under way: a second at 5000 rows.
template <int Dim>
class BackgroundSolver {
 public:
  explicit BackgroundSolver(BackgroundOptions options = {});

  /// Throws StillSolving where the answer is under way, ConstraintError as fit() does.
  Fit<Dim> operator()(const Constraints<Dim>& constraints, const FitOptions& options) const;

  /// To be called every frame, and costs nothing where nothing has arrived; where something has, about what
  /// an edit costs. True where the solver then has another answer: Editor::solve_again.
  bool poll() const;
  /// True from where a fit begins to the poll() that takes it in.
  bool busy() const;
  /// Until nothing is under way, polling. For tests and scripts. True where a poll() was.
  bool wait() const;

  /// By how much the function had changed when it was last put on a fresh factorization: what editing without
  /// refitting had cost, at most, in units of the values. None before the first time.
  std::optional<double> last_difference() const;
  /// How the last answer came about; null before the first.
  const EditSession<Dim>* session() const;

 private:
  struct State;
  std::shared_ptr<State> state_;
};

extern template class BackgroundSolver<2>;
extern template class BackgroundSolver<3>;

}  // namespace seesaw
