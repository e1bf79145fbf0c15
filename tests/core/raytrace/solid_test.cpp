// CSG along rays against the booleans of the functions, and expressions.
#include <gtest/gtest.h>

#include <string>

#include "core/implicit/booleans.h"
#include "core/implicit/primitives.h"
#include "core/raytrace/csg_expression.h"
#include "core/raytrace/rigorous_tracer.h"
#include "tests/core/raytrace/interpolant_rays.h"

namespace seesaw {
namespace {

Solid leaf(FieldPointer<3> field) { return Solid(std::make_shared<RigorousTracer>(std::move(field))); }

Solid ball(const Point<3>& center, double radius) { return leaf(share(Sphere<3>(center, radius))); }

FieldPointer<3> interpolant(std::uint64_t seed) {
  Random random(seed);
  Constraints<3> constraints;
  for (int i = 0; i < 20; ++i) {
    const Point<3> n = random.direction<3>();
    constraints.push_back(boundary<3>(random.uniform(0.6, 1.1) * n, n, 0.05));
  }
  return std::make_shared<Interpolant<3>>(fit(constraints, {.condition = false}).function);
}

// A point is inside where a ray through it has crossed the surface an odd number of times: 10^4 random points
// of random rays, for each boolean of two interpolants and one that is three deep, against the signs of the
// fields.
TEST(Solid, TenThousandPointsAgreeWithTheBooleansOfTheFunctions) {
  const FieldPointer<3> a = interpolant(1), b = interpolant(2), c = share(Sphere<3>({0.5, 0.2, 0.4}, 0.7));
  const Solid A = leaf(a), B = leaf(b), C = leaf(c);
  const auto in = [](const FieldPointer<3>& f, const Point<3>& p) {
    return f->value(p) >= 0 && f->bounding_box().contains(p);
  };
  struct Case {
    const char* name;
    Solid solid;
    bool (*rule)(bool, bool, bool);
  };
  const Case cases[] = {
      {"A | B", A | B, [](bool x, bool y, bool) { return x || y; }},
      {"A & B", A & B, [](bool x, bool y, bool) { return x && y; }},
      {"A - B", A - B, [](bool x, bool y, bool) { return x && !y; }},
      {"(A - B) | (B & C)", (A - B) | (B & C), [](bool x, bool y, bool z) { return (x && !y) || (y && z); }},
      {"A - (B - C)", A - (B - C), [](bool x, bool y, bool z) { return x && !(y && !z); }},
  };
  for (const Case& each : cases) {
    Random random(5);
    const std::vector<Ray> rays = rays_toward(*a, 1000, random);
    std::vector<SolidCrossings> found(rays.size());
    each.solid.trace(rays, HowMany::all, found);
    int inside = 0, wrong = 0;
    Points<3> asked(3, 10000);
    std::vector<bool> expected;
    for (std::size_t i = 0; i < rays.size(); ++i)
      for (int k = 0; k < 10; ++k) {
        const double t = random.uniform(0, 2 * rays[i].origin.norm());
        const Point<3> p = rays[i].at(t);
        bool crossed = found[i].inside_at_begin;
        for (const SolidCrossing& crossing : found[i].crossings)
          if (crossing.t < t) crossed = !crossed;
        const bool truth = each.rule(in(a, p), in(b, p), in(c, p));
        asked.col(static_cast<Index>(expected.size())) = p;
        expected.push_back(truth);
        inside += truth;
        wrong += crossed != truth;
      }
    EXPECT_EQ(wrong, 0) << each.name;
    EXPECT_GT(inside, 200) << each.name;
    EXPECT_EQ(each.solid.contains(asked), expected) << each.name;
  }
}

// The first crossing is the same whether or not the others are asked for.
TEST(Solid, TheFirstCrossingIsTheFirstOfAll) {
  const Solid solid = (leaf(interpolant(1)) - ball({0.4, 0, 0}, 0.6)) | ball({-1, 0, 0}, 0.3);
  Random random(6);
  const std::vector<Ray> rays = rays_toward(*interpolant(1), 1000, random);
  std::vector<SolidCrossings> all(rays.size()), first(rays.size());
  solid.trace(rays, HowMany::all, all);
  solid.trace(rays, HowMany::first, first);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    ASSERT_EQ(first[i].crossings.size(), std::min<std::size_t>(1, all[i].crossings.size()));
    if (first[i].crossings.empty()) continue;
    EXPECT_EQ(first[i].crossings[0].t, all[i].crossings[0].t);
  }
}

// Where surfaces coincide nothing of no thickness is left.
TEST(Solid, ASolidWithoutItselfIsNothing) {
  const Solid a = leaf(interpolant(3));
  Random random(7);
  const std::vector<Ray> rays = rays_toward(*interpolant(3), 500, random);
  std::vector<SolidCrossings> nothing(rays.size()), same(rays.size()), alone(rays.size());
  (a - a).trace(rays, HowMany::all, nothing);
  ((a & a) | a).trace(rays, HowMany::all, same);
  a.trace(rays, HowMany::all, alone);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    EXPECT_TRUE(nothing[i].crossings.empty());
    ASSERT_EQ(same[i].crossings.size(), alone[i].crossings.size());
    for (std::size_t k = 0; k < same[i].crossings.size(); ++k)
      EXPECT_EQ(same[i].crossings[k].t, alone[i].crossings[k].t);
  }
}

// No cracks at the edge: each of these rays passes through a point that is 5e-10 within the solid, beside the
// circle where another ball has cut it. They must all find it, whatever side they come from.
TEST(Solid, NoCracksAlongTheEdge) {
  // Both have radius 1 and centers 1 apart: they meet in the circle x = 1/2, y^2 + z^2 = 3/4.
  const Solid cut = ball({0, 0, 0}, 1) - ball({1, 0, 0}, 1);
  Random random(8);
  std::vector<Ray> rays;
  std::vector<double> target_t;
  for (int i = 0; i < 3000; ++i) {
    const double angle = random.uniform(0, 6.283185307179586);
    const Point<3> edge(0.5, std::sqrt(0.75) * std::cos(angle), std::sqrt(0.75) * std::sin(angle));
    const Point<3> target = edge - 1e-9 * Point<3>::UnitX(), from = 4 * random.direction<3>();
    rays.push_back({.origin = from, .direction = (target - from).normalized()});
    target_t.push_back((target - from).norm());
  }
  std::vector<SolidCrossings> found(rays.size());
  cut.trace(rays, HowMany::all, found);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    bool inside = found[i].inside_at_begin;
    for (const SolidCrossing& crossing : found[i].crossings)
      if (crossing.t < target_t[i]) inside = !inside;
    EXPECT_TRUE(inside) << i;
  }
}

TEST(Solid, AThousandDeep) {
  // Bites out of a ball, one at a time: a left-leaning tree a thousand deep.
  Solid bitten = ball({0, 0, 0}, 1);
  const auto bite = std::make_shared<RigorousTracer>(share(Sphere<3>({1, 0, 0}, 0.5)));
  for (int i = 0; i < 1000; ++i) bitten = bitten - Solid(bite);
  const Solid once = ball({0, 0, 0}, 1) - Solid(bite);
  const std::vector<Ray> rays = {{.origin = {3, 0, 0}, .direction = {-1, 0, 0}},
                                 {.origin = {3, 0.3, 0}, .direction = {-1, 0, 0}}};
  std::vector<SolidCrossings> a(2), b(2);
  bitten.trace(rays, HowMany::all, a);
  once.trace(rays, HowMany::all, b);
  for (std::size_t i = 0; i < 2; ++i) {
    ASSERT_EQ(a[i].crossings.size(), 2u);
    EXPECT_EQ(a[i].crossings[0].t, b[i].crossings[0].t);
  }
  EXPECT_NEAR(b[0].crossings[0].t, 2.5, 1e-12);  // the bottom of the bite
  // And as text, in brackets.
  std::string text = "0";
  for (int i = 0; i < 1000; ++i) text = "(" + text + " - 1)";
  const Solid parsed = csg_solid(text, {ball({0, 0, 0}, 1), Solid(bite)});
  EXPECT_EQ(parsed.leaves().size(), 1001u);
}

TEST(CsgExpression, PrecedenceAndBrackets) {
  // Each of three solids is a ball around a place of its own, all overlapping in the middle.
  const std::vector<Solid> solids = {ball({0, 0, 0}, 1), ball({1, 0, 0}, 1), ball({0, 1, 0}, 1)};
  Random random(9);
  const Points<3> points = random.points_in<3>(Box<3>(Point<3>(-1, -1, -1), Point<3>(2, 2, 1)), 3000);
  const auto same = [&](const char* text, const Solid& solid) {
    EXPECT_EQ(csg_solid(text, solids).contains(points), solid.contains(points)) << text;
  };
  const Solid &a = solids[0], &b = solids[1], &c = solids[2];
  same("0", a);
  same(" ( 1 ) ", b);
  same("0|1&2", a | (b & c));
  same("0 - 1 & 2", a - (b & c));
  same("0 - 1 - 2", (a - b) - c);
  same("0 - (1 - 2)", a - (b - c));
  same("0 - 1 | 2", (a - b) | c);
  same("((0|1)) - ( 2 )", (a | b) - c);
}

TEST(CsgExpression, ErrorsMarkThePlace) {
  const std::vector<Solid> solids = {ball({0, 0, 0}, 1), ball({1, 0, 0}, 1)};
  const auto says = [&](const std::string& text, const std::string& message, std::size_t column) {
    try {
      csg_solid(text, solids);
      ADD_FAILURE() << text << " was accepted";
    } catch (const Error& error) {
      const std::string all = error.what();
      EXPECT_EQ(all.substr(0, message.size()), message) << text;
      EXPECT_EQ(all.substr(all.rfind('\n') + 1), "    " + std::string(column, ' ') + "^") << text;
    }
  };
  says("", "expected a number", 0);
  says("0 - & 1", "expected a number", 4);
  says("0 -", "expected a number", 3);
  says("0 1", "expected \"|\"", 2);
  says("(0 | 1", "no \")\"", 0);
  says("0 | 1)", "no \"(\"", 5);
  says("0 | 2", "the numbers are 0 to 1", 4);
  says("0 | 99999999999999999999", "the numbers are 0 to 1", 4);
  says("0 + 1", "expected \"|\"", 2);
  says("()", "expected a number", 1);
}

// surface_points lie on the surface: within a 2^-8 of a lattice edge.
TEST(Solid, SurfacePointsLieOnTheSurface) {
  const Solid cut = ball({0, 0, 0}, 1) - ball({1, 0, 0}, 1);
  const Points<3> points = cut.surface_points(40);
  ASSERT_GT(points.cols(), 1000);
  const double edge = 2.5 / 40 / 256;
  for (Index i = 0; i < points.cols(); ++i) {
    const double to_a = std::abs(points.col(i).norm() - 1);
    const double to_b = std::abs((points.col(i) - Point<3>(1, 0, 0)).norm() - 1);
    EXPECT_LE(std::min(to_a, to_b), edge);
  }
}

}  // namespace
}  // namespace seesaw
