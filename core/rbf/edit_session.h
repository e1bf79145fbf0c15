// Editing without refitting: the function after every small change of the constraints, a hundred times sooner
// than a fit.
//
// Before it: a document's constraints, after every action. After it: an Interpolant like any other.
//
//     EditSession<2> session(shape);                     // a full fit
//     shape[3].at = {0.9, 0.2};
//     const Fit<2> moved = session.update(shape);        // two solves instead of a factorization
//     shape[3].at = {0.9, 0.3};
//     session.update(shape);                             // one: that row has been taken out already
//     session.last().full;                               // EditReport::Full::no
//
// A full fit takes N^3 / 3 multiplications, N the number of rows (a constraint with a normal has two). An
// edit borders the matrix of the last full fit (core/rbf/border.h has the equations): 2 N^2 multiplications
// for each row that has come or gone since the last update, and the same once if values have changed; all of
// these in one pass over the matrix, whose N^2 / 2 numbers have to come from memory and are what an edit
// waits for. Rows are compared, not edits: what the user did, or undid, and in which order, does not matter.
//
// A border costs a little with every row, and digits. So after some tens of rows a fresh fit is due. It can
// be had without a pause: a session of the present constraints is begun on another thread, and what has been
// edited meanwhile becomes its border.
//
//     if (session.wants_refit() && !refit.valid())
//       refit = std::async(std::launch::async, [c = session.constraints()] { return EditSession<2>(c); });
//     if (refit.valid() && refit.wait_for(0s) == std::future_status::ready)
//       residual = session.adopt(refit.get()).difference;
//
// How exact is it? Solutions of triangular systems have small residuals, so the bordered function misses its
// constraints by rounding, if by more than a refined fit. That is not believed but measured, on the function
// itself at rows that changed and at a sample of the others; where it misses by more than `accuracy` it is
// refined with its residual at all rows, and where that does not help, or where rows are so near to each
// other that only a factorization can tell whether they can be told apart, there is a full fit. So the
// errors, too, are those of fit().
//
// Whoever cannot wait says how much may be done (Budget). What would be more is not begun, and OverBudget
// says so; a session that has gone to another thread does it there, and comes back. That is what
// core/editing/background_solver.h does.
#pragma once

#include <limits>
#include <memory>
#include <string_view>

#include "core/rbf/border.h"

namespace seesaw {

struct EditOptions {
  /// With fewer rows than this every update is a full fit: it is as quick.
  Index smallest = 60;
  /// Rows removed and added since the last full fit beyond which an update is a full fit. Never more than a
  /// quarter of the rows, either.
  Index largest_border = 128;
  /// Rows removed and added since the last full fit from which on `wants_refit`.
  Index refit_border = 32;
  /// The largest |f(c_i) - h_i| that is believed, relative to the largest |h| ...
  double accuracy = 1e-9;
  /// ... or, if that is more, relative to what rounding a sum of terms |w_j| phi may cost at most. Some
  /// hundredth of that is left where errors of either sign meet, and fit() misses by as much. (Of r^3 in 2D
  /// with 5000 rows, one of them pulled out of line: 2e-9 of the values.)
  double rounding = 0.05;
  /// Kernel evaluations that may be spent on looking at rows that did not change: all of them where N^2 is
  /// less, that many / N otherwise, evenly over the list.
  Index check = 200000;
};

/// What an update may cost at most.
struct Budget {
  /// Rows of a full fit.
  Index full = std::numeric_limits<Index>::max();
  /// Multiplications of a border, 2 N^2 for each of its solves. A tenth of a second for 1e9 of them.
  double border = infinity;
};

/// How the last function came about.
struct EditReport {
  /// Why there was a full fit, if there was.
  enum class Full {
    no,
    first,         ///< there was none to border
    options,       ///< another kernel or smoothing
    few_rows,      ///< fewer than EditOptions::smallest
    many_changes,  ///< than a border is worth
    out_of_reach,  ///< the extent has changed so much that other normalized coordinates are due
    flat,          ///< (nearly) on one line or plane
    close_rows,    ///< a changed row is so near another that only a factorization can tell them apart
    inaccurate     ///< the bordered function missed its constraints
  };
  Full full = Full::first;
  Index removed = 0, added = 0;  ///< rows of the border
  Index solves = 0;              ///< solves with the old matrix
  Index refinements = 0;         ///< steps of iterative refinement
  Index checked = 0;      ///< rows at which the finished function was looked at; all of them after a full fit
  double residual = 0.0;  ///< the largest |f(c_i) - h_i| of those (with smoothing: beyond what it should be)
};

/// "full fit: many changes" and the like, or "bordered".
std::string_view name_of(EditReport::Full full);

/// What is due costs more than was granted.
class OverBudget : public Error {
 public:
  OverBudget(EditReport::Full reason, Index rows);

  /// Why a full fit is due; `no` where a border is.
  EditReport::Full reason() const { return reason_; }
  Index rows() const { return rows_; }

 private:
  EditReport::Full reason_;
  Index rows_;
};

/// Of a fresh session that was handed to another.
struct Handover {
  /// False where the session stays what it was: the fresh one is of another kernel or smoothing, or its full
  /// fit is further from the present constraints.
  bool adopted = false;
  /// The largest difference of the functions before and after, of the same constraints, at rows and at points
  /// in the box around them: what editing without refitting had cost. In units of the values.
  double difference = 0.0;
};

/// One caller at a time.
template <int Dim>
class EditSession {
 public:
  /// A full fit; throws ConstraintError as `fit` does.
  explicit EditSession(const Constraints<Dim>& constraints, const FitOptions& options = {},
                       const EditOptions& edit = {}, const Progress& progress = {});

  /// The function of these constraints: fit()'s to some 1e-9 of the values, with centers in the same order.
  /// Throws ConstraintError as `fit` does (same reason, same culprits), OverBudget, and Cancelled where
  /// `progress` says stop; the session then stays what it was. In the report, the reciprocal condition is
  /// that of the last full fit and `max_residual` that of the rows looked at.
  const Fit<Dim>& update(const Constraints<Dim>& constraints);
  /// Another kernel or smoothing is a full fit.
  const Fit<Dim>& update(const Constraints<Dim>& constraints, const FitOptions& options,
                         const Budget& budget = {}, const Progress& progress = {});

  /// The last ones that could be met.
  const Constraints<Dim>& constraints() const { return constraints_; }
  const FitOptions& options() const { return options_; }
  /// Of those.
  const Fit<Dim>& fit() const { return fit_; }
  /// How that came about.
  const EditReport& last() const { return last_; }

  /// True when the border has grown to where a fresh fit is due.
  bool wants_refit() const;
  /// Takes over the full fit of another session, and what is known of its border; what its constraints lack
  /// of the present ones is bordered first. Costs an update. Throws as `update` does; the session then stays
  /// what it was.
  Handover adopt(EditSession fresh, const Budget& budget = {});

 private:
  // The last full fit, and what was solved with it.
  struct Ground {
    std::shared_ptr<const FullFit<Dim>> full;
    RowFinder<Dim> finder;
    Border<Dim> border;

    explicit Ground(FullFit<Dim> fresh);
  };
  // What an update is asked for, and what it may cost.
  struct Asked {
    const Constraints<Dim>& constraints;
    const FitOptions& options;
    const Budget& budget;
    const Progress& progress;
  };

  Fit<Dim> next(const Asked& asked, EditReport& edit);
  Fit<Dim> bordered(const Asked& asked, const Rows<Dim>& rows, const RowMatch& match, EditReport& edit);
  EditReport::Full reason_for_full(const Rows<Dim>& rows, const RowMatch& match) const;
  Fit<Dim> refit(const Asked& asked, Index rows, EditReport& edit);

  EditOptions edit_;
  Constraints<Dim> constraints_;
  FitOptions options_;
  EditReport last_;
  Ground ground_;
  Fit<Dim> fit_;
};

extern template class EditSession<2>;
extern template class EditSession<3>;
extern template class EditSession<4>;

/// A session as a function of constraints and options, for whoever wants fit() and would rather have it at
/// once (core/editing/shape.h): it begins with the first constraints that can be met. Copies share it.
template <int Dim>
class LiveSolver {
 public:
  explicit LiveSolver(const EditOptions& edit = {}) : state_(std::make_shared<State>(State{edit, {}})) {}

  Fit<Dim> operator()(const Constraints<Dim>& constraints, const FitOptions& options) const {
    if (!state_->session) return state_->session.emplace(constraints, options, state_->edit).fit();
    return state_->session->update(constraints, options);
  }
  /// None before the first constraints.
  EditSession<Dim>* session() const { return state_->session ? &*state_->session : nullptr; }

 private:
  struct State {
    EditOptions edit;
    std::optional<EditSession<Dim>> session;
  };
  std::shared_ptr<State> state_;
};

}  // namespace seesaw
