// Floaters on surfaces at rest: even, still, on the surface, the same on every machine and at every scale.
#include "core/particles/floaters.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "core/particles/integrals.h"
#include "core/particles/measures.h"
#include "tests/core/particles/test_surfaces.h"

namespace seesaw {
namespace {

constexpr double densest_on_sphere = sanitized ? 0.05 : 0.0081, densest_on_torus = sanitized ? 0.05 : 0.018;
constexpr int long_time = sanitized ? 500 : 10000;

// At rest, even to `variation`, without gaps, and nobody is born or dies afterwards.
void expect_uniform(Floaters& floaters, const Field<3>& field, const Points<3>& surface, double variation,
                    int afterwards) {
  ASSERT_LT(floaters.equilibrate(field), 1500);
  const FloaterMeasures found = measure(floaters, field);
  EXPECT_LT(found.spacing.variation, variation);
  EXPECT_GT(found.spacing.least, 0.75 * found.spacing.mean);
  // At rest sigma is about 0.9 sigma-hat and neighbors are 1.9 sigma apart.
  EXPECT_NEAR(found.mean_radius / floaters.desired_radii().mean(), 0.91, 0.06);
  EXPECT_NEAR(found.spacing.mean / found.mean_radius, 1.88, 0.1);
  EXPECT_LT(largest_gap(floaters.positions(), surface), 3 * found.mean_radius);
  EXPECT_LT(found.most_off_radii, 1e-3);
  for (int i = 0; i < afterwards; ++i) floaters.step(field);
  EXPECT_EQ(floaters.counts().births, found.counts.births);
  EXPECT_EQ(floaters.counts().deaths, found.counts.deaths);
  EXPECT_EQ(floaters.counts().lost, 0);
}

TEST(Floaters, SphereFromOneSeed) {
  const Sphere<3> sphere({0.3, -0.2, 0.1}, 1);
  for (const double radius : {0.082, sanitized ? 0.04 : 0.026, densest_on_sphere}) {
    Floaters floaters(sphere, {.desired_radius = radius});
    EXPECT_EQ(floaters.size(), 1);
    expect_uniform(floaters, sphere,
                   points_on_sphere({0.3, -0.2, 0.1}, 1, static_cast<Index>(20 / radius / radius)), 0.05,
                   radius > 0.01 ? 300 : 50);
    EXPECT_NEAR(static_cast<double>(floaters.size()) * radius * radius, 0.67, 0.05);  // 100, 1000, 10,000
  }
}

TEST(Floaters, TorusFromOneSeed) {
  const Torus torus({0, 0, 0}, {0, 0, 1}, 1, 0.4);
  for (const double radius : {0.06, sanitized ? 0.055 : 0.03, densest_on_torus}) {
    Floaters floaters(torus, {.desired_radius = radius});
    expect_uniform(floaters, torus, points_on_torus(1, 0.4, static_cast<int>(20 / radius)), 0.05,
                   radius > 0.02 ? 300 : 100);
  }
}

TEST(Floaters, TwoComponentsFromASeedEach) {
  const Union<3> field = two_spheres(1, 0.5, 0.02);
  const Points<3> seeds{{-1, 2.02}, {0, 0}, {0, 0}};
  for (const double radius : {0.05, sanitized ? 0.04 : 0.02}) {
    Floaters floaters(field, seeds, {.desired_radius = radius});
    EXPECT_EQ(floaters.counts().seeded, 2);
    Points<3> surface(3, 40000);
    surface << points_on_sphere({0, 0, 0}, 1, 20000), points_on_sphere({1.52, 0, 0}, 0.5, 20000);
    expect_uniform(floaters, field, surface, 0.12, 300);
    // The same density on both: area over area.
    const Index on_first = (floaters.positions().colwise().norm().array() < 1.01).count();
    EXPECT_NEAR(static_cast<double>(floaters.size() - on_first) / static_cast<double>(on_first), 0.25, 0.03);
  }
}

TEST(Floaters, OneSeedIsOneComponent) {  // a gap a tenth of a radius wide, and nobody crosses it
  for (const double gap : {0.01, 0.1})
    for (const double desired : {0.1, sanitized ? 0.06 : 0.03}) {
      const Union<3> field = two_spheres(1, 1, gap);
      Floaters floaters(field, Point<3>(0, 0, 1), {.desired_radius = desired});
      for (int i = 0; i < 400; ++i) {
        floaters.step(field);
        ASSERT_LT(floaters.positions().colwise().norm().maxCoeff(), 1 + 1e-3) << gap << ' ' << desired;
      }
      EXPECT_LT(largest_gap(floaters.positions(), points_on_sphere({0, 0, 0}, 1, 5000)),
                3 * floaters.radii().mean());  // and the side that faces the other is not bare
    }
}

TEST(Floaters, BothSidesOfASlab) {  // four times thinner than a desired radius
  const Ellipsoid slab({1, 1, 0.03});
  Floaters floaters(slab, {.desired_radius = 0.05});
  floaters.equilibrate(slab);
  const auto z = floaters.positions().row(2).array();
  const double above = static_cast<double>((z > 0.01).count()),
               below = static_cast<double>((z < -0.01).count());
  EXPECT_NEAR(above / below, 1, 0.1);
  EXPECT_GT((above + below) / static_cast<double>(floaters.size()), 0.7);  // the others stand on the rim
  // Each side is a disc of area pi, at the density of a sphere's: 0.67 (2.5)^2 / 4 pi per area and square of
  // the desired radius.
  EXPECT_NEAR(above + below, 2 * 3.14 * 0.333 / std::pow(0.05 * 2.5, 2), 20);
  EXPECT_LT(measure(floaters, slab).spacing.variation, 0.2);
}

TEST(Floaters, ShellsOfOneSolidDoNotMix) {  // a hollow ball: the inner wall is 0.05 from the outer
  const Difference<3> shell(share(Sphere<3>({0, 0, 0}, 1)), share(Sphere<3>({0, 0, 0}, 0.95)));
  Floaters floaters(shell, Point<3>(0.95, 0, 0), {.desired_radius = 0.05});
  for (int i = 0; i < 300; ++i) {
    floaters.step(shell);
    ASSERT_LT(floaters.positions().colwise().norm().maxCoeff(), 0.951);
  }
  EXPECT_LT(largest_gap(floaters.positions(), points_on_sphere({0, 0, 0}, 0.95, 5000)),
            3 * floaters.radii().mean());
  EXPECT_LT(integrals(floaters.crowd()).volume, 0);  // a hole, seen from inside the solid
}

TEST(Floaters, EdgesCanBeCrossed) {  // a right-angled one, and that of a lens: 60 degrees
  const Intersection<3> lens({share(Sphere<3>({0, 0, -0.5}, 1)), share(Sphere<3>({0, 0, 0.5}, 1))});
  const double half = std::sqrt(0.5);
  const Intersection<3> right({share(Sphere<3>({0, 0, -half}, 1)), share(Sphere<3>({0, 0, half}, 1))});
  for (const Field<3>* field : {static_cast<const Field<3>*>(&lens), static_cast<const Field<3>*>(&right)}) {
    Floaters floaters(*field, {.desired_radius = 0.05});
    EXPECT_LT(floaters.equilibrate(*field), 1500);
    const double above = static_cast<double>((floaters.positions().row(2).array() > 0).count());
    EXPECT_NEAR(above / static_cast<double>(floaters.size()), 0.5, 0.1);
    EXPECT_LT(measure(floaters, *field).spacing.variation, 0.12);
  }
}

TEST(Floaters, RestForALongTime) {  // "none drifts over 10^4 steps"
  const Torus torus({0, 0, 0}, {1, 2, 3}, 1, 0.4);
  Floaters floaters(torus, {.desired_radius = 0.1});
  floaters.equilibrate(torus);
  const FloaterCounts counts = floaters.counts();
  double off = 0;
  Points<3> half_way;
  for (int i = 0; i < long_time; ++i) {
    floaters.step(torus);
    if (i % 50 == 0) off = std::max(off, measure(floaters, torus).most_off_radii);
    if (i == long_time / 2) half_way = floaters.positions();
  }
  EXPECT_LT(off, 1e-4);
  EXPECT_EQ(floaters.counts().births, counts.births);
  EXPECT_EQ(floaters.counts().deaths, counts.deaths);
  ASSERT_EQ(floaters.size(), half_way.cols());
  if (long_time >= 10000) {
    EXPECT_LT((floaters.positions() - half_way).colwise().norm().maxCoeff(), 0.1 * floaters.radii().mean());
  }
}

TEST(Floaters, AreTheSameOnOneThread) {
  const Torus torus({0, 0, 0}, {0, 0, 1}, 1, 0.4);
  const auto run = [&](std::uint64_t seed) {
    Floaters floaters(torus, {.desired_radius = 0.03, .seed = seed});
    for (int i = 0; i < 120; ++i) floaters.step(torus);
    return floaters;
  };
  const Floaters on_all = run(1), other = run(2);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const Floaters alone = run(1);
  ASSERT_GT(alone.size(), 500);
  ASSERT_EQ(alone.size(), on_all.size());
  EXPECT_EQ(alone.positions(), on_all.positions());
  EXPECT_EQ(alone.radii(), on_all.radii());
  EXPECT_NE(alone.positions().col(0), other.positions().col(0));  // another seed, other floaters
}

TEST(Floaters, DoNotKnowTheScale) {  // powers of two are exact
  const Torus torus({0, 0, 0}, {0, 0, 1}, 1, 0.4);
  Floaters floaters(torus, {.desired_radius = 0.06});
  for (int i = 0; i < 150; ++i) floaters.step(torus);
  for (const double scale : {0x1p-20, 0x1p20}) {
    const Torus other({0, 0, 0}, {0, 0, 1}, scale, 0.4 * scale);
    Floaters scaled(other, {.desired_radius = 0.06});
    for (int i = 0; i < 150; ++i) scaled.step(other);
    ASSERT_EQ(scaled.size(), floaters.size());
    EXPECT_LT((scaled.positions() / scale - floaters.positions()).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT((scaled.radii() / scale - floaters.radii()).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(Floaters, SimpleRepulsionKeepsItsNumber) {  // section 4.1
  const Sphere<3> sphere({0, 0, 0}, 1);
  Random random(1);
  Points<3> seeds(3, 60);
  for (Index i = 0; i < 60; ++i) seeds.col(i) = random.direction<3>();
  // "The best value for sigma is about .3 sqrt(area / number)."
  const double sigma = 0.3 * std::sqrt(12.566 / 60);
  Floaters floaters(
      sphere, seeds,
      {.repulsion = Repulsion::simple, .desired_radius = 1e-3, .diameter = 1, .simple_radius = sigma});
  ASSERT_GT(floaters.size(), 50);  // seeds that are nearly the same are one
  const Index before = floaters.size();
  const double irregular = measure(floaters, sphere).spacing.variation;
  for (int i = 0; i < 1500; ++i) floaters.step(sphere);
  EXPECT_EQ(floaters.size(), before);
  EXPECT_NEAR(floaters.radii().maxCoeff(), sigma, 1e-12);
  EXPECT_NEAR(floaters.radii().minCoeff(), sigma, 1e-12);
  EXPECT_GT(irregular, 0.3);
  EXPECT_LT(measure(floaters, sphere).spacing.variation, 0.08);
  // Switched to adaptive repulsion, it fills up (Fig. 1).
  floaters.set_options({.desired_radius = 0.05, .diameter = 2.5});
  floaters.equilibrate(sphere);
  EXPECT_NEAR(static_cast<double>(floaters.size()), 0.67 / 0.05 / 0.05, 15);
}

TEST(Floaters, GlobalFissioningDoubles) {  // section 4.2
  const Sphere<3> sphere({0, 0, 0}, 1);
  Floaters floaters(sphere, {.repulsion = Repulsion::global_fissioning, .desired_radius = 0.05});
  Index generation = 1;
  double radius = floaters.radii()[0];
  for (int i = 0; i < 1500; ++i) {
    floaters.step(sphere);
    if (floaters.size() == generation) continue;
    EXPECT_EQ(floaters.size(), 2 * generation);
    EXPECT_NEAR(floaters.radii()[0], radius / std::sqrt(2), 1e-9);
    EXPECT_EQ(floaters.radii().minCoeff(), floaters.radii().maxCoeff());
    generation = floaters.size();
    radius = floaters.radii()[0];
  }
  EXPECT_GE(generation, 128);
  EXPECT_LE(radius, 0.05 * 2.5);
  EXPECT_GT(radius, 0.05 * 2.5 / std::sqrt(2));
  EXPECT_LT(measure(floaters, sphere).spacing.variation, 0.06);
}

TEST(Floaters, DensityByCurvature) {
  const Ellipsoid bean({1, 1, 0.25});  // nearly flat above and below, curved at the rim
  Floaters plain(bean, {.desired_radius = 0.06}), fine(bean, {.desired_radius = 0.06, .turn = 0.5});
  EXPECT_LT(plain.equilibrate(bean), 1500);
  EXPECT_LT(fine.equilibrate(bean), 1500);
  const FloaterCounts counts = fine.counts();
  for (int i = 0; i < (sanitized ? 20 : 200); ++i) fine.step(bean);
  EXPECT_EQ(fine.counts().births, counts.births);  // graded density is at rest, too
  EXPECT_EQ(fine.counts().deaths, counts.deaths);
  EXPECT_GT(fine.size(), plain.size() * 3 / 2);
  const auto radius_where = [](const Floaters& floaters, bool rim) {
    std::vector<Index> found;
    for (Index i = 0; i < floaters.size(); ++i) {
      const double rho = floaters.positions().col(i).head<2>().norm();
      if (rim ? rho > 0.96 : rho < 0.6) found.push_back(i);
    }
    double sum = 0;
    for (const Index i : found) sum += floaters.radii()[i];
    return sum / static_cast<double>(found.size());
  };
  EXPECT_NEAR(radius_where(plain, true) / radius_where(plain, false), 1, 0.1);
  EXPECT_LT(radius_where(fine, true) / radius_where(fine, false), 0.6);
  EXPECT_LT(fine.desired_radii().minCoeff(), 0.6 * fine.desired_radii().maxCoeff());
  EXPECT_GE(fine.desired_radii().minCoeff(), 0.25 * 0.06 * fine.diameter());
}

TEST(Floaters, SeedsAreThinned) {
  const Sphere<3> sphere({0, 0, 0}, 1);
  Points<3> seeds(3, 500);
  seeds << points_on_sphere({0, 0, 0}, 1, 400), points_on_sphere({0, 0, 0}, 3, 100);  // the last lead nowhere
  Floaters floaters(sphere, seeds, {.desired_radius = 0.1});
  EXPECT_GT(floaters.size(), 10);
  EXPECT_LT(floaters.size(), 100);
  EXPECT_GT(spacing_of(floaters.positions()).least, 2 * 0.1 * floaters.diameter());
  EXPECT_EQ(floaters.seed(sphere, seeds), 0);  // all taken
  // Without a usable seed: somewhere.
  EXPECT_EQ(Floaters(sphere, Point<3>(9, 9, 9)).size(), 1);
}

TEST(Floaters, NothingToSample) {
  const BlobbySpheres<3> nothing(2, Point<3>(0, 0, 0), Values{{1.0}});  // f < 0 everywhere
  Floaters floaters(nothing);
  EXPECT_EQ(floaters.size(), 0);
  for (int i = 0; i < 3; ++i) floaters.step(nothing);
  EXPECT_EQ(floaters.size(), 0);
  EXPECT_FALSE(floaters.at_rest());
  EXPECT_EQ(measure(floaters, nothing).floaters, 0);
  EXPECT_EQ(integrals(floaters.crowd()).area, 0);
  EXPECT_EQ(largest_gap(floaters.positions(), Point<3>(0, 0, 0)), INFINITY);
  // A blobby so small in its box that random points miss its gradient: bisection finds it.
  const BlobbySpheres<3> speck(0.5, Points<3>{{0, 1}, {0, 1}, {0, 1}}, Values{{0.05, 0.05}});
  EXPECT_EQ(Floaters(speck).size(), 1);
}

TEST(Floaters, CanBeStopped) {
  const Sphere<3> sphere({0, 0, 0}, 1);
  Floaters floaters(sphere);
  EXPECT_THROW(floaters.equilibrate(sphere, 100, [](double fraction) { return fraction < 0.1; }), Cancelled);
}

}  // namespace
}  // namespace seesaw
