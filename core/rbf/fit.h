// From constraints to a function in one call.
//
// Before it: a list of constraints (core/rbf/constraints.h).  After it: an Interpolant, ready to draw.
//
//     Constraints<2> shape = {boundary<2>({-1, 0}), boundary<2>({1, 0}), boundary<2>({0, -1}),
//                             boundary<2>({0, 1}), interior<2>({0, 0})};
//     const Fit<2> fitted = fit(shape);
//     fitted.function.value({0, 0});        // 1: inside
//     fitted.function.value({2, 0});        // negative: outside
//     fitted.report.max_residual;           // about 1e-16
//
// The one object for repeated work is Factorization (core/rbf/solve.h): factor once, solve for many values.
#pragma once

#include <optional>
#include <string>

#include "core/base/progress.h"
#include "core/rbf/interpolant.h"

namespace seesaw {

struct FitOptions {
  /// The radial basis function; none means the papers' choice for the dimension: r^2 log r in 2D, |x|^3
  /// above.
  std::optional<Kernel> kernel = std::nullopt;
  /// lambda >= 0 of min  sum (f(c_i) - h_i)^2 + lambda s w' Phi w, with s w' Phi w the energy without its
  /// factor (core/rbf/energy.h). 0 interpolates. In scene units: length^b. SciPy's RBFInterpolator means the
  /// same by it.
  double smoothing = 0.0;
  /// Also estimate the reciprocal condition; some ten solves.
  bool condition = true;
};

/// What a fit has to say about itself; the numbers that editors and figures show.
struct FitReport {
  Kernel kernel = Kernel::thin_plate_spline;
  double smoothing = 0.0;
  Index boundary = 0, interior = 0, exterior = 0, normal = 0;  ///< constraints by kind, as given
  Index rows = 0;                                              ///< rows of the system: centers, after merging
  Index merged = 0;           ///< further rows at the same position with the same value
  Index polynomial_rank = 0;  ///< Dim + 1, or less for centers on one line or plane
  bool degenerate = false;    ///< polynomial_rank < Dim + 1: the least-norm polynomial was taken
  double max_residual = 0.0;  ///< max |f(c_i) - h_i|, of the finished function; large if smoothing > 0
  double reciprocal_condition = 1.0;  ///< of the reduced system; 1 if not asked for
  double energy = 0.0;                ///< core/rbf/energy.h; eq. 3 exactly for r^2 log r in 2D
  double seconds = 0.0;               ///< wall time of the whole fit

  /// Constraints of all kinds, a normal counting as one of its own.
  Index constraints() const { return boundary + interior + exterior + normal; }
};

template <int Dim>
struct Fit {
  Interpolant<Dim> function;
  FitReport report;
};

/// The function of least energy that meets the constraints. Throws ConstraintError, naming the culprits,
/// where there is none: see core/rbf/system.h; too_close where centers are so near that no digit tells them
/// apart. Memory N^2 / 2 doubles, time N^3 / 3 multiplications, N the number of rows. Told by `progress` to
/// stop it throws Cancelled some 10 ms later.
template <int Dim>
Fit<Dim> fit(const Constraints<Dim>& constraints, const FitOptions& options = {},
             const Progress& progress = {});

/// The same for plain values at points (Dim x N and N): scattered data interpolation, T&O 2002, section 2.2.
/// The report counts every point as a boundary constraint.
template <int Dim>
Fit<Dim> fit_values(const PointsRef<Dim>& points, const Eigen::Ref<const Values>& values,
                    const FitOptions& options = {}, const Progress& progress = {});

}  // namespace seesaw
