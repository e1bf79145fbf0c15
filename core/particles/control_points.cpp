#include "core/particles/control_points.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>

namespace seesaw {
namespace {

constexpr double least_pivot = 1e-4;       // for Cholesky; relative to the largest column
constexpr double contradiction = 1e-4;     // of the fastest motion asked for
constexpr double nearly_flat = 1e-6;       // |f_x|, of the largest
constexpr double no_motion_at_all = 1e-9;  // of the surface's size, per unit of time: rounding

// Everything about the points that does not depend on how it is solved.
struct Equations {
  Eigen::MatrixXd columns;  // L^-1 J / |f_x|, m x n
  Values demands;           // (J' Q + f_x . P + phi f) / |f_x|, n
};

template <int Dim>
Equations equations(const ParametricField<Dim>& field, const ControlPoints<Dim>& points,
                    const ControlOptions& options, const Values& desired) {
  const Index n = points.size();
  Values values(n);
  Points<Dim> slopes(Dim, n);
  field.evaluate(points.positions, values, slopes);
  const Eigen::MatrixXd by_q = field.q_gradients(points.positions);
  Values scale = slopes.colwise().norm().transpose();
  const double steepest = scale.maxCoeff();
  scale = steepest > 0 ? Values(scale.cwiseMax(nearly_flat * steepest).cwiseInverse()) : Values::Ones(n);
  const Values rates = slopes.cwiseProduct(points.velocities).colwise().sum().transpose() +
                       by_q.transpose() * desired + options.adhesion_gain * values;
  return {options.metric.to_orthonormal(by_q * scale.asDiagonal()), scale.cwiseProduct(rates)};
}

// The n multipliers, or nothing where Cholesky would lose too many digits.
Values by_cholesky(const Equations& e, double rank_tolerance) {
  if (e.columns.cols() > e.columns.rows()) return {};
  const Eigen::LLT<Eigen::MatrixXd> cholesky(e.columns.transpose() * e.columns);
  const double largest = e.columns.colwise().norm().maxCoeff();
  if (cholesky.info() != Eigen::Success ||
      !(cholesky.matrixLLT().diagonal().minCoeff() > std::max(least_pivot, rank_tolerance) * largest))
    return {};
  return cholesky.solve(e.demands);
}

// Who of the points that cannot all be followed is redundant, and who is missed.
void sort_out(SurfaceMotion& motion, std::vector<Index> dependent, const Values& demands, double size) {
  if (motion.method == ControlMethod::cholesky) return;
  const double worst = std::max(contradiction * demands.cwiseAbs().maxCoeff(), no_motion_at_all * size);
  const auto is_missed = [&](Index i) { return std::abs(motion.residuals[i]) > worst; };
  for (Index i = 0; i < demands.size(); ++i)
    if (is_missed(i)) motion.contradictory.push_back(i);
  std::sort(dependent.begin(), dependent.end());
  for (const Index i : dependent)
    if (!is_missed(i)) motion.redundant.push_back(i);
}

template <int Dim>
double longest_side(const ParametricField<Dim>& field) {
  const Box<Dim> box = field.bounding_box();
  return box.isEmpty() ? 0.0 : box.sizes().maxCoeff();
}

}  // namespace

template <int Dim>
Index ControlPoints<Dim>::add(const Point<Dim>& position) {
  positions.conservativeResize(Dim, size() + 1);
  positions.col(size() - 1) = position;
  velocities.conservativeResize(Dim, size());
  velocities.col(size() - 1).setZero();
  return size() - 1;
}

template <int Dim>
void ControlPoints<Dim>::remove(Index index) {
  SEESAW_CHECK_LE(0, index);
  SEESAW_CHECK_LT(index, size());
  std::vector<Index> kept;
  for (Index i = 0; i < size(); ++i)
    if (i != index) kept.push_back(i);
  positions = positions(Eigen::all, kept).eval();
  velocities = velocities(Eigen::all, kept).eval();
}

template <int Dim>
SurfaceMotion surface_motion(const ParametricField<Dim>& field, const ControlPoints<Dim>& points,
                             const ControlOptions& options) {
  const Index m = field.parameters(), n = points.size();
  SEESAW_CHECK_EQ(points.velocities.cols(), n);
  SEESAW_CHECK_LE(0.0, options.rank_tolerance);
  SEESAW_CHECK_LT(0.0, options.largest_speed);
  SurfaceMotion motion;
  motion.q_rates = options.desired_rates.size() > 0 ? options.desired_rates : Values::Zero(m);
  SEESAW_CHECK_EQ(motion.q_rates.size(), m);
  if (options.metric.size() > 0) SEESAW_CHECK_EQ(options.metric.size(), m);
  if (n == 0) return motion;

  const Equations e = equations(field, points, options, motion.q_rates);
  Values change = Values::Zero(m);  // L' (q' - Q)
  std::vector<Index> dependent;
  if (m == 0) {
    for (Index i = 0; i < n; ++i) dependent.push_back(i);
  } else if (const Values multipliers = by_cholesky(e, options.rank_tolerance); multipliers.size() == n) {
    motion.method = ControlMethod::cholesky;
    motion.rank = n;
    change = -e.columns * multipliers;
  } else {
    motion.method = ControlMethod::least_squares;
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
    decomposition.setThreshold(options.rank_tolerance);
    decomposition.compute(e.columns);
    motion.rank = decomposition.rank();
    change = decomposition.transpose().solve(-e.demands);
    // Its pivots are points: the most independent come first.
    for (Index k = motion.rank; k < n; ++k) dependent.push_back(decomposition.colsPermutation().indices()[k]);
  }
  motion.residuals = e.demands + e.columns.transpose() * change;
  const double size = longest_side(field), fastest = options.largest_speed * size;
  sort_out(motion, dependent, e.demands, size);
  const double speed = m > 0 ? change.norm() * e.columns.colwise().norm().maxCoeff() : 0.0;
  if (size > 0 && speed > fastest) {
    motion.slowed = fastest / speed;
    change *= motion.slowed;
    motion.residuals = e.demands + e.columns.transpose() * change;
  }
  motion.q_rates += options.metric.from_orthonormal(change);
  return motion;
}

template <int Dim>
void advance(ParametricField<Dim>& field, ControlPoints<Dim>& points, const SurfaceMotion& motion,
             double time_step) {
  SEESAW_CHECK_EQ(points.velocities.cols(), points.size());
  field.set_q(field.q() + time_step * motion.q_rates);
  points.positions += time_step * motion.slowed * points.velocities;
}

#define SEESAW_INSTANTIATE(Dim)                                                                      \
  template struct ControlPoints<Dim>;                                                                \
  template SurfaceMotion surface_motion<Dim>(const ParametricField<Dim>&, const ControlPoints<Dim>&, \
                                             const ControlOptions&);                                 \
  template void advance<Dim>(ParametricField<Dim>&, ControlPoints<Dim>&, const SurfaceMotion&, double);
SEESAW_INSTANTIATE(2)
SEESAW_INSTANTIATE(3)
#undef SEESAW_INSTANTIATE

}  // namespace seesaw
