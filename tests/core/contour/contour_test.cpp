// Curves whose length, area and shape are known.
#include "core/contour/contour.h"

#include "core/implicit/primitives.h"
#include "tests/core/contour/test_fields.h"

namespace seesaw {
namespace {

TEST(Contour, CircleHasTheLengthAndAreaOfOne) {
  const Sphere<2> circle({0.1, -0.2}, 1);
  const Box<2> box = box_of(-2, -2, 2, 2);
  const Contour contour = seesaw::contour(circle, box);
  expect_sound(circle, box, contour);
  expect_inside_on_left(circle, contour, 1e-9);
  ASSERT_EQ(contour.components, 1);
  EXPECT_EQ(contour.closed, 1);
  EXPECT_NEAR(contour.length, 2 * M_PI, 3e-4);
  EXPECT_NEAR(contour.area, M_PI, 3e-4);
  EXPECT_DOUBLE_EQ(contour.area, signed_area(contour.polylines[0]));
  EXPECT_EQ(winding_number(contour.polylines, {0.1, -0.2}), 1);
  EXPECT_EQ(winding_number(contour.polylines, {1.2, 0}), 0);
  EXPECT_EQ(contour.nonfinite, 0);
  EXPECT_GE(contour.evaluations, 129 * 129);
  EXPECT_LE(contour.evaluations, 129 * 129 + 2000);
}

TEST(Contour, LengthAndAreaConvergeWithTheSquareOfTheCell) {
  const FunctionField ellipse([](const Point<2>& p) {
    return Jet{1 - p.x() * p.x() / 2.25 - p.y() * p.y(), {-2 * p.x() / 2.25, -2 * p.y()}};
  });
  // The perimeter by the trapezoidal rule, which for a periodic integrand is exact to rounding.
  double perimeter = 0;
  for (int k = 0; k < 4000; ++k)
    perimeter += std::hypot(1.5 * std::sin(k * M_PI / 2000), std::cos(k * M_PI / 2000));
  perimeter *= M_PI / 2000;
  double previous_area = 0, previous_length = 0;
  for (const int cells : {32, 64, 128, 256}) {
    const Contour contour =
        seesaw::contour(ellipse, box_of(-2.03, -2.01, 2, 2), {.cells = cells, .angle_tolerance = 3});
    const double area = std::abs(contour.area - 1.5 * M_PI), length = std::abs(contour.length - perimeter);
    if (previous_area > 0) {
      EXPECT_GT(previous_area / area, 3) << cells;
      EXPECT_GT(previous_length / length, 3) << cells;
    }
    previous_area = area, previous_length = length;
  }
}

TEST(Contour, TurnsByNoMoreThanTheTolerance) {
  // A flat ellipse: at its tips the curve turns 400 times as fast as along its sides.
  const FunctionField ellipse([](const Point<2>& p) {
    return Jet{1 - p.x() * p.x() - 400 * p.y() * p.y(), {-2 * p.x(), -800 * p.y()}};
  });
  const Box<2> box = box_of(-1.3, -1.2, 1.2, 1.3);
  for (const double tolerance : {0.35, 0.175, 0.05}) {
    const Contour contour = seesaw::contour(ellipse, box, {.cells = 32, .angle_tolerance = tolerance});
    expect_sound(ellipse, box, contour);
    ASSERT_EQ(contour.components, 1);
    const Points<2>& v = contour.polylines[0].vertices;
    for (Index i = 0; i < v.cols(); ++i) {
      const Point<2> a = ellipse.gradient(v.col(i)).normalized(),
                     b = ellipse.gradient(v.col((i + 1) % v.cols())).normalized();
      // Leaving out crowded vertices may add a little.
      EXPECT_LE(std::acos(std::min(1.0, a.dot(b))), 1.3 * tolerance) << v.col(i).transpose();
    }
    EXPECT_NEAR(contour.area, M_PI / 20, 0.01 * tolerance);
  }
}

TEST(Contour, AnnulusIsAnOuterCurveAndAHole) {
  const FunctionField annulus([](const Point<2>& p) {
    return minimum(disc(p, {0, 0}, 1), negated(disc(p, {0, 0}, 0.5)));
  });
  const Box<2> box = box_of(-1.5, -1.5, 1.5, 1.5);
  const Contour contour = seesaw::contour(annulus, box, {.cells = 96});
  expect_sound(annulus, box, contour);
  ASSERT_EQ(contour.components, 2);
  std::vector<double> areas = {signed_area(contour.polylines[0]), signed_area(contour.polylines[1])};
  std::sort(areas.begin(), areas.end());
  EXPECT_NEAR(areas[0], -M_PI / 4, 1e-3);
  EXPECT_NEAR(areas[1], M_PI, 1e-3);
  EXPECT_NEAR(contour.area, 0.75 * M_PI, 1e-3);
  EXPECT_EQ(winding_number(contour.polylines, {0.75, 0}), 1);
  EXPECT_EQ(winding_number(contour.polylines, {0, 0}), 0);
}

TEST(Contour, ConcentricRings) {
  // cos of the radius: rings of inside between rings of outside.
  const FunctionField rings([](const Point<2>& p) {
    const double r = p.norm();
    return Jet{std::cos(4 * r), r > 0 ? Point<2>(-4 * std::sin(4 * r) / r * p) : Point<2>(0, 0)};
  });
  const Box<2> box = box_of(-3.01, -3, 3, 3.02);
  const Contour contour = seesaw::contour(rings, box);
  expect_sound(rings, box, contour);
  // r = (2k + 1) pi / 8: 0.39, 1.18, 1.96, 2.75 whole, 3.53 in the four corners.
  EXPECT_EQ(contour.closed, 4);
  EXPECT_EQ(contour.components, 8);
  double closed_area = 0;
  for (const Polyline& polyline : contour.polylines)
    if (polyline.closed) closed_area += signed_area(polyline);
  const double unit = M_PI * M_PI * M_PI / 64;
  EXPECT_NEAR(closed_area, unit * (1 - 9 + 25 - 49), 0.01);
}

TEST(Contour, BoxClipsCurvesExactly) {
  const Sphere<2> circle({0, 0}, 1);
  // A quarter of the disc, its center in the corner of the box.
  const Box<2> quarter = box_of(0, 0, 1.3, 1.7);
  const Contour contour = seesaw::contour(circle, quarter);
  expect_sound(circle, quarter, contour);
  ASSERT_EQ(contour.components, 1);
  EXPECT_EQ(contour.closed, 0);
  EXPECT_NEAR(contour.area, M_PI / 4, 1e-4);
  EXPECT_NEAR(contour.length, M_PI / 2, 1e-4);
  const Points<2>& v = contour.polylines[0].vertices;
  // Inside on the left: from the x axis to the y axis.
  EXPECT_LT((v.col(0) - Point<2>(1, 0)).norm(), 1e-12);
  EXPECT_LT((v.col(v.cols() - 1) - Point<2>(0, 1)).norm(), 1e-12);

  // Cut four times: the box pokes out in the corners only.
  const Box<2> tight = box_of(-0.8, -0.8, 0.8, 0.8);
  const Contour four = seesaw::contour(circle, tight);
  expect_sound(circle, tight, four);
  EXPECT_EQ(four.components, 4);
  const double segment = std::acos(0.8) - 0.8 * 0.6;  // of the circle beyond x = 0.8
  EXPECT_NEAR(four.area, M_PI - 4 * segment, 1e-4);

  // The complement, so that the box's own corners are inside.
  const FunctionField outside([](const Point<2>& p) { return negated(disc(p, {0, 0}, 1)); });
  EXPECT_NEAR(seesaw::contour(outside, tight).area, 2.56 - (M_PI - 4 * segment), 1e-4);
  // Nothing but inside; nothing but outside.
  EXPECT_DOUBLE_EQ(seesaw::contour(circle, box_of(-0.5, -0.5, 0.5, 0.5)).area, 1);
  EXPECT_EQ(seesaw::contour(circle, box_of(2, 2, 3, 3)).area, 0);
}

TEST(Contour, LongBoxesHaveSquareCells) {
  const Sphere<2> circle({5, 0.5}, 0.3);
  const Box<2> box = box_of(0, 0, 10, 1);
  const Contour contour = seesaw::contour(circle, box, {.cells = 200});
  expect_sound(circle, box, contour);
  EXPECT_EQ(contour.components, 1);
  EXPECT_LT(contour.evaluations, 201 * 21 + 2000);
}

TEST(Contour, CornersOfTheCurveAreFoundClosely) {
  // The intersection of four half planes, turned so that nothing is on the lattice.
  const FunctionField square([](const Point<2>& p) {
    Jet jet{1e9, {0, 0}};
    for (int k = 0; k < 4; ++k) {
      const Point<2> normal(std::cos(0.3 + k * M_PI / 2), std::sin(0.3 + k * M_PI / 2));
      jet = minimum(jet, Jet{0.25 - (p - Point<2>(0.5123, 0.4877)).dot(normal), -normal});
    }
    return jet;
  });
  const Box<2> box = box_of(0, 0, 1, 1);
  const Contour contour = seesaw::contour(square, box, {.cells = 64});
  expect_sound(square, box, contour);
  EXPECT_EQ(contour.components, 1);
  EXPECT_NEAR(contour.length, 2, 1e-5);
  EXPECT_NEAR(contour.area, 0.25, 1e-9);
}

TEST(Contour, IsolinesAreContoursOfTheirLevels) {
  const Sphere<2> circle({0, 0}, 1);
  const Box<2> box = box_of(-2, -2, 2, 2);
  const std::vector<double> levels = {-0.5, 0, 0.25, 0.75, 2};
  const std::vector<Contour> lines = isolines(circle, box, levels, {.cells = 64});
  ASSERT_EQ(lines.size(), levels.size());
  for (std::size_t k = 0; k + 1 < levels.size(); ++k) {
    expect_sound(circle, box, lines[k], levels[k]);
    EXPECT_NEAR(lines[k].length, 2 * M_PI * (1 - levels[k]), 2e-3);
    const Contour alone = contour(circle, box, {.cells = 64, .level = levels[k]});
    ASSERT_EQ(alone.vertices, lines[k].vertices);
    EXPECT_EQ(alone.polylines[0].vertices, lines[k].polylines[0].vertices);
  }
  EXPECT_EQ(lines.back().components, 0);
  EXPECT_TRUE(isolines(circle, box, {}).empty());
}

TEST(Contour, ProgressRisesAndCancels) {
  const Sphere<2> circle({0, 0}, 1);
  const Box<2> box = box_of(-2, -2, 2, 2);
  double last = 0;
  contour(circle, box, {.cells = 512}, [&](double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
    return true;
  });
  EXPECT_EQ(last, 1);
  EXPECT_THROW(contour(circle, box, {}, [](double) { return false; }), Cancelled);
}

TEST(Contour, HeaderExample) {
  // One call for the common case.
  const Sphere<2> circle({0, 0}, 1);
  const Contour contour = seesaw::contour(circle, box_of(-2, -2, 2, 2), points_of({{1, 0}, {0, 1}}));
  EXPECT_EQ(contour.seeds_on_curve, 2);
  EXPECT_NEAR(contour.area, M_PI, 1e-3);
}

}  // namespace
}  // namespace seesaw
