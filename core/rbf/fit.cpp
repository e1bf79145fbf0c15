#include "core/rbf/fit.h"

#include <chrono>
#include <cmath>

#include "core/base/check.h"
#include "core/rbf/energy.h"
#include "core/rbf/full_fit.h"

namespace seesaw {

namespace {

std::string words_for(const std::vector<Index>& culprits) {
  std::string text = culprits.size() == 1 ? "constraint " : "constraints ";
  for (std::size_t i = 0; i < culprits.size(); ++i) text += (i ? " and " : "") + std::to_string(culprits[i]);
  return text;
}

template <int Dim>
[[noreturn]] void refuse_too_close(const Rows<Dim>& rows, const char* evidence) {
  refuse_if_one_is_far(rows);
  const auto culprits = nearest_pair(rows);
  throw ConstraintError(ConstraintError::Reason::too_close,
                        words_for(culprits) +
                            (culprits.size() == 1 ? " and its normal constraint are" : " are") +
                            " too close together to solve for (" + evidence + "); move or delete one of them",
                        culprits);
}

// Of the time of a fit of some thousand rows, how much its factorization takes; the rest is two solves, two
// residuals, and the condition.
constexpr double factored = 0.9;

template <int Dim>
FullFit<Dim> fit_rows(Rows<Dim> rows, const FitOptions& options, FitReport report, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  SEESAW_CHECK_LE(0.0, options.smoothing);
  report.kernel = options.kernel.value_or(papers_kernel(Dim));
  report.smoothing = options.smoothing;
  // With smoothing the system has a solution even where measurements disagree, and a repeated one counts
  // twice.
  if (options.smoothing == 0.0) rows = merge_coincident(rows);
  report.merged = rows.merged;
  report.rows = rows.values.size();

  const auto normalization = Normalization<Dim>::of(rows.centers);
  const Points<Dim> centers = normalization.apply(rows.centers);
  // s Phi + lambda I in scene units is scale^b (s Phi' + lambda / scale^b I) in normalized ones.
  const double smoothing = options.smoothing / std::pow(normalization.scale, growth_of(report.kernel));
  Factorization<Dim> factorization(centers, report.kernel, smoothing, share_of(progress, 0.0, factored));
  report.polynomial_rank = factorization.polynomial_rank();
  report.degenerate = report.polynomial_rank < Dim + 1;
  if (!factorization.positive_definite()) refuse_too_close(rows, "the matrix is singular to rounding");

  Solution solution = factorization.solve(rows.values);
  const auto function_of = [&](const Solution& s) {
    return Interpolant<Dim>(report.kernel, rows.centers, normalization, s);
  };
  const double target = rows.values.cwiseAbs().maxCoeff();
  // What the finished function misses by, and with smoothing what it misses beyond the lambda w that it
  // should.
  const auto residual_of = [&](const Interpolant<Dim>& f) -> Values {
    return rows.values - f.values(rows.centers);
  };
  Interpolant<Dim> function = function_of(solution);
  Values residual = residual_of(function);
  if (options.smoothing == 0.0 && target > 0.0) {
    // One step of iterative refinement. The residual is summed with its rounding errors kept, which is what
    // makes the step worth its two solves; taken only where it helps.
    seesaw::report(progress, 0.5 * (1.0 + factored));
    const Solution correction = factorization.solve(residual);
    const Solution refined{solution.weights + correction.weights,
                           solution.polynomial + correction.polynomial};
    Interpolant<Dim> better = function_of(refined);
    const Values remaining = residual_of(better);
    if (remaining.cwiseAbs().maxCoeff() < residual.cwiseAbs().maxCoeff()) {
      function = std::move(better);
      residual = remaining;
    }
    // A matrix can pass for positive definite and still have lost every digit: then f misses its constraints.
    if (!(residual.cwiseAbs().maxCoeff() <= 1e-6 * target))
      refuse_too_close(rows, "the solution misses its constraints");
  }
  report.max_residual = residual.cwiseAbs().maxCoeff();
  seesaw::report(progress, 1.0);
  if (options.condition) report.reciprocal_condition = factorization.reciprocal_condition();
  // s w' Phi w = s w' (f - P p) = s w' f at the centers, since P' w = 0: nothing needs to be evaluated again.
  const double sign = report.kernel == Kernel::linear ? -1.0 : 1.0;
  report.energy = std::max(
      0.0, sign * energy_factor(report.kernel, Dim) * function.weights().dot(rows.values - residual));
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return {options, std::move(rows), smoothing, std::move(factorization), {std::move(function), report}};
}

}  // namespace

template <int Dim>
FitReport counted(const Constraints<Dim>& constraints) {
  FitReport report;
  for (const auto& constraint : constraints) {
    report.boundary += constraint.kind == ConstraintKind::boundary;
    report.interior += constraint.kind == ConstraintKind::interior;
    report.exterior += constraint.kind == ConstraintKind::exterior;
    report.normal += constraint.normal.has_value();
  }
  return report;
}

template <int Dim>
FullFit<Dim> full_fit(const Constraints<Dim>& constraints, const FitOptions& options,
                      const Progress& progress) {
  return fit_rows(rows_of(constraints), options, counted(constraints), progress);
}

template <int Dim>
Fit<Dim> fit(const Constraints<Dim>& constraints, const FitOptions& options, const Progress& progress) {
  return full_fit(constraints, options, progress).fit;
}

template <int Dim>
Fit<Dim> fit_values(const PointsRef<Dim>& points, const Eigen::Ref<const Values>& values,
                    const FitOptions& options, const Progress& progress) {
  FitReport report;
  report.boundary = points.cols();
  return fit_rows(rows_of<Dim>(points, values), options, report, progress).fit;
}

#define SEESAW_INSTANTIATE(Dim)                                                                     \
  template FitReport counted<Dim>(const Constraints<Dim>&);                                         \
  template FullFit<Dim> full_fit<Dim>(const Constraints<Dim>&, const FitOptions&, const Progress&); \
  template Fit<Dim> fit<Dim>(const Constraints<Dim>&, const FitOptions&, const Progress&);          \
  template Fit<Dim> fit_values<Dim>(const PointsRef<Dim>&, const Eigen::Ref<const Values>&,         \
                                    const FitOptions&, const Progress&);
SEESAW_INSTANTIATE(2)
SEESAW_INSTANTIATE(3)
SEESAW_INSTANTIATE(4)
#undef SEESAW_INSTANTIATE

}  // namespace seesaw
