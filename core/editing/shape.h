// The shape that belongs to a document: the last function that could be had, and what is wrong where there
// is none.
//
// Before it: a document's constraints, after every action.  After it: whatever draws; core/editing/resolve.h,
// which asks it where a ray meets it.
//
// In an editor a set of constraints that no function can obey is nothing unusual: two of them were dragged
// onto one another. The document holds them; the function of before stays, so that the picture stays; and the
// editor marks the culprits and says the reason.
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
/// compares the constraints with those is another. Throws ConstraintError for an impossible set.
template <int Dim>
using Solver = std::function<Fit<Dim>(const Constraints<Dim>&, const FitOptions&)>;

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
  /// Null until there was a first one. Shared, and never changed: a picture may go on using it.
  std::shared_ptr<const Interpolant<Dim>> function = nullptr;
  /// Of `function`.
  FitReport report = {};
  /// The editor's revision whose document `function` obeys.
  std::uint64_t revision = 0;
  /// Set where the present document has no function, and `function` is that of an earlier revision.
  std::optional<Impossible> impossible = std::nullopt;

  /// True where `function` obeys the present document.
  bool current() const { return function != nullptr && !impossible; }
};

/// Makes `shape` that of `document`, which is of `revision`, or says in it why that cannot be. For Dim 2
/// and 3.
template <int Dim>
void solve(Shape<Dim>& shape, const Document<Dim>& document, std::uint64_t revision,
           const Solver<Dim>& solver);

}  // namespace seesaw
