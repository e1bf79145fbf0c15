#include "core/mesh/polyline.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"

namespace seesaw {
namespace {

Polyline polygon(int n, const Point<2>& center, double radius, bool counter_clockwise = true) {
  Polyline polyline;
  polyline.closed = true;
  polyline.vertices.resize(2, n);
  for (int i = 0; i < n; ++i) {
    const double angle = (counter_clockwise ? 1 : -1) * 6.283185307179586 * i / n;
    polyline.vertices.col(i) = center + radius * Point<2>(std::cos(angle), std::sin(angle));
  }
  return polyline;
}

TEST(Polyline, SquareHasItsAreaLengthAndBox) {
  Polyline square;
  square.closed = true;
  square.vertices.resize(2, 4);
  square.vertices << 0, 2, 2, 0, 0, 0, 3, 3;
  EXPECT_EQ(signed_area(square), 6);
  EXPECT_EQ(length(square), 10);
  EXPECT_EQ(square.segments(), 4);
  EXPECT_EQ(bounding_box(square).max(), Point<2>(2, 3));
  square.closed = false;
  EXPECT_EQ(length(square), 7);
  EXPECT_EQ(square.segments(), 3);
}

TEST(Polyline, ClockwiseAreaIsNegative) {
  EXPECT_NEAR(signed_area(polygon(360, {1, 2}, 3)), M_PI * 9, 2e-3);
  EXPECT_DOUBLE_EQ(signed_area(polygon(36, {1, 2}, 3, false)), -signed_area(polygon(36, {1, 2}, 3)));
}

TEST(Polyline, AreaFarFromTheOriginKeepsItsDigits) {
  const double exact = 0.5 * 100 * std::sin(6.283185307179586 / 100);
  // Coordinates near 1e7 are exact to 1e-9.
  EXPECT_NEAR(signed_area(polygon(100, {1e7, -1e7}, 1)), exact, 1e-8);
}

TEST(Polyline, NothingIsNothing) {
  const Polyline none;
  EXPECT_EQ(signed_area(none), 0);
  EXPECT_EQ(length(none), 0);
  EXPECT_EQ(winding_number(none, {0, 0}), 0);
  EXPECT_TRUE(bounding_box(none).isEmpty());
  EXPECT_EQ(distance(none, {0, 0}), infinity);
  EXPECT_EQ(to_csv({}), "polyline,closed,x,y\n");
}

TEST(Polyline, WindingCountsTurns) {
  EXPECT_EQ(winding_number(polygon(7, {0, 0}, 1), {0.1, 0.2}), 1);
  EXPECT_EQ(winding_number(polygon(7, {0, 0}, 1, false), {0.1, 0.2}), -1);
  EXPECT_EQ(winding_number(polygon(7, {0, 0}, 1), {1.1, 0}), 0);
  // An annulus: the hole's boundary runs clockwise.
  const std::vector<Polyline> annulus = {polygon(50, {0, 0}, 2), polygon(50, {0, 0}, 1, false)};
  EXPECT_EQ(winding_number(annulus, {1.5, 0}), 1);
  EXPECT_EQ(winding_number(annulus, {0.5, 0}), 0);
  // Twice around.
  Polyline twice = polygon(5, {0, 0}, 1);
  for (int i = 0; i < 5; ++i)
    twice.vertices.col(i) << std::cos(2 * 6.283185307179586 * i / 5), std::sin(2 * 6.283185307179586 * i / 5);
  EXPECT_EQ(winding_number(twice, {0, 0}), 2);
}

TEST(Polyline, RaysThroughVerticesCountOnce) {
  Polyline diamond;
  diamond.closed = true;
  diamond.vertices.resize(2, 4);
  diamond.vertices << 1, 0, -1, 0, 0, 1, 0, -1;
  EXPECT_EQ(winding_number(diamond, {0, 0}), 1);
  EXPECT_EQ(winding_number(diamond, {-2, 0}), 0);
  EXPECT_EQ(winding_number(diamond, {-0.5, 1}), 0);
  EXPECT_EQ(winding_number(diamond, {-0.5, -1}), 0);
}

// The side of a long edge on which a point one rounding away lies: integers tell the truth.
TEST(Polyline, WindingIsExactBesideAnEdge) {
  Random random(5);
  int near = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    // Integers below 2^26: differences, their products and their differences are exact in doubles. So the
    // test knows the truth.
    const auto integer = [&] { return static_cast<double>(random.index(1 << 25)); };
    Polyline triangle;
    triangle.closed = true;
    triangle.vertices.resize(2, 3);
    for (int i = 0; i < 3; ++i) triangle.vertices.col(i) << integer(), integer();
    const double t = random.uniform();
    Point<2> p = triangle.vertices.col(0) + t * (triangle.vertices.col(1) - triangle.vertices.col(0));
    p = p.array().round();
    int sides[3];
    for (int i = 0; i < 3; ++i) {
      const Point<2> a = triangle.vertices.col(i), b = triangle.vertices.col((i + 1) % 3);
      const double side = (a.x() - p.x()) * (b.y() - p.y()) - (a.y() - p.y()) * (b.x() - p.x());
      sides[i] = (side > 0) - (side < 0);
    }
    if (sides[0] == 0 || sides[1] == 0 || sides[2] == 0) continue;
    ++near;
    const int expected = sides[0] == sides[1] && sides[1] == sides[2] ? sides[0] : 0;
    // Far away the differences are the same, but products of coordinates have no digits to spare.
    const Point<2> shift(0x1p50, -0x1p51);
    Polyline far = triangle;
    far.vertices.colwise() += shift;
    EXPECT_EQ(winding_number(far, p + shift), expected);
    EXPECT_EQ(winding_number(triangle, p), expected);
  }
  EXPECT_GT(near, 1000);
}

TEST(Polyline, WindingBesideADiagonal) {
  Polyline triangle;  // (12, 12), (24, 24), (12, 24): above the diagonal, counter-clockwise
  triangle.closed = true;
  triangle.vertices.resize(2, 3);
  triangle.vertices << 12, 24, 12, 12, 24, 24;
  const double next = std::nextafter(18.0, 19.0);
  EXPECT_EQ(winding_number(triangle, {18, next}), 1);
  EXPECT_EQ(winding_number(triangle, {next, 18}), 0);
}

TEST(Polyline, DistanceIsToTheNearestSegment) {
  Polyline open;
  open.vertices.resize(2, 3);
  open.vertices << 0, 1, 1, 0, 0, 1;
  EXPECT_DOUBLE_EQ(distance(open, {0.5, 0.25}), 0.25);
  EXPECT_DOUBLE_EQ(distance(open, {2, 0.5}), 1);
  EXPECT_DOUBLE_EQ(distance(open, {0, 1}), 1);
  open.closed = true;
  EXPECT_DOUBLE_EQ(distance(open, {0, 1}), std::sqrt(0.5));
}

TEST(Polyline, CsvHoldsEveryDigit) {
  Polyline a = polygon(3, {0, 0}, 1), b;
  b.vertices.resize(2, 2);
  b.vertices << 0.1, 1, 2, -0.25;
  const std::string text = to_csv({a, b});
  EXPECT_EQ(text.rfind("polyline,closed,x,y\n0,1,1,0\n", 0), 0u);
  EXPECT_NE(text.find("\n1,0,0.10000000000000001,2\n1,0,1,-0.25\n"), std::string::npos);
}

}  // namespace
}  // namespace seesaw
