#include "core/modelling/tolerant_fit.h"

#include "core/rbf/system.h"

namespace seesaw {

TolerantFit fit_tolerantly(Constraints<3>& constraints, const FitOptions& options) {
  constexpr Index most = 30;
  for (Index left_out = 0;; ++left_out) {
    try {
      return {fit(constraints, options), left_out};
    } catch (const ConstraintError& error) {
      const bool helps = error.reason() == ConstraintError::Reason::too_close ||
                         error.reason() == ConstraintError::Reason::contradictory;
      if (!helps || left_out == most || error.culprits().empty() || constraints.size() < 8) throw;
      const auto last = static_cast<std::size_t>(error.culprits().back());
      if (constraints[last].normal)
        constraints[last].normal.reset();
      else
        constraints.erase(constraints.begin() + static_cast<std::ptrdiff_t>(last));
    }
  }
}

}  // namespace seesaw
