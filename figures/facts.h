// Facts of fits and curves under the names that every figure's JSON uses.
//
//     constraints            {boundary, interior, exterior, normal, total}
//     kernel, max_residual, reciprocal_condition, energy, fit_seconds        of the fit (core/rbf/fit.h)
//     components, closed, boundary_edges      polylines, closed ones, open ends (0: every curve closes)
//     euler_characteristic, genus             of the region inside: outer curves minus holes; 0 in the plane
//     area, length                            of the region inside, of all curves; scene units
#pragma once

#include "core/contour/contour.h"
#include "core/rbf/fit.h"
#include "figures/figure.h"

namespace seesaw {

Facts fit_facts(const FitReport& report);

/// Adds the curve's facts to `facts`.
void add_curve_facts(Facts& facts, const Contour& curve);

/// The residual's bound that every interpolating figure is held to: 1e-12 up to 50 constraints, 2e-8 beyond.
Check residual_check(const std::string& panel, const FitReport& report);

/// A number for a caption: `digits` significant digits and a typographic minus sign; 1.2e-13 as 1.2 x 10^-13.
std::string in_words(double value, int digits = 3);

}  // namespace seesaw
