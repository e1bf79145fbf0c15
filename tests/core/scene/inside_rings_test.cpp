#include "core/scene/inside_rings.h"

#include <gtest/gtest.h>

#include "core/contour/contour.h"
#include "core/implicit/primitives.h"
#include "core/rbf/fit.h"

namespace seesaw {
namespace {

// Counterclockwise positive.
double signed_area(const Points<2>& ring) {
  double sum = 0;
  for (Index i = 0; i < ring.cols(); ++i) {
    const Point<2> a = ring.col(i), b = ring.col((i + 1) % ring.cols());
    sum += a.x() * b.y() - a.y() * b.x();
  }
  return sum / 2;
}

// The rings go around what the contour says is inside, wherever the view cuts it.
TEST(InsideRings, HaveTheAreaThatTheContourMeasures) {
  const Constraints<2> two = {boundary<2>({-1, 0}),    boundary<2>({1, 0.2}), boundary<2>({0, 1}),
                              boundary<2>({0.1, -1}),  interior<2>({0, 0}),   interior<2>({2.4, 0.5}),
                              exterior<2>({1.5, 0.3}), boundary<2>({2, 0.3})};
  const auto f = fit(two).function;
  for (const Box<2>& box :
       {Box<2>(Point<2>(-3, -3), Point<2>(4, 3)), Box<2>(Point<2>(0, 0), Point<2>(1.9, 2)),
        Box<2>(Point<2>(-0.5, -3), Point<2>(0.5, 3)), Box<2>(Point<2>(-3, 0), Point<2>(4, 0.3)),
        Box<2>(Point<2>(-1.2, -1.2), Point<2>(2.2, 0.9))}) {
    const Contour curve = contour(f, box);
    ASSERT_GT(curve.components, 0);
    double area = 0;
    for (const Points<2>& ring : inside_rings(curve.polylines, box)) area += signed_area(ring);
    EXPECT_NEAR(area, curve.area, 1e-9 * box.sizes().prod());
  }
}

TEST(InsideRings, OfADiscAtACornerIsAPieceOfPie) {
  const Sphere<2> disc(Point<2>(0, 0), 1);
  const Box<2> box(Point<2>(0, 0), Point<2>(3, 2));
  const Contour curve = contour(disc, box, {.angle_tolerance = 0.01});
  const auto rings = inside_rings(curve.polylines, box);
  ASSERT_EQ(rings.size(), 1u);
  EXPECT_NEAR(signed_area(rings[0]), M_PI / 4, 1e-3);
}

TEST(InsideRings, OfNoCurveAreNone) {
  EXPECT_TRUE(inside_rings({}, Box<2>(Point<2>(0, 0), Point<2>(1, 1))).empty());
}

}  // namespace
}  // namespace seesaw
