// A fit that keeps what it was made with: the rows, and their factored matrix.
//
// Before it: core/rbf/fit.h, which throws all that away.
// After it: core/rbf/edit_session.h, which solves for neighboring sets of constraints with the same matrix.
#pragma once

#include "core/rbf/fit.h"

namespace seesaw {

template <int Dim>
struct FullFit {
  FitOptions options;
  Rows<Dim> rows;                    ///< after merging; in the order of the function's centers
  double smoothing = 0.0;            ///< in the units of normalized coordinates
  Factorization<Dim> factorization;  ///< of the centers in the function's normalized coordinates
  Fit<Dim> fit;

  Kernel kernel() const { return fit.report.kernel; }
};

/// fit(), with the same digits and errors, and what it was made with. Memory N^2 / 2 doubles for as long as
/// it lives.
template <int Dim>
FullFit<Dim> full_fit(const Constraints<Dim>& constraints, const FitOptions& options = {},
                      const Progress& progress = {});

/// A report with nothing in it but the constraints, counted by kind.
template <int Dim>
FitReport counted(const Constraints<Dim>& constraints);

}  // namespace seesaw
