#include "core/rbf/edit_session.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "core/base/check.h"
#include "core/base/random.h"
#include "core/rbf/energy.h"

namespace seesaw {

namespace {

using Full = EditReport::Full;

// Rows nearer to each other than this, relative to the extent, are for a factorization to judge. A border
// would still be right at a hundredth of that.
constexpr double close_to_another = 1e-5;

// A set of centers is for a QR to judge where it is flatter than this.
constexpr double nearly_flat = 1e-6;

// Normalized coordinates were made for the box [-1, 1]. Up to this many times larger or smaller, the digits
// are as good.
constexpr double largest_coordinate = 4.0;

// A factorization of N rows takes about as long as N / this many columns of a border. (Measured from N = 300
// to 3000, on one core: N / 6 solves; the rest is the Schur complement.)
constexpr Index rows_a_solve = 12;

constexpr Index most_refinements = 2;

Kernel kernel_of(const FitOptions& options, int dimension) {
  return options.kernel.value_or(papers_kernel(dimension));
}

// As `fit` begins, so that what it refuses is refused.
template <int Dim>
Rows<Dim> system_rows(const Constraints<Dim>& constraints, const FitOptions& options) {
  Rows<Dim> rows = rows_of(constraints);
  return options.smoothing == 0.0 ? merge_coincident(rows) : rows;
}

// The extent of points in the direction where they extend least, relative to that where they extend most: the
// farthest from the mean, the farthest from that line, ...
template <int Dim>
double flatness_of(const Points<Dim>& points) {
  Points<Dim> left = points.colwise() - points.rowwise().mean();
  double first = 0.0, extent = 0.0;
  for (int d = 0; d < Dim; ++d) {
    Index farthest = 0;
    extent = std::sqrt(left.colwise().squaredNorm().maxCoeff(&farthest));
    if (d == 0) first = extent;
    if (!(extent > 0.0)) return 0.0;
    const Point<Dim> axis = left.col(farthest) / extent;
    left -= axis * (axis.transpose() * left).eval();
  }
  return extent / first;
}

// Whether one of the rows `some` is nearer than `distance` to any other.
template <int Dim>
bool any_close(const Points<Dim>& centers, const std::vector<Index>& some, double distance) {
  for (const Index i : some) {
    Index near = 0;
    for (Index j = 0; j < centers.cols(); ++j)
      near += (centers.col(j) - centers.col(i)).squaredNorm() < distance * distance;
    if (near > 1) return true;  // itself is one
  }
  return false;
}

}  // namespace

std::string_view name_of(EditReport::Full full) {
  switch (full) {
    case Full::no:
      return "bordered";
    case Full::first:
      return "full fit: the first";
    case Full::options:
      return "full fit: other options";
    case Full::few_rows:
      return "full fit: few rows";
    case Full::many_changes:
      return "full fit: many changes";
    case Full::out_of_reach:
      return "full fit: another extent";
    case Full::flat:
      return "full fit: nearly flat";
    case Full::close_rows:
      return "full fit: rows close together";
    case Full::inaccurate:
      return "full fit: inaccurate";
  }
  return "";
}

OverBudget::OverBudget(EditReport::Full reason, Index rows)
    : Error(std::string(name_of(reason)) + "; with " + std::to_string(rows) +
            " rows that is more than may be done at once"),
      reason_(reason),
      rows_(rows) {}

template <int Dim>
EditSession<Dim>::Ground::Ground(FullFit<Dim> fresh)
    : full(std::make_shared<const FullFit<Dim>>(std::move(fresh))),
      finder(full->rows.centers),
      border(full) {}

template <int Dim>
EditSession<Dim>::EditSession(const Constraints<Dim>& constraints, const FitOptions& options,
                              const EditOptions& edit, const Progress& progress)
    : edit_(edit),
      constraints_(constraints),
      options_(options),
      ground_(full_fit(constraints, options, progress)),
      fit_(ground_.full->fit) {
  last_.checked = fit_.report.rows;
  last_.residual = fit_.report.max_residual;
}

template <int Dim>
bool EditSession<Dim>::wants_refit() const {
  return last_.removed + last_.added >= edit_.refit_border;
}

template <int Dim>
const Fit<Dim>& EditSession<Dim>::update(const Constraints<Dim>& constraints) {
  return update(constraints, options_);
}

template <int Dim>
const Fit<Dim>& EditSession<Dim>::update(const Constraints<Dim>& constraints, const FitOptions& options,
                                         const Budget& budget, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  EditReport edit;
  Fit<Dim> fit = next({constraints, options, budget, progress}, edit);
  fit.report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  Constraints<Dim> copy = constraints;
  fit_ = std::move(fit);
  constraints_ = std::move(copy);
  options_ = options;
  last_ = edit;
  return fit_;
}

template <int Dim>
Fit<Dim> EditSession<Dim>::next(const Asked& asked, EditReport& edit) {
  const FitOptions& options = asked.options;
  SEESAW_CHECK_LE(0.0, options.smoothing);
  const FullFit<Dim>& base = *ground_.full;
  const Rows<Dim> rows = system_rows(asked.constraints, options);
  if (kernel_of(options, Dim) != base.kernel() || options.smoothing != base.options.smoothing ||
      (options.condition && !base.options.condition)) {
    edit.full = Full::options;
    return refit(asked, rows.values.size(), edit);
  }
  const RowMatch match = ground_.finder.match(rows.centers);
  edit.full = reason_for_full(rows, match);
  if (edit.full != Full::no) return refit(asked, rows.values.size(), edit);
  edit.removed = static_cast<Index>(match.removed.size());
  edit.added = static_cast<Index>(match.added.size());
  Fit<Dim> result = bordered(asked, rows, match, edit);
  if (edit.full != Full::no) return refit(asked, rows.values.size(), edit);
  if (!options.condition) result.report.reciprocal_condition = 1.0;
  return result;
}

template <int Dim>
Fit<Dim> EditSession<Dim>::refit(const Asked& asked, Index rows, EditReport& edit) {
  if (rows > asked.budget.full) throw OverBudget(edit.full, rows);
  Ground fresh(full_fit(asked.constraints, asked.options, asked.progress));
  ground_ = std::move(fresh);
  const Fit<Dim>& fit = ground_.full->fit;
  EditReport report;
  report.full = edit.full;
  report.checked = fit.report.rows;
  report.residual = fit.report.max_residual;
  edit = report;
  return fit;
}

template <int Dim>
Full EditSession<Dim>::reason_for_full(const Rows<Dim>& rows, const RowMatch& match) const {
  const FullFit<Dim>& base = *ground_.full;
  const Index n = rows.values.size();
  if (n < edit_.smallest || base.fit.report.rows < edit_.smallest) return Full::few_rows;
  if (base.fit.report.degenerate) return Full::flat;
  if (match.size() == 0) return Full::no;
  if (match.size() > std::min(edit_.largest_border, n / 4)) return Full::many_changes;
  const Normalization<Dim>& normalization = base.fit.function.normalization();
  const double scale = Normalization<Dim>::of(rows.centers).scale;
  const Points<Dim> centers = normalization.apply(rows.centers);
  if (!(centers.cwiseAbs().maxCoeff() <= largest_coordinate &&
        scale * largest_coordinate >= normalization.scale))
    return Full::out_of_reach;
  if (ground_.border.unknown(match.removed, centers(Eigen::all, match.added)) >
      std::max<Index>(8, n / rows_a_solve))
    return Full::many_changes;
  if (flatness_of<Dim>(centers) < nearly_flat) return Full::flat;
  const double extent = bounding_box_of<Dim>(centers).sizes().maxCoeff();
  if (any_close<Dim>(centers, match.added, close_to_another * extent)) return Full::close_rows;
  return Full::no;
}

template <int Dim>
Fit<Dim> EditSession<Dim>::bordered(const Asked& asked, const Rows<Dim>& rows, const RowMatch& match,
                                    EditReport& edit) {
  const FullFit<Dim>& base = *ground_.full;
  const Index n = rows.values.size();
  const Normalization<Dim>& normalization = base.fit.function.normalization();
  const double sign = base.kernel() == Kernel::linear ? -1.0 : 1.0;
  const double target = rows.values.cwiseAbs().maxCoeff();

  // From the order of the present rows to that of the border, and back.
  const auto split = [&](const Values& present, Values& old, Values& added) {
    added.resize(static_cast<Index>(match.added.size()));
    Index next_added = 0;
    for (Index i = 0; i < n; ++i) {
      const Index row = match.old_row[slot(i)];
      (row < 0 ? added[next_added++] : old[row]) = present[i];
    }
  };
  const auto joined = [&](const BorderedSolution& parts) {
    Solution solution{Values(n), parts.polynomial};
    Index next_added = 0;
    for (Index i = 0; i < n; ++i) {
      const Index row = match.old_row[slot(i)];
      solution.weights[i] = row < 0 ? parts.added_weights[next_added++] : parts.old_weights[row];
    }
    return solution;
  };
  const auto function_of_rows = [&](const Solution& solution) {
    return Interpolant<Dim>(base.kernel(), rows.centers, normalization, solution);
  };
  // What f misses at some rows, beyond the s lambda w that smoothing wants.
  const auto missed_at = [&](const Interpolant<Dim>& f, const std::vector<Index>& some) -> Values {
    const Points<Dim> centers = rows.centers(Eigen::all, some);
    return rows.values(some) - sign * base.smoothing * f.normalized_weights()(some) - f.values(centers);
  };

  Values old = base.rows.values, added;
  split(rows.values, old, added);
  const Points<Dim> centers = normalization.apply(rows.centers(Eigen::all, match.added));
  const double size = static_cast<double>(base.rows.values.size());
  if (2 * size * size * static_cast<double>(ground_.border.solves(match.removed, centers, old)) >
      asked.budget.border)
    throw OverBudget(Full::no, n);
  edit.solves = ground_.border.set(match.removed, centers, old, asked.progress);
  auto parts = ground_.border.solution(added);
  const auto give_up = [&] {
    edit.full = Full::inaccurate;
    return ground_.full->fit;
  };
  if (!parts) return give_up();
  Solution solution = joined(*parts);
  Interpolant<Dim> function = function_of_rows(solution);

  std::vector<Index> looked_at = match.added;
  const Index step = std::max<Index>(1, (n * n + edit_.check - 1) / std::max<Index>(1, edit_.check));
  for (Index i = 0; i < n; i += step)
    if (match.old_row[slot(i)] >= 0) looked_at.push_back(i);
  Values missed = missed_at(function, looked_at);
  // In normalized coordinates all centers are within [-1, 1], or were when they were normalized.
  const double largest_phi = std::pow(2 * std::sqrt(double{Dim}), growth_of(base.kernel()));
  const auto believed = [&] {
    const double rounding =
        std::numeric_limits<double>::epsilon() * largest_phi * solution.weights.cwiseAbs().sum();
    return std::max(edit_.accuracy * target, edit_.rounding * rounding);
  };
  for (; !(missed.cwiseAbs().maxCoeff() <= believed()); ++edit.refinements) {
    if (edit.refinements == most_refinements) return give_up();
    looked_at.resize(static_cast<std::size_t>(n));
    std::iota(looked_at.begin(), looked_at.end(), Index{0});
    Values old_missed = Values::Zero(base.rows.values.size());
    split(missed_at(function, looked_at), old_missed, added);
    parts = ground_.border.solution_of(old_missed, added, asked.progress);
    if (!parts) return give_up();
    ++edit.solves;
    const Solution correction = joined(*parts);
    solution.weights += correction.weights;
    solution.polynomial += correction.polynomial;
    function = function_of_rows(solution);
    missed = missed_at(function, looked_at);
  }
  edit.checked = static_cast<Index>(looked_at.size());
  edit.residual = missed.cwiseAbs().maxCoeff();

  FitReport report = counted(asked.constraints);
  report.kernel = base.kernel();
  report.smoothing = base.options.smoothing;
  report.rows = n;
  report.merged = rows.merged;
  report.polynomial_rank = Dim + 1;
  report.reciprocal_condition = base.fit.report.reciprocal_condition;
  // h - f at all rows is s lambda w, and at those looked at what was missed besides.
  Values residual = sign * base.smoothing * function.normalized_weights();
  for (std::size_t k = 0; k < looked_at.size(); ++k) residual[looked_at[k]] += missed[static_cast<Index>(k)];
  report.max_residual = residual.cwiseAbs().maxCoeff();
  report.energy = std::max(
      0.0, sign * energy_factor(base.kernel(), Dim) * function.weights().dot(rows.values - residual));
  return {std::move(function), report};
}

template <int Dim>
Handover EditSession<Dim>::adopt(EditSession fresh, const Budget& budget) {
  const FullFit<Dim>& full = *fresh.ground_.full;
  if (full.kernel() != ground_.full->kernel() || full.options.smoothing != options_.smoothing ||
      (options_.condition && !full.options.condition) || full.fit.report.degenerate)
    return {};
  const Rows<Dim> rows = system_rows(constraints_, options_);
  if (fresh.ground_.finder.match(rows.centers).size() > ground_.finder.match(rows.centers).size()) return {};

  fresh.edit_ = edit_;
  fresh.update(constraints_, options_, budget);
  std::swap(*this, fresh);
  const Interpolant<Dim>& before = fresh.fit_.function;
  // The same points every time, in the box around the rows and at rows.
  Random random(1);
  const Index count = std::clamp<Index>(edit_.check / rows.values.size(), 100, 1000);
  const Points<Dim> anywhere = random.points_in<Dim>(before.bounding_box(), count);
  const double between = (before.values(anywhere) - fit_.function.values(anywhere)).cwiseAbs().maxCoeff();
  std::vector<Index> some;
  for (Index i = 0; i < rows.values.size(); i += 1 + rows.values.size() / count) some.push_back(i);
  const Points<Dim> at_rows = rows.centers(Eigen::all, some);
  return {true,
          std::max(between, (before.values(at_rows) - fit_.function.values(at_rows)).cwiseAbs().maxCoeff())};
}

template class EditSession<2>;
template class EditSession<3>;
template class EditSession<4>;

}  // namespace seesaw
