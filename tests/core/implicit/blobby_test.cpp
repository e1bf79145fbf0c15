#include "core/implicit/blobby.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/implicit/torus.h"
#include "tests/support/differences.h"

namespace seesaw {
namespace {

BlobbySpheres<3> random_blobs(Random& random, Index n, double threshold) {
  const Points<3> centers = random.points_in<3>(Box<3>(Point<3>::Constant(-1), Point<3>::Constant(1)), n);
  Values deviations(n);
  for (Index i = 0; i < n; ++i) deviations[i] = random.uniform(0.2, 1);
  return {threshold, centers, deviations};
}

TEST(BlobbySpheres, OneIsASphere) {
  const BlobbySpheres<3> blob(0.3, Point<3>(1, 2, 3), Values{{BlobbySpheres<3>::deviation_for(1.5, 0.3)}});
  Random random(1);
  for (int i = 0; i < 20; ++i) {
    const Point<3> out = random.direction<3>();
    EXPECT_NEAR(blob.value(Point<3>(1, 2, 3) + 1.5 * out), 0, 1e-15);
    EXPECT_GT(blob.value(Point<3>(1, 2, 3) + 1.4 * out), 0);  // positive inside
    EXPECT_LT(blob.gradient(Point<3>(1, 2, 3) + 1.5 * out).dot(out), 0);
  }
  EXPECT_EQ(blob.value({1e9, 0, 0}), -0.3);  // eq. 2 with its minus sign: nothing grows
}

TEST(BlobbySpheres, SumIsNotTheUnion) {  // section 8.2: two of radius 1 side by side bulge out of both
  const double s = BlobbySpheres<3>::deviation_for(1, 0.5);
  const BlobbySpheres<3> two(0.5, Points<3>{{-0.5, 0.5}, {0, 0}, {0, 0}}, Values{{s, s}});
  EXPECT_GT(two.value({1.55, 0, 0}), 0);
  EXPECT_GT(two.value({0, 1.0, 0}), 0);  // each sphere alone ends at sqrt(3) / 2 there
}

TEST(BlobbySpheres, GradientAndItsBound) {
  Random random(2);
  for (int i = 0; i < 30; ++i) {
    const BlobbySpheres<3> blobs = random_blobs(random, 1 + i % 5, 0.5);
    const Point<3> x = random.points_in<3>(blobs.bounding_box(), 1).col(0);
    expect_gradient_matches_differences<3>(blobs, x, 1e-5, 1e-7, 1e-2);
    for (const double size : {2.0, 0.3, 0.03}) {
      const Box<3> box(x - Point<3>::Constant(size), x + Point<3>::Constant(size));
      expect_gradient_bound_holds<3>(blobs, box, 200, random);
    }
    // The bound closes in on the gradient as the box shrinks.
    const Box<3> tiny(x - Point<3>::Constant(1e-6), x + Point<3>::Constant(1e-6));
    EXPECT_NEAR(blobs.gradient_bound(tiny), blobs.gradient(x).norm(), 1e-3);
  }
}

TEST(BlobbySpheres, TheBoxHoldsTheSolid) {
  Random random(3);
  for (const double threshold : {1e-6, 0.1, 0.9, 2.5}) {
    const BlobbySpheres<3> blobs = random_blobs(random, 6, threshold);
    const Box<3> box = blobs.bounding_box();
    const Points<3> around = random.points_in<3>(grown(box, 1.0), 2000);
    for (const auto& x : around.colwise())
      EXPECT_TRUE(box.contains(Point<3>(x)) || blobs.value(x) < 0) << x.transpose();
  }
}

TEST(Torus, IsTheSignedDistance) {
  Random random(4);
  const Torus torus({1, -2, 0.5}, {1, 2, -2}, 2, 0.7);
  EXPECT_EQ(torus.gradient(torus.center()), Point<3>(0, 0, 0));
  for (int i = 0; i < 100; ++i) {
    const Point<3> x = random.points_in<3>(torus.bounding_box(), 1).col(0);
    const Point<3> gradient = torus.gradient(x);
    EXPECT_NEAR(gradient.norm(), 1, 1e-14);
    // Its closest point is on the surface, and nothing on the surface is nearer.
    EXPECT_NEAR(torus.value(x - torus.value(x) * gradient), 0, 1e-14);
    if (std::abs(torus.value(x)) < 0.5) expect_gradient_matches_differences<3>(torus, x, 1e-6, 1e-8);
    const Point<3> other = random.points_in<3>(torus.bounding_box(), 1).col(0);
    EXPECT_LE(std::abs(torus.value(x) - torus.value(other)), (x - other).norm() + 1e-14);
  }
  const Points<3> far = random.points_in<3>(grown(torus.bounding_box(), 1.0), 2000);
  for (const auto& x : far.colwise())
    EXPECT_TRUE(torus.bounding_box().contains(Point<3>(x)) || torus.value(x) < 0) << x.transpose();
}

}  // namespace
}  // namespace seesaw
