// Control points: eqs. 6 to 8 as mathematics.
#include "core/particles/control_points.h"

#include <gtest/gtest.h>

#include "tests/core/particles/movable.h"

namespace seesaw {
namespace {

void pull_at_random(ControlPoints<3>& points, Random& random) {
  for (Index i = 0; i < points.size(); ++i) points.velocities.col(i) = random.direction<3>();
}

// (f_x . P + f_q . q' + phi f) / |f_x| by the definition, eq. 3.
Values misses(const ParametricField<3>& field, const ControlPoints<3>& points, const Values& q_rates) {
  const Eigen::MatrixXd by_q = field.q_gradients(points.positions);
  Values result(points.size());
  for (Index i = 0; i < points.size(); ++i) {
    const Point<3> p = points.positions.col(i), slope = field.gradient(p);
    result[i] =
        (slope.dot(points.velocities.col(i)) + by_q.col(i).dot(q_rates) + 15 * field.value(p)) / slope.norm();
  }
  return result;
}

Eigen::MatrixXd random_metric(Index m, Random& random) {
  Eigen::MatrixXd a(m, m);
  for (double& each : a.reshaped()) each = random.normal();
  return a * a.transpose() + Eigen::MatrixXd::Identity(m, m);
}

// Of all motions that meet the constraints, the nearest to Q: M (q' - Q) is a combination of the f_q, so it
// is orthogonal to every motion that the constraints leave free; and whoever adds such a one goes farther.
void expect_minimal(const ParametricField<3>& field, const ControlPoints<3>& points, const Values& q_rates,
                    const Values& desired, const Eigen::MatrixXd& metric, Random& random) {
  const Eigen::MatrixXd by_q = field.q_gradients(points.positions);
  const Eigen::MatrixXd gram = by_q.transpose() * by_q;
  const Values change = q_rates - desired;
  const auto length = [&](const Values& v) { return std::sqrt(v.dot(metric * v)); };
  for (int k = 0; k < 20; ++k) {
    Values free(q_rates.size());
    for (double& each : free) each = random.normal();
    free -= by_q * gram.ldlt().solve(by_q.transpose() * free);
    ASSERT_LT((by_q.transpose() * free).norm(), 1e-9 * free.norm());
    EXPECT_LT(std::abs(free.dot(metric * change)), 1e-9 * length(free) * (1e-3 + length(change)));
    EXPECT_LT(length(change), length(change + 1e-2 * free));
  }
}

TEST(ControlPoints, TheLeastMotionThatKeepsThem) {  // eqs. 6 to 8
  Random random(1);
  auto blobs = three_blobs();
  auto cylinders = two_cylinders();
  auto interpolant = octahedron();
  for (ParametricField<3>* field :
       std::initializer_list<ParametricField<3>*>{&blobs, &cylinders, &interpolant}) {
    const Index m = field->parameters();
    ControlPoints<3> points = some_points_on(*field, 5, random);
    pull_at_random(points, random);
    points.positions.col(0) *= 1.01;  // not on the surface: feedback
    Values desired(m), costs(m);
    for (double& each : desired) each = random.normal();
    for (double& each : costs) each = random.uniform(0.5, 2);
    const Eigen::MatrixXd full = random_metric(m, random);
    const struct {
      Metric metric;
      Eigen::MatrixXd matrix;
    } metrics[] = {{Metric(), Eigen::MatrixXd::Identity(m, m)},
                   {Metric::diagonal(costs), costs.asDiagonal()},
                   {Metric::full(full), full}};
    for (const auto& each : metrics)
      for (const Values& q : {Values::Zero(m).eval(), desired}) {
        const SurfaceMotion motion =
            surface_motion(*field, points, {.desired_rates = q, .metric = each.metric});
        EXPECT_EQ(motion.method, ControlMethod::cholesky);
        EXPECT_EQ(motion.rank, 5);
        EXPECT_EQ(motion.slowed, 1);
        EXPECT_LT(misses(*field, points, motion.q_rates).cwiseAbs().maxCoeff(), 1e-10);
        EXPECT_LT(motion.residuals.cwiseAbs().maxCoeff(), 1e-10);
        expect_minimal(*field, points, motion.q_rates, q, each.matrix, random);
        EXPECT_NEAR(each.metric.squared_length(q), q.dot(each.matrix * q), 1e-12 * q.dot(each.matrix * q));
      }
  }
}

TEST(ControlPoints, AllAtOneVelocityCarryASphere) {
  Random random(2);
  const ParametricSphere<3> sphere({1, 2, 3}, 0.5);
  ControlPoints<3> points = some_points_on(sphere, 4, random);
  const Point<3> velocity(0.3, -0.2, 0.5);
  points.velocities.colwise() = velocity;
  const SurfaceMotion motion = surface_motion(sphere, points);
  EXPECT_LT((motion.q_rates.head<3>() - velocity).norm(), 1e-12);
  EXPECT_NEAR(motion.q_rates[3], 0, 1e-12);
  // One alone: half of it is the radius, since f_c = 2 (x - c) and f_r = 2 r are equally long.
  ControlPoints<3> one;
  const Point<3> out = Point<3>(1, 1, 0).normalized();
  one.add(sphere.center() + 0.5 * out);
  one.velocities.col(0) = out;
  const Values rates = surface_motion(sphere, one).q_rates;
  EXPECT_LT((rates.head<3>() - 0.5 * out).norm(), 1e-15);
  EXPECT_NEAR(rates[3], 0.5, 1e-15);
}

TEST(ControlPoints, MoveCurvesToo) {
  ParametricSphere<2> circle({1, 0}, 0.5);
  ControlPoints<2> points;
  for (const double angle : {0.0, 2.0, 4.0})
    points.add(circle.center() + 0.5 * Point<2>(std::cos(angle), std::sin(angle)));
  points.velocities.colwise() = Point<2>(1, 2);
  advance(circle, points, surface_motion(circle, points), paper_step);
  EXPECT_LT((circle.center() - Point<2>(1.03, 0.06)).norm(), 1e-14);
  EXPECT_NEAR(circle.radius(), 0.5, 1e-14);
  EXPECT_LT(circle.values(points.positions).norm(), 1e-14);
}

TEST(ControlPoints, NothingToDo) {
  auto sphere = ParametricSphere<3>({0, 0, 0}, 1);
  ControlPoints<3> points;
  SurfaceMotion motion = surface_motion(sphere, points, {.desired_rates = Values{{1, 2, 3, 4}}});
  EXPECT_EQ(motion.method, ControlMethod::none);
  EXPECT_EQ(motion.q_rates, (Values{{1, 2, 3, 4}}));  // Q
  points.add({1, 0, 0});
  points.add({0, 1, 0});
  EXPECT_EQ(surface_motion(sphere, points).q_rates, Values::Zero(4));
  points.velocities(0, 0) = 1;
  for (int i = 0; i < 4; ++i) sphere.freeze(i);
  motion = surface_motion(sphere, points);
  EXPECT_EQ(motion.q_rates.size(), 0);
  EXPECT_EQ(motion.contradictory, std::vector<Index>{0});
  EXPECT_EQ(motion.redundant, std::vector<Index>{1});
  points.remove(0);
  EXPECT_EQ(points.positions, Points<3>(Point<3>(0, 1, 0)));
}

// Two at one place that ask for the same: as if there were one.
TEST(ControlPoints, RedundantPoints) {
  Random random(3);
  const auto blobs = three_blobs();
  ControlPoints<3> points = some_points_on(blobs, 4, random);
  pull_at_random(points, random);
  const SurfaceMotion once = surface_motion(blobs, points);
  points.add(points.positions.col(1));
  points.velocities.col(4) = points.velocities.col(1);
  const SurfaceMotion twice = surface_motion(blobs, points);
  EXPECT_EQ(twice.method, ControlMethod::least_squares);
  EXPECT_EQ(twice.rank, 4);
  ASSERT_EQ(twice.redundant.size(), 1u);
  EXPECT_TRUE(twice.redundant[0] == 1 || twice.redundant[0] == 4);
  EXPECT_TRUE(twice.contradictory.empty());
  EXPECT_LT((twice.q_rates - once.q_rates).norm(), 1e-9 * once.q_rates.norm());
  // A hair apart is no different.
  points.positions.col(4) += 1e-9 * random.direction<3>();
  const SurfaceMotion hair = surface_motion(blobs, points);
  EXPECT_EQ(hair.rank, 4);
  EXPECT_TRUE(hair.contradictory.empty());
  EXPECT_LT((hair.q_rates - once.q_rates).norm(), 1e-6 * once.q_rates.norm());
}

// Two at one place that ask for different things: the surface goes between, both are named, and the others
// are followed all the same.
TEST(ControlPoints, ContradictoryPoints) {
  Random random(4);
  const auto blobs = three_blobs();
  ControlPoints<3> points = some_points_on(blobs, 3, random);
  const Point<3> outward = -blobs.gradient(points.positions.col(0)).normalized();
  points.add(points.positions.col(0));
  points.velocities.col(0) = 2 * outward;
  points.velocities.col(1) = random.direction<3>();
  points.velocities.col(3) = -1 * outward;
  const SurfaceMotion motion = surface_motion(blobs, points);
  EXPECT_EQ(motion.method, ControlMethod::least_squares);
  EXPECT_EQ(motion.rank, 3);
  EXPECT_EQ(motion.contradictory, (std::vector<Index>{0, 3}));
  EXPECT_TRUE(motion.redundant.empty());
  EXPECT_LT((motion.residuals.cwiseAbs() - Values{{1.5, 0, 0, 1.5}}).norm(), 1e-9);
  EXPECT_LT((motion.residuals - misses(blobs, points, motion.q_rates)).norm(), 1e-9);
  points.velocities.col(0) = 0.5 * outward;  // both at their mean: the same motion, and nobody is missed
  points.velocities.col(3) = 0.5 * outward;
  const SurfaceMotion agreed = surface_motion(blobs, points);
  EXPECT_TRUE(agreed.contradictory.empty());
  EXPECT_LT((agreed.q_rates - motion.q_rates).norm(), 1e-9);
}

// "Our current system does not handle overconstrained surfaces." Ours takes the least squares of the misses.
TEST(ControlPoints, MorePointsThanParameters) {
  Random random(5);
  const ParametricSphere<3> sphere({0, 0, 0}, 1);
  ControlPoints<3> points = some_points_on(sphere, 9, random);
  pull_at_random(points, random);
  const SurfaceMotion motion = surface_motion(sphere, points);
  EXPECT_EQ(motion.method, ControlMethod::least_squares);
  EXPECT_EQ(motion.rank, 4);
  EXPECT_EQ(motion.contradictory.size(), 9u);
  for (int k = 0; k < 20; ++k) {
    Values other = motion.q_rates;
    for (double& each : other) each += 1e-3 * random.normal();
    EXPECT_LT(motion.residuals.norm(), misses(sphere, points, other).norm());
  }
  // All pulled alike the sphere can follow, and five of nine are one too many.
  points.velocities.colwise() = Point<3>(1, 0, 0);
  const SurfaceMotion alike = surface_motion(sphere, points);
  EXPECT_LT((alike.q_rates - Values{{1, 0, 0, 0}}).norm(), 1e-12);
  EXPECT_EQ(alike.redundant.size(), 5u);
  EXPECT_TRUE(alike.contradictory.empty());
  // At rest and on the surface to rounding: nothing moves, and rounding is no contradiction.
  points.velocities.setZero();
  const SurfaceMotion still = surface_motion(sphere, points);
  EXPECT_LT(still.q_rates.norm(), 1e-12);
  EXPECT_TRUE(still.contradictory.empty());
}

// Two points near to each other are pulled apart along the normal: what follows them both is a huge motion.
TEST(ControlPoints, HugeMotionsAreSlowedDown) {
  const ParametricSphere<3> sphere({0, 0, 0}, 1);
  ControlPoints<3> points;
  points.add({1, 0, 0});
  points.add(Point<3>(1, 0.01, 0).normalized());
  points.velocities = Points<3>{{1, -1}, {0, 0}, {0, 0}};
  const SurfaceMotion full = surface_motion(sphere, points, {.largest_speed = 1e9}),
                      slow = surface_motion(sphere, points);
  EXPECT_EQ(full.slowed, 1);
  EXPECT_LT(full.residuals.norm(), 1e-9);
  EXPECT_GT(full.q_rates.norm(), 100);
  // f_q / |f_x| is sqrt 2 everywhere on a sphere, and its box is 2.2 wide.
  EXPECT_NEAR(std::sqrt(2) * slow.q_rates.norm(), 3 * 2.2, 1e-9);
  EXPECT_LT((slow.q_rates - slow.slowed * full.q_rates).norm(), 1e-9);
  EXPECT_LT((slow.residuals - misses(sphere, points, slow.q_rates)).norm(), 1e-9);
  EXPECT_TRUE(slow.contradictory.empty());
}

TEST(Metric, RefusesWhatIsNone) {
  EXPECT_THROW(Metric::diagonal(Values{{1, 0}}), Error);
  EXPECT_THROW(Metric::full(Eigen::MatrixXd{{1, 2}, {2, 1}}), Error);
  EXPECT_THROW(Metric::full(Eigen::MatrixXd{{1, 0.5}, {0, 1}}), Error);
}

// With the sensitivity metric the unit of length does not matter, though positions have it and values do not.
TEST(Metric, BySensitivityKnowsNoUnits) {
  Random random(9);
  ControlPoints<3> small = some_points_on(octahedron(), 3, random), large = small;
  pull_at_random(small, random);
  large.positions = 8 * small.positions;
  large.velocities = 8 * small.velocities;
  const auto here = octahedron();
  Constraints<3> scaled = here.constraints();
  for (auto& each : scaled) each.at *= 8;
  const ParametricInterpolant<3> there(scaled);
  const auto scaled_motion = [&](const ParametricInterpolant<3>& f, const ControlPoints<3>& points,
                                 double unit, const Metric& metric) {
    Values rates = surface_motion(f, points, {.metric = metric}).q_rates;
    for (Index i = 0; i < 7; ++i) rates.segment<3>(f.position_parameter(i)) /= unit;
    return rates;
  };
  const Values a = scaled_motion(here, small, 1, sensitivity_metric<3>(here, small.positions)),
               b = scaled_motion(there, large, 8, sensitivity_metric<3>(there, large.positions));
  EXPECT_LT((a - b).norm(), 1e-9 * a.norm());
  EXPECT_GT((scaled_motion(here, small, 1, {}) - scaled_motion(there, large, 8, {})).norm(), 0.1 * a.norm());
}

}  // namespace
}  // namespace seesaw
