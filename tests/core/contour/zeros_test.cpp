// Values exactly zero at lattice corners, on lattice edges and in whole cells: the normal case.
#include "tests/core/contour/test_fields.h"

namespace seesaw {
namespace {

TEST(ExactZeros, CircleThroughLatticeCorners) {
  // Radius 5 about a corner of a unit lattice: zero at (5, 0), (3, 4), (4, 3) and their mirror images.
  const FunctionField field([](const Point<2>& p) { return disc(p, {0, 0}, 5); });
  const Box<2> box = box_of(-8, -8, 8, 8);
  for (const int cells : {16, 32, 64}) {
    const Contour contour = seesaw::contour(field, box, {.cells = cells});
    expect_sound(field, box, contour);
    expect_inside_on_left(field, contour, 1e-9);
    ASSERT_EQ(contour.components, 1);
    EXPECT_EQ(contour.closed, 1);
    EXPECT_NEAR(contour.area, 25 * M_PI, 40.0 / cells);
    // The zero corners themselves are vertices, once each.
    for (const Point<2>& corner : {Point<2>(5, 0), Point<2>(3, 4), Point<2>(-4, 3), Point<2>(0, -5)}) {
      int count = 0;
      for (Index i = 0; i < contour.vertices; ++i) count += contour.polylines[0].vertices.col(i) == corner;
      EXPECT_EQ(count, 1) << corner.transpose() << " at " << cells;
    }
  }
}

TEST(ExactZeros, CircleTouchingTheBox) {
  const FunctionField field([](const Point<2>& p) { return disc(p, {0, 0}, 5); });
  const Box<2> box = box_of(-5, -5, 5, 5);
  for (const int cells : {10, 20}) {
    const Contour contour = seesaw::contour(field, box, {.cells = cells});
    expect_sound(field, box, contour);
    // Whether the circle counts as cut in four or as whole, it is all there.
    EXPECT_NEAR(contour.length, 10 * M_PI, 0.2);
    EXPECT_NEAR(contour.area, 25 * M_PI, 1);
  }
}

TEST(ExactZeros, SaddleOnALatticeCorner) {
  for (const double sign : {1.0, -1.0}) {
    const FunctionField field([&](const Point<2>& p) {
      return Jet{sign * p.x() * p.y(), {sign * p.y(), sign * p.x()}};
    });
    const Box<2> box = box_of(-1, -1, 1, 1);
    for (const int cells : {1, 2, 8, 16, 17, 32}) {
      const Contour contour = seesaw::contour(field, box, {.cells = cells});
      expect_sound(field, box, contour);
      // Two curves of length 2 that touch in the saddle, or miss it by the finest triangle.
      EXPECT_EQ(contour.components, 2);
      EXPECT_EQ(contour.closed, 0);
      EXPECT_NEAR(contour.length, 4, 1e-3) << cells;
      EXPECT_NEAR(contour.area, 2, 1e-6) << cells;
    }
  }
}

TEST(ExactZeros, WholeLatticeEdgesOfZeros) {
  // Products of lattice lines: every line is a run of zero edges, every crossing a node.
  const auto lines = [](const std::vector<double>& xs, const std::vector<double>& ys) {
    return FunctionField([=](const Point<2>& p) {
      Jet jet{1, {0, 0}};
      for (const double x : xs) jet = product(jet, {p.x() - x, {1, 0}});
      for (const double y : ys) jet = product(jet, {p.y() - y, {0, 1}});
      return jet;
    });
  };
  const Box<2> box = box_of(0, 0, 8, 8);
  {
    const FunctionField field = lines({3}, {});
    const Contour contour = seesaw::contour(field, box, {.cells = 8});
    expect_sound(field, box, contour);
    ASSERT_EQ(contour.components, 1);
    EXPECT_DOUBLE_EQ(contour.length, 8);
    EXPECT_DOUBLE_EQ(contour.area, 40);
    // Inside is x > 3, on the left of a curve that runs down.
    EXPECT_EQ(contour.polylines[0].vertices.col(0), Point<2>(3, 8));
  }
  {
    const FunctionField field = lines({2, 5}, {4});
    const Contour contour = seesaw::contour(field, box, {.cells = 8});
    expect_sound(field, box, contour);
    EXPECT_DOUBLE_EQ(contour.length, 24);
    EXPECT_DOUBLE_EQ(contour.area, 4 * 3 + 4 * 2 + 4 * 3);
  }
  {
    // Squared factors: f touches zero along x = 3. Where the rest is positive nothing shows (f >= 0
    // throughout), where it is negative there would be a line with nothing inside it.
    const FunctionField field = lines({3, 3}, {4});
    const Contour contour = seesaw::contour(field, box, {.cells = 8});
    expect_sound(field, box, contour);
    EXPECT_DOUBLE_EQ(contour.length, 8);
    EXPECT_DOUBLE_EQ(contour.area, 32);
    EXPECT_EQ(contour.components, 1);
  }
}

TEST(ExactZeros, LinesTouchedFromBelowAreNoCurve) {
  const Box<2> box = box_of(-1, -1, 1, 1);
  const FunctionField line([](const Point<2>& p) { return Jet{-p.x() * p.x(), {-2 * p.x(), 0}}; });
  // A circle of zeros; some lattice corners happen to be exactly zero.
  const FunctionField ring([](const Point<2>& p) {
    const Jet d = disc(p, {0, 0}, 0.625);
    return negated(product(d, d));
  });
  // A disc with a hair: zero along the positive x axis out to the box.
  const FunctionField hair([](const Point<2>& p) {
    const Jet d = disc(p, {0, 0}, 0.5);
    const Jet h = p.x() > 0 ? Jet{-p.y() * p.y(), {0, -2 * p.y()}} : Jet{-p.squaredNorm(), -2 * p};
    return maximum(d, h);
  });
  for (const int cells : {8, 16, 31}) {
    EXPECT_EQ(contour(line, box, {.cells = cells}).components, 0) << cells;
    const Contour seeded = contour(line, box, points_of({{0, 0.125}, {0, 0.3}}), {.cells = cells});
    EXPECT_EQ(seeded.components, 0);
    EXPECT_EQ(seeded.seeds_off_curve, 2) << cells;
    EXPECT_EQ(contour(ring, box, {.cells = cells}).components, 0) << cells;
    const Contour with_hair = contour(hair, box, {.cells = cells});
    expect_sound(hair, box, with_hair);
    ASSERT_EQ(with_hair.components, 1) << cells;
    EXPECT_EQ(with_hair.closed, 1);
    EXPECT_NEAR(with_hair.length, M_PI, 0.05);
    EXPECT_NEAR(with_hair.area, M_PI / 4, 0.03);
  }
}

TEST(ExactZeros, IsolatedZerosAreNoCurve) {
  const Box<2> box = box_of(-1, -1, 1, 1);
  for (const double sign : {1.0, -1.0}) {
    const FunctionField field([&](const Point<2>& p) { return Jet{sign * p.squaredNorm(), sign * 2 * p}; });
    for (const int cells : {1, 2, 7, 16}) {
      const Contour contour = seesaw::contour(field, box, points_of({{0, 0}}), {.cells = cells});
      EXPECT_EQ(contour.components, 0);
      EXPECT_EQ(contour.seeds_off_curve, 1);
      EXPECT_EQ(contour.seeds_lost, 0);
      EXPECT_DOUBLE_EQ(contour.area, sign > 0 ? 4 : 0);
    }
  }
  // In the corner of the box, too.
  const FunctionField corner([](const Point<2>& p) { return Jet{-p.squaredNorm(), -2 * p}; });
  EXPECT_EQ(contour(corner, box_of(0, 0, 1, 1), {.cells = 4}).components, 0);
}

TEST(ExactZeros, NothingButZeros) {
  const FunctionField zero([](const Point<2>&) { return Jet{0, {0, 0}}; });
  const FunctionField minus_zero([](const Point<2>&) { return Jet{-0.0, {0, 0}}; });
  for (const FunctionField* field : {&zero, &minus_zero}) {
    const Contour contour =
        seesaw::contour(*field, box_of(0, 0, 1, 1), points_of({{0.3, 0.7}, {0, 0}}), {.cells = 16});
    EXPECT_EQ(contour.components, 0);
    EXPECT_EQ(contour.area, 1);
    EXPECT_EQ(contour.seeds_off_curve, 2);
  }
}

TEST(ExactZeros, APlateauHasARim) {
  // Zero in a disc, negative around it: zero is inside, so the disc is.
  const FunctionField plateau([](const Point<2>& p) {
    const double r = p.norm();
    return r <= 0.5 ? Jet{0, {0, 0}} : Jet{0.5 - r, -p / r};
  });
  const Box<2> box = box_of(-1, -1, 1, 1);
  const Contour contour = seesaw::contour(plateau, box, {.cells = 64});
  EXPECT_EQ(contour.components, 1);
  EXPECT_EQ(contour.closed, 1);
  EXPECT_NEAR(contour.area, M_PI / 4, 0.06);
}

TEST(ExactZeros, LemniscateIsTwoLoopsWithANode) {
  // (x^2 - y^2) - (x^2 + y^2)^2, area 1. Its node is exactly zero, on a lattice corner or off it.
  const FunctionField lemniscate([](const Point<2>& p) {
    const double x = p.x(), y = p.y(), q = x * x + y * y;
    return Jet{x * x - y * y - q * q, {2 * x - 4 * q * x, -2 * y - 4 * q * y}};
  });
  for (const Box<2>& box : {box_of(-2, -2, 2, 2), box_of(-2.1, -1.9, 2, 2.2)})
    for (const int cells : {16, 33, 64}) {
      const Contour contour =
          seesaw::contour(lemniscate, box, points_of({{0, 0}, {1, 0}, {-1, 0}}), {.cells = cells});
      expect_sound(lemniscate, box, contour);
      // One loop crossing or two loops touching: the signs near the node decide, and both are right.
      EXPECT_GE(contour.components, 1);
      EXPECT_LE(contour.components, 2);
      EXPECT_EQ(contour.closed, contour.components);
      EXPECT_NEAR(contour.area, 1, 0.03);
      EXPECT_NEAR(contour.length, 5.244115108584, 0.03);
      EXPECT_EQ(contour.seeds_on_curve, 3);
      EXPECT_LE(farthest(contour, points_of({{0, 0}, {1, 0}, {-1, 0}})), 1e-12);
    }
}

TEST(ExactZeros, CuspEndsInItsTip) {
  // x^3 = y^2, inside to the right; the tip at the origin has no gradient.
  const FunctionField cusp([](const Point<2>& p) {
    return Jet{std::pow(p.x(), 3) - p.y() * p.y(), {3 * p.x() * p.x(), -2 * p.y()}};
  });
  for (const Box<2>& box : {box_of(-1, -1, 1, 1), box_of(-1.1, -0.9, 1, 1.05)}) {
    const Contour contour = seesaw::contour(cusp, box, points_of({{0, 0}}), {.cells = 32});
    expect_sound(cusp, box, contour);
    EXPECT_EQ(contour.components, 1);
    EXPECT_EQ(contour.closed, 0);
    // The area between x = y^(2/3) and the right side of the box.
    const double top = box.max().y(), bottom = box.min().y();
    const auto part = [](double y) { return std::abs(y) - 0.6 * std::pow(std::abs(y), 5.0 / 3); };
    EXPECT_NEAR(contour.area, part(std::min(1.0, top)) + part(bottom), 2e-3);
    EXPECT_EQ(contour.seeds_on_curve, 1);
  }
}

}  // namespace
}  // namespace seesaw
