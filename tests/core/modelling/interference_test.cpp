#include "core/modelling/interference.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/implicit/blobby.h"
#include "core/implicit/booleans.h"
#include "core/implicit/primitives.h"
#include "core/implicit/torus.h"
#include "core/modelling/clearance.h"
#include "core/modelling/foot_points.h"
#include "core/modelling/point_tree.h"
#include "core/rbf/fit.h"
#include "tests/core/modelling/models.h"

namespace seesaw {
namespace {

using std::numbers::pi;

// Two spheres of radii r and s whose centers are d apart share two caps.
double lens(double r, double s, double d) {
  return pi * (r + s - d) * (r + s - d) * (d * d + 2 * d * (r + s) - 3 * (r - s) * (r - s)) / (12 * d);
}

TEST(Interference, LensOfTwoSpheres) {
  const Sphere<3> a({0.1, 0.2, 0.3}, 1), b({1.3, 0.2, 0.9}, 0.8);
  const double exact = lens(1, 0.8, std::hypot(1.2, 0.6));
  double width = 9;
  for (const Index evaluations : {30000, 300000, 3000000}) {
    const Interference found = interference(a, b, {.width = 0.01, .evaluations = evaluations});
    EXPECT_TRUE(found.overlap && found.certain);
    EXPECT_LE(found.low, exact);
    EXPECT_GE(found.high, exact);
    EXPECT_LE(found.evaluations, evaluations);
    EXPECT_LT(found.high - found.low, 0.7 * width);  // more work, less doubt
    width = found.high - found.low;
    EXPECT_NEAR(found.volume, exact, 0.06 * width);  // the estimate is far better than the interval
  }
  EXPECT_LT(width, 0.15 * exact);
}

TEST(Interference, SaysWhere) {
  const Sphere<3> a({0, 0, 0}, 1), b({1.5, 0, 0}, 1);
  const Interference found = interference(a, b);
  EXPECT_TRUE(found.where.contains(Box<3>(Point<3>(0.5, -0.66, -0.66), Point<3>(1, 0.66, 0.66))));
  EXPECT_LT(found.where.volume(), 1.3 * 0.5 * 1.323 * 1.323);
  EXPECT_NEAR((found.deepest - Point<3>(0.75, 0, 0)).norm(), 0, 1e-4);
  EXPECT_GT(std::min(a.value(found.deepest), b.value(found.deepest)), 0.2499);
}

TEST(Interference, OneWithinTheOther) {
  const Sphere<3> a({0, 0, 0}, 2);
  const Torus b({0.1, 0, 0}, {0, 0.3, 1}, 1, 0.3);
  const Interference found = interference(a, b);
  const double exact = 2 * pi * pi * 1 * 0.3 * 0.3;
  EXPECT_LE(found.low, exact);
  EXPECT_GE(found.high, exact);
  EXPECT_NEAR(found.volume, exact, 0.01 * exact);
}

TEST(Interference, ApartIsProven) {
  const Interference none = interference(Sphere<3>({0, 0, 0}, 1), Sphere<3>({2.01, 0, 0}, 1));
  EXPECT_TRUE(!none.overlap && none.certain);
  EXPECT_EQ(none.volume, 0);
  EXPECT_EQ(none.high, 0);
  EXPECT_TRUE(none.where.isEmpty());
  // Their boxes do not even meet.
  EXPECT_TRUE(interference(Sphere<3>({0, 0, 0}, 1), Sphere<3>({9, 0, 0}, 1)).certain);
  // Touching spheres cannot be told apart by any finite work, and that is said.
  const Interference touch =
      interference(Sphere<3>({0, 0, 0}, 1), Sphere<3>({2, 0, 0}, 1), {.evaluations = 200000});
  EXPECT_TRUE(!touch.overlap && !touch.certain);
  EXPECT_GT(touch.high, 0);
}

TEST(Interference, OfInterpolants) {
  const auto ball = [](const Point<3>& center) {
    const TriangleMesh mesh = ellipsoid({1, 1, 1}, 12, 8);
    Constraints<3> constraints;
    for (Index i = 0; i < mesh.vertices.cols(); ++i)
      constraints.push_back(boundary<3>(center + mesh.vertices.col(i), Point<3>(mesh.vertices.col(i)), 0.02));
    return fit(constraints, {.condition = false}).function;
  };
  const Interpolant<3> a = ball({0, 0, 0}), b = ball({1.2, 0.3, 0});
  const double exact = lens(1, 1, std::hypot(1.2, 0.3));
  const Interference found = interference(a, b, {.evaluations = 400000});
  EXPECT_TRUE(found.overlap);
  EXPECT_LE(found.low, found.volume);
  EXPECT_GE(found.high, found.volume);
  EXPECT_NEAR(found.volume, exact, 0.01 * exact);  // the interpolants are spheres to within that
  EXPECT_LT(found.error, 0.01 * exact);
  EXPECT_NEAR(found.volume, exact, 4 * found.error + 0.003 * exact);
  // The boolean's own volume, by the same means.
  const Intersection<3> both({borrow<3>(a), borrow<3>(b)});
  const Interference again = interference(both, a, {.evaluations = 400000, .box = found.where});
  EXPECT_NEAR(again.volume, found.volume, 0.005 * exact);
}

TEST(Interference, IsCancelled) {
  EXPECT_THROW(
      interference(Sphere<3>({0, 0, 0}, 1), Sphere<3>({1, 0, 0}, 1), {}, [](double) { return false; }),
      Cancelled);
}

// Distances.

TEST(FootPoints, FirstOrderAndFeet) {
  const Torus torus({0, 0, 0}, {0, 0, 1}, 1, 0.4);
  const BlobbySpheres<3> blob(0.3, Point<3>(0, 0, 0), Values{{BlobbySpheres<3>::deviation_for(1, 0.3)}});
  Random random(1);
  for (int i = 0; i < 30; ++i) {
    const Point<3> x = torus.center() + random.uniform(1.2, 1.6) * random.direction<3>();
    if (std::abs(torus.value(x)) > 0.3) continue;
    // Of a signed distance both are exact.
    EXPECT_NEAR(first_order_distances(torus, x)[0], std::abs(torus.value(x)), 1e-14);
    EXPECT_NEAR(foot_distances(torus, x, 1)[0], std::abs(torus.value(x)), 1e-14);
  }
  for (const double r : {0.7, 0.95, 1.05, 1.5}) {
    const Point<3> x = r * random.direction<3>();
    EXPECT_NEAR(foot_distances(blob, x, 0.3)[0], std::abs(r - 1), 0.01 * std::abs(r - 1));  // two digits
    EXPECT_NEAR(foot_point(blob, x, 1e-13)->norm(), 1, 1e-12);
  }
  // First order is no distance out there: f is flat.
  EXPECT_GT(first_order_distances(blob, Point<3>(3, 0, 0))[0], 20);
  EXPECT_FALSE(
      foot_point(BlobbySpheres<3>(2, Point<3>(0, 0, 0), Values{{1.0}}), {1, 0, 0}, 1e-9).has_value());
}

TEST(Clearance, OfTwoSpheresIsExact) {
  Random random(2);
  for (int i = 0; i < 5; ++i) {
    const Point<3> center = 4 * random.direction<3>();
    const double r = random.uniform(0.3, 1.5), s = random.uniform(0.3, 1.5);
    const Sphere<3> a({1, 1, 1}, r), b(Point<3>(1, 1, 1) + center, s);
    const Clearance found = clearance(a, b);
    EXPECT_NEAR(found.distance, 4 - r - s, 1e-9);
    EXPECT_LE(found.low, 4 - r - s + 1e-12);
    EXPECT_GE(found.low, 4 - r - s - 0.1);
    EXPECT_NEAR(a.value(found.on_a), 0, 1e-11);
    EXPECT_NEAR(b.value(found.on_b), 0, 1e-11);
    EXPECT_NEAR((found.on_a - found.on_b).norm(), found.distance, 1e-12);
  }
}

TEST(Clearance, FindsTheNearestOfManyPlaces) {  // a ring around a ball that is off its middle
  const Torus ring({0, 0, 0}, {0, 0, 1}, 2, 0.5);
  const Sphere<3> ball({0.3, 0.4, 0.2}, 0.7);
  // From the ball's center: the core circle is nearest at hypot(2 - 0.5, 0.2).
  const Clearance found = clearance(ring, ball);
  const double exact = std::hypot(1.5, 0.2) - 0.5 - 0.7;
  EXPECT_NEAR(found.distance, exact, 1e-9);
  EXPECT_LE(found.low, exact);
  EXPECT_LT(clearance(ring, ball, {.width = 0.1}).low, found.low);
}

TEST(Clearance, WithoutASurfaceIsInfinite) {
  const BlobbySpheres<3> nothing(2, Point<3>(0, 0, 0), Values{{1.0}});
  EXPECT_EQ(clearance(nothing, Sphere<3>({5, 0, 0}, 1)).distance, infinity);
}

TEST(Clearance, CrossingSurfacesHaveNone) {
  const Clearance found = clearance(Sphere<3>({0, 0, 0}, 1), Sphere<3>({1, 0, 0}, 1));
  EXPECT_EQ(found.low, 0);
  EXPECT_LT(found.distance, 1e-6);
}

// What a model of the paper's size needs: the huge weights of boundary and normal constraints 0.01 apart must
// not leave proofs without a chance.
TEST(Clearance, ProvesModelsOfManyConstraintsApart) {
  Constraints<3> constraints;
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    const Point<3> direction = random.direction<3>();
    const double radius = 0.5 + 0.1 * std::sin(5 * direction.x());
    constraints.push_back(boundary<3>(radius * direction, direction));
  }
  const auto a = fit(constraints).function;
  for (auto& constraint : constraints) constraint.at.x() += 1.4;
  const auto b = fit(constraints).function;
  const Interference found = interference(a, b);
  EXPECT_FALSE(found.overlap);
  EXPECT_TRUE(found.certain);
  const Clearance gap = clearance(a, b);
  EXPECT_LE(gap.low, gap.distance);
  EXPECT_GT(gap.low, gap.distance - 0.05);
}

TEST(PointTree, FindsWhatLookingAtAllFinds) {
  Random random(4);
  for (const Index n : {0, 1, 8, 9, 500}) {
    std::vector<Point<3>> points;
    // On a lattice, where many are equally near.
    for (Index i = 0; i < n; ++i)
      points.push_back(Point<3>(static_cast<double>(random.index(9)), static_cast<double>(random.index(9)),
                                static_cast<double>(random.index(9))));
    const PointTree tree(points);
    for (int i = 0; i < 200; ++i) {
      const Point<3> at(random.uniform(-4, 13), random.uniform(-4, 13), random.uniform(-4, 13));
      const Point<3> reach(0.5, random.uniform(0, 2), 0);
      PointTree::Nearest expected;
      for (Index k = 0; k < n; ++k) {
        const double distance =
            ((points[static_cast<std::size_t>(k)] - at).cwiseAbs() - reach).cwiseMax(0).norm();
        if (distance < expected.distance) expected = {k, distance};
      }
      const PointTree::Nearest found = tree.nearest(at, reach);
      EXPECT_EQ(found.index, expected.index);
      EXPECT_DOUBLE_EQ(found.distance, expected.distance);
    }
  }
}

}  // namespace
}  // namespace seesaw
