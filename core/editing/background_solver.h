// Solving without letting a window wait: what is quick is done at once, what is not on another thread.
//
//     BackgroundSolver<2> solver({.arrived = [&] { window.wake(); }});
//     Editor<2> editor(document, {.solver = solver});       // copies of a solver are the same solver
//     ... each frame:
//     if (solver.poll()) editor.solve_again();
//     if (editor.shape().pending) ...                       // say so; the picture is that of a moment ago
//
// Turk & O'Brien 2002, section 5, solve after every change. A border of the last factorization takes 3 ms at
// 3000 rows (core/rbf/edit_session.h), but its first factorization 0.2 s, as does another kernel or
// smoothing; to border a hundred constraints that are dragged together takes half as long; and a window that
// stands still for a tenth of a second is felt. So what would take longer than some 20 ms is begun elsewhere,
// and the shape is *pending*. There is never more than one such work under way
// (core/editing/background_session.h):
//
//   a full fit    the session that there is goes on answering what it can
//   a border      the session itself goes to the other thread, and comes back with the answer
//   a refit       of a session whose border has grown; it has been told of all edits when it arrives, and
//                 takes the session's place at the cost of an edit. A question that needs the other thread
//                 goes before it
//
// What is asked while one is under way waits for it, the last question for all, and its elder is shown
// meanwhile: a slider that is dragged is followed as quickly as the computer can. What nobody waits for any
// more, as another document was opened or the change undone, is cancelled.
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
  /// Multiplications of a border that is made when it is asked for (core/rbf/edit_session.h, Budget): eleven
  /// solves at 3000 rows, four at 5000, one at 10,000.
  double border_at_once = 2e8;
  /// Of the sessions.
  EditOptions edit = {};
  /// Called from another thread when poll() has something to do, and now and then when fraction() has grown:
  /// Window::wake. It must not throw, nor call
  /// the solver, nor wait for the thread that does; and must live as long as the solver has work.
  std::function<void()> arrived = {};
};

/// A Solver<Dim>. One thread calls it and its functions; copies share everything. The last copy to go cancels
/// what is under way, which takes some 10 ms.
template <int Dim>
class BackgroundSolver {
 public:
  explicit BackgroundSolver(BackgroundOptions options = {});

  /// Throws StillSolving where the answer is under way, ConstraintError as fit() does.
  Fit<Dim> operator()(const Constraints<Dim>& constraints, const FitOptions& options) const;

  /// To be called every frame, and costs nothing where nothing has arrived; where something has, about what
  /// an edit costs. True where the solver then has another answer: Editor::solve_again.
  bool poll() const;
  /// True from where work begins elsewhere to the poll() that takes it in.
  bool busy() const;
  /// How much of that is done, 0 to 1; none where nobody waits for it.
  std::optional<double> fraction() const;
  /// Until nothing is under way, polling. For tests and scripts. True where a poll() was.
  bool wait() const;

  /// By how much the function had changed when it was last put on a fresh factorization: what editing without
  /// refitting had cost, at most, in units of the values. None before the first time.
  std::optional<double> last_difference() const;
  /// How the last answer came about; null before the first, and while the session is on the other thread.
  const EditSession<Dim>* session() const;

 private:
  struct State;
  std::shared_ptr<State> state_;
};

extern template class BackgroundSolver<2>;
extern template class BackgroundSolver<3>;

}  // namespace seesaw
