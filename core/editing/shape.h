// The shape that belongs to a document: the last function that could be had, and what is wrong where there
// is none.
//
// Before it: a document's constraints, after every action.  After it: whatever draws; core/editing/resolve.h,
// which asks it where a ray meets it.
//
// In an editor a set of constraints that no function can obey is nothing unusual: two of them were dragged
// onto one another. The document holds them; the function of before stays, so that the picture stays; and the
// editor marks the culprits and says the reason.
//
// A large set is not solved while a window waits: its solver says that it is under way
// (core/editing/background_solver.h), and the function of before stays until then.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/rbf/fit.h"
#include "core/scene/document.h"

namespace seesaw {

/// How constraints become a function. fit() is one; a solver that remembers its last factorization and
/// compares the constraints with those is another. Throws ConstraintError for an impossible set, StillSolving
/// where the function is on its way.
template <int Dim>
using Solver = std::function<Fit<Dim>(const Constraints<Dim>&, const FitOptions&)>;

/// Thrown by a solver that has begun, and will have the answer when it is asked again.
template <int Dim>
class StillSolving : public Error {
 public:
  explicit StillSolving(std::optional<Fit<Dim>> newer = std::nullopt)
      : Error("the shape is still being solved"), newer_(std::move(newer)) {}

  /// Of what it was asked since the last answer, if not of the last: the best that there is to show.
  const std::optional<Fit<Dim>>& newer() const { return newer_; }

 private:
  std::optional<Fit<Dim>> newer_;
};

/// Why the present constraints have no function.
struct Impossible {
  /// None where there may be one, but not in this computer's memory.
  std::optional<ConstraintError::Reason> reason = std::nullopt;
  /// One sentence for a person.
  std::string message;
  /// Indices into the document's constraints, ascending.
  std::vector<Index> culprits;
};

template <int Dim>
struct Shape {
  /// Null until there was a first one, and for no constraints at all. Shared, and never changed: a picture may
  /// go on using it.
  std::shared_ptr<const Interpolant<Dim>> function = nullptr;
  /// Of `function`.
  FitReport report = {};
  /// The editor's revision whose document `function` obeys; while pending, that or a later one.
  std::uint64_t revision = 0;
  /// Set where the present document has no function, and `function` is that of an earlier revision.
  std::optional<Impossible> impossible = std::nullopt;
  /// True where it is not known yet whether the present document has a function: a solver is at work on it,
  /// `function` is the last that there was, and Editor::solve_again asks for the answer. Never together with
  /// `impossible`.
  bool pending = false;

  /// True where `function` obeys the present document.
  bool current() const { return function != nullptr && !impossible && !pending; }
};

/// Makes `shape` that of `document`, which is of `revision`, or says in it why that cannot be, or not yet.
/// For Dim 2 and 3.
template <int Dim>
void solve(Shape<Dim>& shape, const Document<Dim>& document, std::uint64_t revision,
           const Solver<Dim>& solver);

}  // namespace seesaw
