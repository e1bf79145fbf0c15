// What must hold of every movable surface: f_q against differences, and freezing.
#pragma once

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/implicit/parametric.h"

namespace seesaw {

/// Expects f_q at `points` to agree with central differences of f by the parameters, step `step`, to
/// `tolerance` relative to a point's largest derivative or 1; and `rates` with f_q . q'. The field is as it
/// was afterwards.
template <int Dim>
void expect_q_gradients_match_differences(ParametricField<Dim>& field, const Points<Dim>& points, double step,
                                          double tolerance) {
  const Eigen::MatrixXd given = field.q_gradients(points);
  ASSERT_EQ(given.rows(), field.parameters());
  ASSERT_EQ(given.cols(), points.cols());
  const Values q = field.q();
  Eigen::MatrixXd differences(given.rows(), given.cols());
  for (Index i = 0; i < q.size(); ++i) {
    Values moved = q;
    moved[i] = q[i] + step;
    field.set_q(moved);
    const Values above = field.values(points);
    moved[i] = q[i] - step;
    field.set_q(moved);
    differences.row(i) = (above - field.values(points)).transpose() / (2 * step);
  }
  field.set_q(q);
  for (Index k = 0; k < points.cols(); ++k) {
    const double size = std::max(1.0, given.col(k).cwiseAbs().maxCoeff());
    Index worst = 0;
    EXPECT_LE((given.col(k) - differences.col(k)).cwiseAbs().maxCoeff(&worst), tolerance * size)
        << "parameter " << worst << " at " << points.col(k).transpose() << "\n  f_q         "
        << given(worst, k) << "\n  differences " << differences(worst, k);
  }
  Values speeds(q.size());
  for (Index i = 0; i < q.size(); ++i) speeds[i] = std::sin(1 + 3 * static_cast<double>(i));
  const Values rates = field.rates(points, speeds), expected = given.transpose() * speeds;
  EXPECT_LE((rates - expected).cwiseAbs().maxCoeff(),
            1e-9 * std::max(1.0, given.cwiseAbs().colwise().sum().maxCoeff()));
}

/// Freezes every other parameter and moves the rest: the frozen ones keep their bits, q and f_q leave them
/// out, and thawing brings them back.
template <int Dim>
void expect_freezing_works(ParametricField<Dim>& field, Random& random, double step = 0.01) {
  const Values before = field.q();
  const Points<Dim> x = random.points_in<Dim>(field.bounding_box(), 5);
  const Eigen::MatrixXd all = field.q_gradients(x);
  const Index m = before.size();
  std::vector<Index> free;
  for (Index i = 0; i < m; ++i)
    if (i % 2 == 0)
      field.freeze(i);
    else
      free.push_back(i);
  EXPECT_TRUE(field.is_frozen(0));
  EXPECT_FALSE(field.is_frozen(1));
  ASSERT_EQ(field.parameters(), static_cast<Index>(free.size()));
  EXPECT_EQ(field.q(), before(free));
  EXPECT_EQ(field.q_gradients(x), all(free, Eigen::all));
  Values q = field.q();
  for (double& each : q) each += step * random.uniform(0.5, 1);
  field.set_q(q);
  for (Index i = 0; i < m; ++i) field.freeze(i, false);
  const Values after = field.q();
  for (Index i = 0; i < m; ++i)
    if (i % 2 == 0)
      EXPECT_EQ(after[i], before[i]);
    else
      EXPECT_EQ(after[i], q[i / 2]);
  EXPECT_NE(field.values(x)[0], 0);
  field.set_q(before);
}

}  // namespace seesaw
