#include "core/implicit/primitives.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "tests/support/differences.h"

namespace seesaw {
namespace {

TEST(Sphere, IsThePapersExample) {  // f(x) = 1 - |x|, T&O 2002, section 2.1
  const Sphere<3> sphere(Point<3>::Zero(), 1);
  EXPECT_EQ(sphere.value({0, 0, 0}), 1);
  EXPECT_EQ(sphere.value({0, 0, 3}), -2);
  EXPECT_EQ(sphere.value({0.6, 0, 0.8}), 0);
  EXPECT_EQ(sphere.gradient({0, 2, 0}), Point<3>(0, -1, 0));  // inward
  EXPECT_EQ(sphere.gradient({0, 0, 0}), Point<3>(0, 0, 0));   // where there is none
}

TEST(Sphere, GradientAndItsBound) {
  Random random(1);
  const Sphere<2> circle({3, -1}, 2);
  for (int i = 0; i < 50; ++i) {
    const Point<2> x = random.points_in<2>(circle.bounding_box(), 1).col(0);
    expect_gradient_matches_differences<2>(circle, x, 1e-6, 1e-8);
  }
  expect_gradient_bound_holds<2>(circle, circle.bounding_box(), 1000, random);
  EXPECT_TRUE(circle.bounding_box().contains(Point<2>(5, -1)));
}

}  // namespace
}  // namespace seesaw
