// No component through a constraint is lost, at any resolution.
#include "tests/core/contour/test_fields.h"

namespace seesaw {
namespace {

TEST(Seeds, AreVerticesOfTheCurve) {
  const FunctionField field([](const Point<2>& p) { return disc(p, {0.4, 0.55}, 0.3); });
  const Box<2> box = box_of(0, 0, 1, 1);
  Random random(3);
  for (const int cells : {1, 2, 5, 16, 128}) {
    Points<2> seeds(2, 40);
    for (Index i = 0; i < seeds.cols(); ++i) {
      const double angle = random.uniform(0, 2 * M_PI);
      seeds.col(i) = Point<2>(0.4, 0.55) + 0.3 * Point<2>(std::cos(angle), std::sin(angle));
    }
    const Contour contour = seesaw::contour(field, box, seeds, {.cells = cells});
    expect_sound(field, box, contour);
    expect_inside_on_left(field, contour, 1e-7);
    EXPECT_EQ(contour.components, 1) << cells;
    EXPECT_EQ(contour.seeds_on_curve, 40);
    EXPECT_EQ(farthest(contour, seeds), 0);
    ASSERT_FALSE(contour.polylines.empty());
    const Points<2>& v = contour.polylines[0].vertices;
    for (Index s = 0; s < seeds.cols(); ++s) {
      bool found = false;
      for (Index i = 0; i < v.cols(); ++i) found = found || v.col(i) == seeds.col(s);
      EXPECT_TRUE(found) << "seed " << s << " at " << cells;
    }
  }
}

TEST(Seeds, FindACircleAMillionthOfTheBox) {
  Random random(11);
  const Box<2> box = box_of(0, 0, 1, 1);
  for (int trial = 0; trial < 60; ++trial) {
    Point<2> center = random.points_in<2>(box_of(0.05, 0.05, 0.95, 0.95), 1);
    if (trial % 3 == 1) center = (center * 16).array().round() / 16;           // on a lattice corner
    if (trial % 3 == 2) center.x() = std::round(center.x() * 16) / 16 + 1e-6;  // its seed on a lattice line
    const bool hole = trial % 2 == 1;
    const FunctionField field([&](const Point<2>& p) {
      const Jet jet = disc(p, center, 1e-6);
      return hole ? negated(jet) : jet;
    });
    const Point<2> seed = trial % 3 == 2 ? Point<2>(center - Point<2>(1e-6, 0))
                                         : Point<2>(center + 1e-6 * random.direction<2>());
    const Contour contour = seesaw::contour(field, box, seed, {.cells = 16, .find_hidden = false});
    expect_sound(field, box, contour);
    ASSERT_EQ(contour.components, 1) << trial;
    EXPECT_EQ(contour.closed, 1);
    EXPECT_EQ(contour.seeds_on_curve, 1);
    EXPECT_NEAR(signed_area(contour.polylines[0]), (hole ? -1 : 1) * M_PI * 1e-12, 0.02e-12);
    EXPECT_NEAR(contour.length, 2e-6 * M_PI, 0.02e-6);
    EXPECT_LT(contour.evaluations, 5000);
  }
}

TEST(Seeds, FindASmallCircleBesideALargeCurve) {
  // The small circle nearly touches a line whose gradient points the same way at the seed.
  for (const double size : {1e-3, 1e-5, 1e-7})
    for (const double gap : {0.1, 2.0}) {
      const FunctionField field([&](const Point<2>& p) {
        const Jet line{0.37 - p.y(), {0, -1}};
        Jet circle = disc(p, {0.61, 0.37 + (1 + gap) * size}, size);
        circle.f /= 2 * size, circle.gradient /= 2 * size;
        return maximum(line, circle);
      });
      const Points<2> seeds = points_of({{0.61, 0.37 + (2 + gap) * size}, {0.2, 0.37}});
      const Box<2> box = box_of(0, 0, 1, 1);
      const Contour contour = seesaw::contour(field, box, seeds, {.cells = 16, .find_hidden = false});
      expect_sound(field, box, contour);
      EXPECT_EQ(contour.components, 2) << size << ' ' << gap;
      EXPECT_EQ(contour.closed, 1);
    }
}

TEST(Seeds, KeepThinSheetsApart) {
  // A band 1e-5 wide around a curved line, in a lattice of cells 1600 times as wide.
  const double half = 0.5e-5;
  const FunctionField band([&](const Point<2>& p) {
    const double u = p.y() - 0.3 * p.x() - 0.31 - 0.05 * std::sin(6 * p.x());
    const double slope = 0.3 + 0.3 * std::cos(6 * p.x());
    return Jet{half * half - u * u, {2 * u * slope, -2 * u}};
  });
  const auto middle = [](double x) { return 0.3 * x + 0.31 + 0.05 * std::sin(6 * x); };
  const Box<2> box = box_of(0.3, 0.4, 0.4, 0.5);
  const Points<2> seeds = points_of({{0.31, middle(0.31) + half}, {0.37, middle(0.37) - half}});
  const Contour contour = seesaw::contour(band, box, seeds, {.cells = 16});
  expect_sound(band, box, contour);
  EXPECT_EQ(contour.components, 2);
  EXPECT_EQ(contour.closed, 0);
  EXPECT_NEAR(contour.area, 0.1 * 2 * half, 1e-9);
}

TEST(Seeds, TellThreeSheetsApart) {
  // u (u^2 - w^2): three sheets between the same corners, of which the lattice sees one.
  const double w = 1e-4;
  const FunctionField sheets([&](const Point<2>& p) {
    const double u = p.y() - 0.2 * p.x() - 0.4031;
    const double slope = 3 * u * u - w * w;
    return Jet{u * (u * u - w * w), {-0.2 * slope, slope}};
  });
  const Box<2> box = box_of(0, 0, 1, 1);
  // One is enough when its sheet is the one seen; then the other two stay unseen together.
  Points<2> seeds(2, 3);
  for (Index k = 0; k < 3; ++k) {
    seeds.col(k) << 0.5, 0.5031 + static_cast<double>(k - 1) * w;
    const Contour contour = seesaw::contour(sheets, box, seeds.col(k), {.cells = 8, .find_hidden = false});
    expect_sound(sheets, box, contour);
    EXPECT_EQ(farthest(contour, seeds.col(k)), 0);
    EXPECT_TRUE(contour.components == 1 || contour.components == 3) << k;
  }
  const Contour contour = seesaw::contour(sheets, box, seeds, {.cells = 8, .find_hidden = false});
  expect_sound(sheets, box, contour);
  EXPECT_EQ(contour.components, 3);
  EXPECT_EQ(farthest(contour, seeds), 0);
}

TEST(Seeds, MakeCornersWhereTheFieldHasCones) {
  // What the kernel |x| does at its center: f = g.x + w |x|. For |w| < |g| a corner, for |w| > |g| a mere
  // point.
  const Point<2> at(0.4321, 0.5678), g(0.6, 0.8);
  const Box<2> box = box_of(0, 0, 1, 1);
  for (const double w : {-0.99999, -0.95, -0.5, 0.3, 0.9, 0.99}) {
    const FunctionField cone([&](const Point<2>& p) {
      const Point<2> d = p - at;
      const double r = d.norm();
      return Jet{g.dot(d) + w * r, r > 0 ? Point<2>(g + w / r * d) : g};
    });
    const Contour contour = seesaw::contour(cone, box, at, {.cells = 16});
    expect_sound(cone, box, contour);
    EXPECT_EQ(contour.components, 1) << w;
    EXPECT_EQ(contour.seeds_on_curve, 1);
    EXPECT_EQ(farthest(contour, at), 0);
  }
  const FunctionField spike([&](const Point<2>& p) {
    const Point<2> d = p - at;
    const double r = d.norm();
    return Jet{g.dot(d) - 1.5 * r, r > 0 ? Point<2>(g - 1.5 / r * d) : g};
  });
  const Contour contour = seesaw::contour(spike, box, at, {.cells = 16});
  EXPECT_EQ(contour.components, 0);
  EXPECT_EQ(contour.seeds_off_curve, 1);
}

TEST(Seeds, OffTheCurveAreMovedToItOrSaidToBeOff) {
  const FunctionField field([](const Point<2>& p) { return disc(p, {0.5, 0.5}, 0.25); });
  const Box<2> box = box_of(0, 0, 1, 1);
  const Points<2> seeds = points_of({{0.75 + 1e-3, 0.5},                             // near: moved
                                     {0.5, 0.5},                                     // far, no gradient
                                     {0.5, 0.6},                                     // far
                                     {1.5, 0.5},                                     // outside
                                     {std::numeric_limits<double>::quiet_NaN(), 0},  // nowhere
                                     {0.5, 0.75},                                    // on
                                     {0.5, 0.75}});                                  // and once more
  const Contour contour = seesaw::contour(field, box, seeds, {.cells = 32});
  expect_sound(field, box, contour);
  EXPECT_EQ(contour.seeds_on_curve, 3);
  EXPECT_EQ(contour.seeds_off_curve, 2);
  EXPECT_EQ(contour.seeds_outside_box, 2);
  EXPECT_EQ(contour.components, 1);
}

TEST(Seeds, OnTheBoxAreEndsOfTheCurve) {
  const FunctionField field([](const Point<2>& p) { return disc(p, {0, 0}, 0.6); });
  const Box<2> box = box_of(0, 0, 1, 1);
  const Points<2> seeds = points_of({{0.6, 0}, {0, 0.6}});
  for (const int cells : {1, 7, 16, 20}) {
    const Contour contour = seesaw::contour(field, box, seeds, {.cells = cells});
    expect_sound(field, box, contour);
    ASSERT_EQ(contour.components, 1);
    EXPECT_EQ(contour.polylines[0].vertices.col(0), seeds.col(0));
    EXPECT_EQ(contour.polylines[0].vertices.rightCols(1), seeds.col(1));
    EXPECT_EQ(contour.seeds_on_curve, 2);
  }
}

TEST(Hidden, SmallComponentsAreClimbedTo) {
  // Gaussian hills whose tops rise above water on discs much smaller than a cell; no seeds.
  Random random(21);
  const Box<2> box = box_of(0, 0, 1, 1);
  for (int trial = 0; trial < 50; ++trial) {
    const Point<2> top = random.points_in<2>(box_of(0.2, 0.2, 0.8, 0.8), 1);
    const double sign = trial % 2 == 0 ? 1 : -1;
    const double radius = std::pow(10.0, -random.uniform(2, 5));
    // Zero at `radius` from the top.
    const double level = std::exp(-radius * radius / 0.02);
    const FunctionField hill([&](const Point<2>& p) {
      const double e = std::exp(-(p - top).squaredNorm() / 0.02);
      return Jet{sign * (e - level), sign * -100 * e * (p - top)};
    });
    const Contour contour = seesaw::contour(hill, box, {.cells = 16});
    // exp(-1e-8) loses half of its digits to the 1 beside it; so does the circle's radius.
    expect_sound(hill, box, contour, 0, 1e-9);
    ASSERT_EQ(contour.components, 1) << trial << ": radius " << radius;
    EXPECT_NEAR(contour.length, 2 * M_PI * radius, 0.02 * radius);
    EXPECT_EQ(signed_area(contour.polylines[0]) > 0, sign > 0);
    EXPECT_EQ(seesaw::contour(hill, box, {.cells = 16, .find_hidden = false}).components <= 1, true);
  }
}

}  // namespace
}  // namespace seesaw
