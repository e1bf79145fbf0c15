// The pairs: who is a neighbor, what neighbors do to each other, and what radii and fates follow.
#include "core/particles/repulsion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <mutex>
#include <set>

#include "core/base/random.h"
#include "core/particles/adhesion.h"
#include "core/particles/birth_and_death.h"
#include "core/particles/neighbors.h"
#include "core/particles/radii.h"
#include "core/particles/same_sheet.h"
#include "tests/core/particles/test_surfaces.h"

namespace seesaw {
namespace {

// On the unit sphere; radii between 0.05 and 0.05 * spread.
Crowd random_crowd(Index n, double spread, Random& random) {
  Crowd crowd = {Points<3>(3, n), Points<3>(3, n), Values(n)};
  for (Index i = 0; i < n; ++i) {
    crowd.positions.col(i) = crowd.normals.col(i) = random.direction<3>();
    crowd.radii[i] = 0.05 * std::pow(spread, random.uniform());
  }
  return crowd;
}

TEST(Neighbors, EveryPairInReachIsFound) {  // whatever the reaches are: equal, a thousandfold, zero
  Random random(1);
  for (const double spread : {1.0, 3.0, 1000.0, 0.0})
    for (const Index n : {1, 2, 15, 16, 17, 500}) {
      Crowd crowd = random_crowd(n, std::max(spread, 1.0), random);
      if (spread == 0) crowd.radii.setZero();
      const Neighbors neighbors(crowd.positions, crowd.radii);
      std::mutex mutex;
      std::set<std::pair<int, int>> found;
      std::multiset<int> asked;
      neighbors.for_each_leaf([&](std::span<const int> members, std::span<const int> candidates) {
        const std::lock_guard lock(mutex);
        for (const int i : members) {
          asked.insert(i);
          for (const int j : candidates) EXPECT_TRUE(found.insert({i, j}).second) << "twice";
        }
      });
      EXPECT_EQ(asked.size(), static_cast<std::size_t>(n));
      EXPECT_EQ(std::set<int>(asked.begin(), asked.end()).size(), static_cast<std::size_t>(n));
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
          if ((crowd.positions.col(i) - crowd.positions.col(j)).norm() <=
              std::max(crowd.radii[i], crowd.radii[j])) {
            EXPECT_TRUE(found.count({i, j})) << i << ' ' << j;
          }
    }
}

TEST(Neighbors, NearestIsNearest) {
  Random random(2);
  const Points<3> points = random.points_in<3>(Box<3>(Point<3>(0, 0, 0), Point<3>(1, 1, 1)), 300);
  const Neighbors neighbors(points, Values::Zero(300));
  for (Index i = 0; i < 300; ++i) {
    double least = INFINITY, odd = INFINITY;
    for (Index j = 0; j < 300; ++j) {
      const double distance = (points.col(i) - points.col(j)).squaredNorm();
      if (j != i) least = std::min(least, distance);
      if (j != i && j % 2 == 1) odd = std::min(odd, distance);
    }
    EXPECT_EQ(neighbors.nearest_squared(points.col(i), i), least);
    EXPECT_EQ(neighbors.nearest_squared(points.col(i), i, [](int j) { return j % 2 == 1; }), odd);
    EXPECT_EQ(neighbors.nearest_squared(points.col(i)), 0);
  }
  EXPECT_EQ(Neighbors(Points<3>(3, 0), Values(0)).nearest_squared({0, 0, 0}), INFINITY);
}

TEST(SameSheet, KnowsNeighborsFromStrangers) {
  const Point<3> up(0, 0, 1);
  EXPECT_EQ(same_sheet({0.1, 0, 0}, up, up), 1);                   // in a plane
  EXPECT_EQ(same_sheet({0.1, 0, 0.02}, up, -up), 0);               // two sides of a slab
  EXPECT_EQ(same_sheet({0.01, 0, 0.1}, up, up), 0);                // stacked sheets
  EXPECT_NEAR(same_sheet({1, 0, 1}, up, {1, 0, 0}), 0, 0);         // across the inside of a corner's gap
  EXPECT_NEAR(same_sheet({-1, 0, 1}, up, {1, 0, 0}), 0.5, 1e-12);  // a right-angled edge
  // On any circle: positions u and v, seen from its center, with normals u and v (or -u and -v).
  for (const double angle : {0.01, 0.3, 1.0})
    for (const double sign : {1.0, -1.0}) {
      const Point<3> u(1, 0, 0), v(std::cos(angle), std::sin(angle), 0);
      EXPECT_EQ(same_sheet(u - v, sign * u, sign * v), 1);
    }
  Random random(3);
  for (int k = 0; k < 1000; ++k) {  // symmetric, and a number between 0 and 1
    const Point<3> r = random.direction<3>(), a = random.direction<3>(), b = random.direction<3>();
    EXPECT_NEAR(same_sheet(r, a, b), same_sheet(-r, b, a), 1e-15);
    EXPECT_GE(same_sheet(r, a, b), 0);
    EXPECT_LE(same_sheet(r, a, b), 1);
  }
}

TEST(Repulsion, IsMinusTheGradientOfTheEnergy) {  // eq. 9, also its sign; and eq. 13
  Random random(4);
  Crowd crowd = random_crowd(30, 4, random);
  crowd.positions.row(2).setZero();  // a plane: the weight is 1 for every pair
  crowd.normals.colwise() = Point<3>(0, 0, 1);
  crowd.positions *= 0.2;
  const PairSums sums = repulsion(crowd, {.amplitude = 6});
  const double step = 1e-6;
  for (Index i = 0; i < 30; ++i) {
    for (int d = 0; d < 2; ++d) {
      Crowd ahead = crowd, behind = crowd;
      ahead.positions(d, i) += step;
      behind.positions(d, i) -= step;
      const double slope = (repulsion(ahead).energy[i] - repulsion(behind).energy[i]) / (2 * step);
      // The cut at 4.5 radii is a jump of 4e-5 alpha; no pair of this crowd crosses it within a step.
      EXPECT_NEAR(sums.push(d, i), -crowd.radii[i] * crowd.radii[i] * slope, 1e-7);
    }
    Crowd larger = crowd, smaller = crowd;
    larger.radii[i] += step;
    smaller.radii[i] -= step;
    EXPECT_NEAR(sums.own_slope[i], (repulsion(larger).own[i] - repulsion(smaller).own[i]) / (2 * step),
                1e-6 * (1 + sums.own_slope[i]));
  }
}

TEST(Repulsion, BothTermsPushAway) {
  for (const double other : {0.3, 1.0, 5.0}) {
    const Crowd two = {Points<3>{{-0.5, 0.5}, {0, 0}, {0, 0}}, Points<3>{{0, 0}, {0, 0}, {1, 1}},
                       Values{{1.0, other}}};
    const PairSums sums = repulsion(two);
    EXPECT_LT(sums.push(0, 0), 0);
    EXPECT_GT(sums.push(0, 1), 0);
    const double mine = 6 * std::exp(-0.5), theirs = 6 * std::exp(-0.5 / (other * other));
    EXPECT_NEAR(sums.push(0, 0), -(mine + theirs / (other * other)), 1e-12);
    EXPECT_NEAR(sums.energy[0], mine + theirs, 1e-12);
    EXPECT_NEAR(sums.own[0], mine, 1e-12);
  }
}

TEST(Repulsion, DesiredEnergyIsThatOfAPacking) {  // six neighbors two radii away: 6 e^-2 alpha, about 0.8
  Crowd crowd = {Points<3>(3, 1261), Points<3>(3, 1261), Values::Constant(1261, 0.5)};
  Index n = 0;
  for (int a = -20; a <= 20; ++a)
    for (int b = -20; b <= 20; ++b)
      if (std::abs(a + b) <= 20) crowd.positions.col(n++) << a + 0.5 * b, std::sqrt(0.75) * b, 0;
  ASSERT_EQ(n, 1261);
  crowd.normals.colwise() = Point<3>(0, 0, 1);
  const PairSums sums = repulsion(crowd);
  const Index middle = 630;
  ASSERT_EQ(crowd.positions.col(middle).norm(), 0);
  EXPECT_NEAR(sums.push.col(middle).norm(), 0, 1e-12);
  EXPECT_NEAR(sums.own[middle] / 6, 6 * std::exp(-2.0), 0.02);  // and a little from farther rings
  // What the cut at 4.5 radii leaves out: the sum over the whole lattice.
  double whole = 0;
  for (Index i = 0; i < n; ++i)
    if (i != middle) whole += 6 * std::exp(-2 * crowd.positions.col(i).squaredNorm());
  EXPECT_NEAR(sums.own[middle], whole, 6 * 1.2e-5);
  EXPECT_GT(whole, sums.own[middle]);
}

TEST(Repulsion, TheTreeFindsWhatAllPairsFind) {
  Random random(5);
  for (const double spread : {1.0, 4.0, 400.0})
    for (const Index n : {2, 3, 100, 700}) {
      const Crowd crowd = random_crowd(n, spread, random);
      for (const bool mutual : {true, false}) {
        const RepulsionOptions options = {.amplitude = 6, .mutual = mutual};
        const PairSums a = repulsion(crowd, options), b = repulsion_of_all_pairs(crowd, options);
        // Sums of up to n terms in another order.
        const double scale = 1e-15 * static_cast<double>(n);
        EXPECT_LE((a.push - b.push).cwiseAbs().maxCoeff(), scale * (1 + b.push.cwiseAbs().maxCoeff()) * 100);
        EXPECT_LE((a.energy - b.energy).cwiseAbs().maxCoeff(), scale * (1 + b.energy.maxCoeff()));
        EXPECT_LE((a.own_slope - b.own_slope).cwiseAbs().maxCoeff(), scale * (1 + b.own_slope.maxCoeff()));
        EXPECT_LE((a.curvature - b.curvature).cwiseAbs().maxCoeff(), 1e-12 * (1 + b.curvature.maxCoeff()));
        if (n >= 100) {
          EXPECT_GT(b.energy.maxCoeff(), 0);
        }
      }
    }
}

TEST(Repulsion, CurvatureIsThatOfTheSurface) {  // sqrt(k1^2 + k2^2)
  Crowd sphere = {points_on_sphere({0, 0, 0}, 2, 800), Points<3>(3, 800), Values::Constant(800, 0.2)};
  sphere.normals = sphere.positions / 2;
  const Values bends = repulsion(sphere).curvature;
  EXPECT_NEAR(bends.minCoeff(), std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(bends.maxCoeff(), std::sqrt(0.5), 1e-9);
}

TEST(Radii, FollowTheEnergy) {  // eq. 10 to first order in the time step
  const RadiusRule rule = {.gain = 15, .desired_energy = 4.8, .softening = 0, .largest = 10};
  const Values radii{{0.5, 0.5}}, own{{4.0, 5.5}}, slope{{30, 40}};
  const double step = 1e-4;
  const Values next = next_radii(radii, own, slope, rule, step);
  for (int i = 0; i < 2; ++i)  // dD = D_sigma dsigma = -rho (D - E) step
    EXPECT_NEAR(slope[i] * (next[i] - radii[i]), -15 * (own[i] - 4.8) * step, 1e-12);
  // Alone: no slope, no infinity. Crowded: no collapse in a step.
  const Values bounded =
      next_radii(Values{{0.5, 0.5}}, Values{{0.0, 600.0}}, Values{{0.0, 1.0}},
                 {.gain = 15, .desired_energy = 4.8, .softening = 10, .largest = 10}, 0.03);
  EXPECT_NEAR(bounded[0], 0.5 + 0.03 * 15 * 4.8 / 10, 1e-12);
  EXPECT_EQ(bounded[1], 0.25);
}

TEST(Fates, AreThePapers) {  // section 4.4, one floater a rule
  const LifeRule rule = {.equilibrium_speed = 4, .largest = 2, .energized = 0.96, .death_radius = 0.7};
  const auto fate = [&](double radius, double own, double speed, std::uint64_t seed = 1) {
    Random random(seed);
    return fates(Values{{radius}}, Values{{1.0}}, Values{{own}}, Values{{speed}}, rule, random)[0];
  };
  EXPECT_EQ(fate(1.1, 1.0, 0), Fate::divides);
  EXPECT_EQ(fate(1.1, 1.0, 4.5), Fate::stays);  // too fast
  EXPECT_EQ(fate(1.1, 0.9, 0), Fate::stays);    // not energized
  EXPECT_EQ(fate(2.1, 0.0, 0), Fate::divides);  // huge
  EXPECT_EQ(fate(0.9, 1.0, 0), Fate::stays);
  EXPECT_EQ(fate(0.71, 9.0, 0), Fate::stays);
  // Crowded: dies with probability 1 - radius / (0.7 desired). 2000 throws: within 4 standard deviations.
  for (const double radius : {0.1, 0.35, 0.6}) {
    int dead = 0;
    for (std::uint64_t seed = 0; seed < 2000; ++seed) dead += fate(radius, 9, 0, seed) == Fate::dies;
    const double p = 1 - radius / 0.7;
    EXPECT_NEAR(dead, 2000 * p, 4 * std::sqrt(2000 * p * (1 - p)));
  }
}

TEST(Adhesion, KeepsTheConstraint) {  // eq. 3: f_x . p' + f_t + phi f = 0, and p' - P along f_x (eq. 4)
  Random random(6);
  const Torus torus({0, 0, 0}, {0, 0, 1}, 1, 0.4);
  const Points<3> at = random.points_in<3>(torus.bounding_box(), 50);
  Points<3> desired(3, 50);
  Values rates(50);
  for (Index i = 0; i < 50; ++i) desired.col(i) = random.direction<3>(), rates[i] = random.normal();
  const Contact contact = touch(torus, at);
  const Points<3> velocity = along(contact, desired) + following(contact, rates, 15);
  for (Index i = 0; i < 50; ++i) {
    const Point<3> g = contact.gradients.col(i), change = velocity.col(i) - desired.col(i);
    EXPECT_NEAR(g.dot(velocity.col(i)) + rates[i] + 15 * contact.values[i], 0, 1e-12);
    EXPECT_NEAR(g.cross(change).norm(), 0, 1e-12);
  }
}

TEST(Adhesion, NewtonStopsAtItsLeash) {
  const Sphere<3> sphere({0, 0, 0}, 1);
  const Points<3> at{{1.2, 1.2, 0, 1}, {0, 0, 0, 0}, {0, 0, 0, 0}};
  const PutOn put = put_on(sphere, at, Values{{0.3, 0.1, 2, 0.1}}, Values::Constant(4, 1e-9));
  EXPECT_TRUE(put.on[0]);
  EXPECT_NEAR(put.positions(0, 0), 1, 1e-9);
  EXPECT_NEAR(put.moved[0], 0.2, 1e-9);
  EXPECT_FALSE(put.on[1]);  // 0.2 away on a leash of 0.1: left where it was
  EXPECT_EQ(put.positions(0, 1), 1.2);
  EXPECT_FALSE(put.on[2]);  // no gradient at the center
  EXPECT_TRUE(put.on[3]);
  // Far outside a blobby f is flat: Newton overshoots, and comes back by halves.
  const BlobbySpheres<3> blob(0.3, Point<3>(0, 0, 0), Values{{1.0}});
  const PutOn from_afar = put_on(blob, Point<3>(2.2, 0, 0), Values{{5.0}}, Values{{1e-9}});
  ASSERT_TRUE(from_afar.on[0]);
  EXPECT_NEAR(from_afar.positions.col(0).norm(), std::sqrt(-std::log(0.3)), 1e-8);
}

}  // namespace
}  // namespace seesaw
