// Fields and boxes that mean no good: no hang, no crash, no broken polyline.
#include <cstring>

#include "core/implicit/primitives.h"
#include "tests/core/contour/test_fields.h"

namespace seesaw {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Hostile, NotANumberEverywhere) {
  for (const double value : {nan, infinity, -infinity}) {
    const FunctionField field([&](const Point<2>&) { return Jet{value, {nan, infinity}}; });
    const Contour contour =
        seesaw::contour(field, box_of(0, 0, 1, 1), points_of({{0.5, 0.5}}), {.cells = 16});
    EXPECT_EQ(contour.components, 0);
    EXPECT_EQ(contour.area, 0);
    EXPECT_EQ(contour.nonfinite, contour.evaluations);
    EXPECT_EQ(contour.seeds_off_curve, 1);
  }
}

TEST(Hostile, NotANumberInPlaces) {
  for (const double value : {nan, infinity, -infinity}) {
    const FunctionField half([&](const Point<2>& p) {
      Jet jet = disc(p, {0.5, 0.5}, 0.3);
      if (p.x() > 0.6) jet.f = value;
      return jet;
    });
    const Contour contour = seesaw::contour(half, box_of(0, 0, 1, 1), {.cells = 64});
    ASSERT_EQ(contour.components, 1);
    EXPECT_EQ(contour.closed, 1);
    EXPECT_GT(contour.nonfinite, 0);
    EXPECT_LT(contour.evaluations, 100000);
    EXPECT_TRUE(contour.polylines[0].vertices.allFinite());
    // The part of the disc that is defined, x < 0.6.
    const double cap = 0.09 * std::acos(1.0 / 3) - 0.1 * std::sqrt(0.08);
    EXPECT_NEAR(contour.area, 0.09 * M_PI - cap, 1e-3);
  }
  // One corner of the lattice only.
  const FunctionField one([&](const Point<2>& p) {
    Jet jet = disc(p, {0.5, 0.5}, 0.3);
    if (p == Point<2>(0.5, 0.5)) jet.f = nan;
    return jet;
  });
  const Contour contour = seesaw::contour(one, box_of(0, 0, 1, 1), {.cells = 8});
  EXPECT_NEAR(contour.area, 0.09 * M_PI, 0.01);
  for (const Polyline& polyline : contour.polylines) EXPECT_TRUE(polyline.vertices.allFinite());
}

TEST(Hostile, JumpsAndMissingGradients) {
  const FunctionField step([](const Point<2>& p) {
    return Jet{p.x() + 0.3 * p.y() < 0.71 ? 1.0 : -1.0, {0, 0}};
  });
  const Contour contour = seesaw::contour(step, box_of(0, 0, 1, 1), {.cells = 32});
  ASSERT_EQ(contour.components, 1);
  EXPECT_NEAR(contour.length, std::hypot(1, 0.3), 1e-9);
  const FunctionField cubed([](const Point<2>& p) {
    const Jet d = disc(p, {0.5, 0.5}, 0.3);
    return Jet{d.f * d.f * d.f, 3 * d.f * d.f * d.gradient};
  });
  const Contour flat = seesaw::contour(cubed, box_of(0, 0, 1, 1), {.cells = 32});
  expect_sound(cubed, box_of(0, 0, 1, 1), flat);
  EXPECT_EQ(flat.components, 1);
  EXPECT_NEAR(flat.area, 0.09 * M_PI, 1e-3);
}

TEST(Hostile, WildFieldsStopAtTheLimit) {
  const FunctionField wild([](const Point<2>& p) {
    const double t = 1e6 * p.x() + 3e6 * p.x() * p.y();
    return Jet{std::sin(t), std::cos(t) * Point<2>(1e6 + 3e6 * p.y(), 3e6 * p.x())};
  });
  const Box<2> box = box_of(0, 0, 1, 1);
  const Contour contour = seesaw::contour(wild, box, {.cells = 16, .max_refined_vertices = 5000});
  EXPECT_FALSE(contour.complete);
  for (const Polyline& polyline : contour.polylines)
    if (!polyline.closed) {
      EXPECT_TRUE(on_box_side(box, polyline.vertices.col(0)));
      EXPECT_TRUE(on_box_side(box, polyline.vertices.rightCols<1>()));
    }
}

TEST(Hostile, RoundingNoise) {
  // What a fit with weights of 1e5 leaves: the curve shivers by 1e-10 and must not grow hair.
  const FunctionField noisy([](const Point<2>& p) {
    Jet jet = disc(p, {0.5, 0.5}, 0.3);
    std::uint64_t bits[2];
    std::memcpy(bits, p.data(), sizeof bits);
    Random random(bits[0] * 31 + bits[1]);
    jet.f += 1e-10 * random.uniform(-1, 1);
    return jet;
  });
  const Contour contour = seesaw::contour(noisy, box_of(0, 0, 1, 1), points_of({{0.8, 0.5}, {0.5, 0.2}}));
  EXPECT_EQ(contour.components, 1);
  EXPECT_EQ(contour.seeds_on_curve, 2);
  EXPECT_LT(contour.evaluations, 129 * 129 + 8000);
  EXPECT_NEAR(contour.area, 0.09 * M_PI, 1e-4);
}

TEST(Hostile, BoxesFarAndTiny) {
  struct Case {
    double offset, size;
  };
  for (const Case& c : {Case{1e7, 1},
                        {1e7, 100},
                        {-1e7, 1e-3},
                        {0, 1e-9},
                        {1, 1e-9},
                        {1e-9, 1e-9},
                        {0, 1e-150},
                        {0, 1e150},
                        {1e12, 1e9}}) {
    const Point<2> center(c.offset + 0.5 * c.size, c.offset + 0.5 * c.size);
    const FunctionField field([&](const Point<2>& p) {
      const Point<2> d = p - center;
      const double r = d.norm();
      return Jet{0.3 * c.size - r, r > 0 ? Point<2>(-d / r) : Point<2>(0, 0)};
    });
    const Box<2> box = box_of(c.offset, c.offset, c.offset + c.size, c.offset + c.size);
    const Points<2> seeds =
        points_of({{center.x() + 0.3 * c.size, center.y()}, {center.x(), center.y() - 0.3 * c.size}});
    const Contour contour = seesaw::contour(field, box, seeds, {.cells = 64});
    const double grain = 4e-16 * std::abs(c.offset) / c.size;
    expect_sound(field, box, contour, 0, 1e-12 + 2 * grain);
    ASSERT_EQ(contour.components, 1) << c.offset << ' ' << c.size;
    EXPECT_EQ(contour.seeds_on_curve, 2);
    EXPECT_NEAR(contour.area / (c.size * c.size), 0.09 * M_PI, 1e-3 + 10 * grain);
    EXPECT_LE(farthest(contour, seeds), (1e-9 + 2 * grain) * c.size);
  }
}

TEST(Hostile, BoxesOfAFewRoundings) {
  // At 1e7 doubles are 2e-9 apart: nothing sensible can come of it, but an answer does.
  for (const double size : {1e-6, 1e-8, 4e-9}) {
    const FunctionField field([&](const Point<2>& p) {
      return disc(p, {1e7 + size / 2, 1e7 + size / 2}, 0.3 * size);
    });
    const Contour contour = seesaw::contour(field, box_of(1e7, 1e7, 1e7 + size, 1e7 + size),
                                            points_of({{1e7 + 0.8 * size, 1e7 + size / 2}}));
    for (const Polyline& polyline : contour.polylines) EXPECT_TRUE(polyline.vertices.allFinite());
  }
}

TEST(Hostile, BoxesWithoutRoom) {
  const Sphere<2> circle({0, 0}, 1);
  for (const Box<2>& box :
       {Box<2>(), box_of(0, 0, 0, 1), box_of(0, 0, 1, 0), box_of(0, 0, 0, 0), box_of(0, 0, infinity, 1),
        box_of(nan, 0, 1, 1), box_of(-1e308, -1e308, 1e308, 1e308)}) {
    const Contour contour = seesaw::contour(circle, box, points_of({{1, 0}}));
    EXPECT_EQ(contour.components, 0);
    EXPECT_EQ(contour.evaluations, 0);
    EXPECT_EQ(contour.seeds_outside_box, 1);
  }
}

TEST(Hostile, ThinBoxesAndSingleCells) {
  const Sphere<2> circle({0, 0}, 1);
  const Box<2> thin = box_of(-2, -1e-9, 2, 1e-9);
  const Contour contour = seesaw::contour(circle, thin);
  expect_sound(circle, thin, contour);
  EXPECT_EQ(contour.components, 2);
  const Box<2> box = box_of(-1.7, -1.6, 1.5, 1.8);
  const Contour one = seesaw::contour(circle, box, points_of({{1, 0}}), {.cells = 1});
  expect_sound(circle, box, one);
  EXPECT_EQ(one.components, 1);
  EXPECT_NEAR(one.area, M_PI, 0.05);
}

}  // namespace
}  // namespace seesaw
