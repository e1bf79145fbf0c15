// The rigorous tracer never misses; the heuristic's misses are counted.
#include <gtest/gtest.h>

#include <iostream>

#include "core/base/parallel.h"
#include "core/implicit/booleans.h"
#include "core/implicit/primitives.h"
#include "core/raytrace/heuristic_tracer.h"
#include "core/raytrace/rigorous_tracer.h"
#include "tests/core/raytrace/interpolant_rays.h"

namespace seesaw {
namespace {

std::vector<RayCrossings> traced(const SurfaceTracer& tracer, const std::vector<Ray>& rays,
                                 HowMany how_many = HowMany::all) {
  std::vector<RayCrossings> result(rays.size());
  constexpr Index block = 1000;
  parallel_blocks(static_cast<Index>(rays.size()), block, [&](Index begin, Index end) {
    const auto first = static_cast<std::size_t>(begin), count = static_cast<std::size_t>(end - begin);
    tracer.trace(std::span(rays).subspan(first, count), how_many, std::span(result).subspan(first, count));
  });
  return result;
}

Index evaluations_of(const std::vector<RayCrossings>& all) {
  Index sum = 0;
  for (const RayCrossings& each : all) sum += each.evaluations;
  return sum;
}

// Samples see chords longer than a 300th of the way; the tracers promise more. Two tangents apart, the place
// of a crossing is as good as f's rounding over its slope along the ray: 1e-6 of the box is that for all but
// rays that graze, and rays that graze within 1e-6 are not told apart by their chords either.
TEST(Tracers, TheRigorousOneMissesNothingInInterpolants) {
  struct Kind {
    const char* name;
    Constraints<3> (*make)(Random&);
    Kernel kernel;
    double reach;  // of the rays about the middle
    int fields;
    Index tenths;  // of all rays, through each
    bool heuristic_must_miss;
  };
  const Kind kinds[] = {{"crumpled surfaces", crumpled, Kernel::cubic, 0.25, 4, 1, false},
                        {"a thin sheet", thin_sheet, Kernel::cubic, 0.25, 1, 3, false},
                        {"a small blade", blade, Kernel::linear, 0.05, 1, 3, true}};
  Index all_rays = 0;
  std::uint64_t seed = 1;
  for (const Kind& kind : kinds) {
    Index true_crossings = 0, rigorous_misses = 0, heuristic_misses = 0, rigorous_cost = 0,
          heuristic_cost = 0, rays_of_kind = 0;
    for (int k = 0; k < kind.fields; ++k) {
      Random random(seed++);
      const auto field = std::make_shared<Interpolant<3>>(
          fit(kind.make(random), {.kernel = kind.kernel, .condition = false}).function);
      const std::vector<Ray> rays = rays_toward(*field, kind.tenths * rays_in_all / 10, random, kind.reach);
      const RigorousTracer rigorous(field);
      const HeuristicTracer heuristic(field);
      const std::vector<RayCrossings> by_bounds = traced(rigorous, rays),
                                      by_samples = traced(heuristic, rays);
      const double near = 1e-6 * field->bounding_box().sizes().norm();
      std::vector<std::array<Index, 3>> counts(rays.size());
      parallel_blocks(static_cast<Index>(rays.size()), 100, [&](Index begin, Index end) {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
          const std::vector<double> truth = crossings_by_samples(*field, rays[i], 300);
          EXPECT_LE(by_bounds[i].unproven, near * (1 + 1e-9));  // the promise was kept for every ray
          counts[i] = {static_cast<Index>(truth.size()), missed(truth, by_bounds[i], near),
                       missed(truth, by_samples[i], near)};
        }
      });
      for (const auto& [truth, by_rigorous, by_heuristic] : counts) {
        true_crossings += truth;
        rigorous_misses += by_rigorous;
        heuristic_misses += by_heuristic;
      }
      rigorous_cost += evaluations_of(by_bounds);
      heuristic_cost += evaluations_of(by_samples);
      rays_of_kind += static_cast<Index>(rays.size());
    }
    all_rays += rays_of_kind;
    std::cout << kind.name << ": " << rays_of_kind << " rays, " << true_crossings
              << " crossings; missed by the "
              << "rigorous tracer " << rigorous_misses << ", by the heuristic " << heuristic_misses
              << "; evaluations a ray " << rigorous_cost / rays_of_kind << " and "
              << heuristic_cost / rays_of_kind << std::endl;
    EXPECT_EQ(rigorous_misses, 0) << kind.name;
    EXPECT_GT(true_crossings, rays_of_kind / 20) << kind.name;
    if (kind.heuristic_must_miss) {
      EXPECT_GT(heuristic_misses, 0) << kind.name;
    }
  }
  EXPECT_EQ(all_rays, rays_in_all);
}

// A ray through a ball of radius r that passes its center at distance d is inside for 2 sqrt(r^2 - d^2).
TEST(Tracers, ChordsOfABallAreExact) {
  const auto ball = share(Sphere<3>({0.3, -0.2, 0.1}, 0.8));
  const RigorousTracer rigorous(ball);
  const HeuristicTracer heuristic(ball);
  for (const SurfaceTracer* tracer :
       {static_cast<const SurfaceTracer*>(&rigorous), static_cast<const SurfaceTracer*>(&heuristic)}) {
    Random random(3);
    const std::vector<Ray> rays = rays_toward(*ball, 2000, random);
    const std::vector<RayCrossings> found = traced(*tracer, rays),
                                    first = traced(*tracer, rays, HowMany::first);
    int through = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Point<3> to_center = Point<3>(0.3, -0.2, 0.1) - rays[i].origin;
      const double nearest = to_center.dot(rays[i].direction);
      const double under_root = 0.64 - (to_center.squaredNorm() - nearest * nearest);
      if (under_root < 0) {
        EXPECT_TRUE(found[i].crossings.empty());
        continue;
      }
      ++through;
      ASSERT_EQ(found[i].crossings.size(), 2u);
      // t is known to rounding over the slope of f along the ray there.
      const double half = std::sqrt(under_root), tolerance = 1e-14 / std::max(half, 1e-3) + 1e-13;
      EXPECT_NEAR(found[i].crossings[0].t, nearest - half, 20 * tolerance);
      EXPECT_NEAR(found[i].crossings[1].t, nearest + half, 20 * tolerance);
      ASSERT_EQ(first[i].crossings.size(), 1u);
      EXPECT_EQ(first[i].crossings[0].t, found[i].crossings[0].t);
      EXPECT_LE(first[i].evaluations, found[i].evaluations);
    }
    EXPECT_GT(through, 500);
  }
}

// The company that a ray is traced in, and the rays that went before, change nothing: not a bit.
TEST(Tracers, ARaysAnswerIsItsOwn) {
  Random random(11);
  const auto field = std::make_shared<Interpolant<3>>(fit(crumpled(random), {.condition = false}).function);
  const std::vector<Ray> rays = rays_toward(*field, 600, random);
  const RigorousTracer together(field), alone(field);
  const std::vector<RayCrossings> in_parallel = traced(together, rays);
  for (std::size_t i = rays.size(); i-- > 0;) {
    RayCrossings single;
    alone.trace(std::span(&rays[i], 1), HowMany::all, std::span(&single, 1));
    ASSERT_EQ(single.crossings.size(), in_parallel[i].crossings.size());
    EXPECT_EQ(single.evaluations, in_parallel[i].evaluations);
    for (std::size_t k = 0; k < single.crossings.size(); ++k)
      EXPECT_EQ(single.crossings[k].t, in_parallel[i].crossings[k].t);
  }
}

// What a box says is true of its points, and boxes that are said to be empty are.
TEST(Tracers, BoxesTellTheTruth) {
  Random random(12);
  const auto field = std::make_shared<Interpolant<3>>(fit(crumpled(random), {.condition = false}).function);
  const BoundTree tree(field, field->bounding_box());
  const Points<3> places = random.points_in<3>(field->bounding_box(), 400);
  int empty = 0;
  for (Index i = 0; i < places.cols(); ++i) {
    const BoundTree::Leaf leaf = tree.leaf_at(places.col(i), Point<3>::UnitX());
    ASSERT_TRUE(leaf.box.contains(Point<3>(places.col(i))));
    const Points<3> inside = random.points_in<3>(leaf.box, 20);
    Values values(20);
    Points<3> gradients(3, 20);
    field->evaluate(inside, values, gradients);
    EXPECT_LE(gradients.colwise().norm().maxCoeff(), leaf.bound);
    if (!leaf.empty) continue;
    ++empty;
    EXPECT_TRUE(((values.array() >= 0) == (leaf.middle >= 0)).all());
  }
  EXPECT_GT(empty, 100);
  EXPECT_LT(empty, 400);
}

// f = 1 - |x| + |y| is positive on parts of its box's faces: the solid is cut off there, and every ray that
// enters leaves.
class Wedge final : public Field<3> {
 public:
  void evaluate(const PointsRef<3>& points, Eigen::Ref<Values> values) const override {
    for (Index i = 0; i < points.cols(); ++i)
      values[i] = 0.5 - std::abs(points(0, i)) + 0.5 * std::abs(points(1, i));
  }
  void evaluate(const PointsRef<3>& points, Eigen::Ref<Values> values,
                Eigen::Ref<Points<3>> gradients) const override {
    evaluate(points, values);
    for (Index i = 0; i < points.cols(); ++i)
      gradients.col(i) << (points(0, i) > 0 ? -1 : 1), (points(1, i) > 0 ? 0.5 : -0.5), 0;
  }
  double gradient_bound(const Box<3>&) const override { return bound; }
  Box<3> bounding_box() const override { return {Point<3>(-1, -1, -1), Point<3>(1, 1, 1)}; }
  double bound = 1.12;
};

TEST(Tracers, SolidsAreClosedByTheirBox) {
  const auto wedge = share(Wedge());
  const RigorousTracer tracer(wedge);
  std::vector<Ray> rays(3);
  rays[0] = {.origin = {0, 0, -5}, .direction = {0, 0, 1}};         // in at the bottom, out at the top
  rays[1] = {.origin = {-5, 0, 0.3}, .direction = {1, 0, 0}};       // through both sloping sides
  rays[2] = {.origin = {0, 0, 0}, .direction = Point<3>(0, 1, 0)};  // from inside
  const std::vector<RayCrossings> found = traced(tracer, rays);
  ASSERT_EQ(found[0].crossings.size(), 2u);
  EXPECT_TRUE(found[0].crossings[0].cap && found[0].crossings[1].cap);
  EXPECT_EQ(found[0].crossings[0].t, 4);
  EXPECT_EQ(found[0].crossings[1].t, 6);
  ASSERT_EQ(found[1].crossings.size(), 2u);
  EXPECT_FALSE(found[1].crossings[0].cap || found[1].crossings[1].cap);
  EXPECT_NEAR(found[1].crossings[0].t, 4.5, 1e-12);
  EXPECT_NEAR(found[1].crossings[1].t, 5.5, 1e-12);
  EXPECT_TRUE(found[2].inside_at_begin);
  ASSERT_EQ(found[2].crossings.size(), 1u);
  EXPECT_EQ(found[2].crossings[0].t, 1);
}

// A field that knows no bound is traced by small steps, and ends.
TEST(Tracers, WithoutABoundStepsAreBlindButFinite) {
  Wedge boundless;
  boundless.bound = infinity;
  const RigorousTracer tracer(share(boundless), {.tree = {.smallest_side = 0.5}});
  const std::vector<RayCrossings> found = traced(tracer, {{.origin = {-5, 0, 0.3}, .direction = {1, 0, 0}}});
  ASSERT_EQ(found[0].crossings.size(), 2u);
  EXPECT_NEAR(found[0].crossings[0].t, 4.5, 1e-12);
  EXPECT_LT(found[0].evaluations, 1500);
}

// A plane of zeros (f = -|z|: the ray lies in the surface, all of it grazing) ends too.
class Sheet final : public Field<3> {
 public:
  void evaluate(const PointsRef<3>& points, Eigen::Ref<Values> values) const override {
    values = -points.row(2).transpose().cwiseAbs();
  }
  void evaluate(const PointsRef<3>& points, Eigen::Ref<Values> values,
                Eigen::Ref<Points<3>> gradients) const override {
    evaluate(points, values);
    gradients.setZero();
    gradients.row(2) = -points.row(2).cwiseSign();
  }
  double gradient_bound(const Box<3>&) const override { return 1; }
  Box<3> bounding_box() const override { return {Point<3>(-1, -1, -1), Point<3>(1, 1, 1)}; }
};

TEST(Tracers, ARayWithinTheSurfaceEnds) {
  const RigorousTracer tracer(share(Sheet()));
  const std::vector<RayCrossings> found =
      traced(tracer, {{.origin = {-5, 0.1, 0}, .direction = {1, 0, 0}},
                      {.origin = {-5, 0.1, 1e-9}, .direction = {1, 0, 0}}});
  EXPECT_LT(found[0].evaluations, 12000);
  EXPECT_LT(found[1].evaluations, 12000);
  EXPECT_TRUE(found[1].crossings.empty());
  // Its patience has run out, and it says so.
  const double promised = RigorousOptions().resolution * tracer.box().sizes().norm();
  EXPECT_GT(found[0].unproven, 10 * promised);
  EXPECT_GT(found[1].unproven, 10 * promised);
}

}  // namespace
}  // namespace seesaw
