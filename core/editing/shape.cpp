#include "core/editing/shape.h"

#include <new>

namespace seesaw {

template <int Dim>
void solve(Shape<Dim>& shape, const Document<Dim>& document, std::uint64_t revision,
           const Solver<Dim>& solver) {
  shape.pending = false;
  try {
    Fit<Dim> fitted =
        solver(constraints_of(document), {.kernel = document.kernel, .smoothing = document.smoothing});
    shape = {std::make_shared<const Interpolant<Dim>>(std::move(fitted.function)), fitted.report, revision,
             std::nullopt, false};
  } catch (const StillSolving<Dim>& still) {
    if (still.newer()) {
      shape.function = std::make_shared<const Interpolant<Dim>>(still.newer()->function);
      shape.report = still.newer()->report;
    }
    shape.impossible.reset();
    shape.pending = true;
  } catch (const ConstraintError& error) {
    shape.impossible = Impossible{error.reason(), error.what(), error.culprits()};
    // Of nothing at all, nothing is to be seen.
    if (document.constraints.empty()) shape.function = nullptr;
  } catch (const std::bad_alloc&) {
    shape.impossible =
        Impossible{std::nullopt,
                   "there is not enough memory to solve for " + std::to_string(document.constraints.size()) +
                       " constraints; delete some",
                   {}};
  }
}

template void solve(Shape<2>&, const Document<2>&, std::uint64_t, const Solver<2>&);
template void solve(Shape<3>&, const Document<3>&, std::uint64_t, const Solver<3>&);

}  // namespace seesaw
