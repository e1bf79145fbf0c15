#include "core/polygonize/polygonize.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "core/implicit/primitives.h"
#include "core/implicit/torus.h"
#include "tests/core/polygonize/test_fields.h"

namespace seesaw {
namespace {

constexpr double pi = 3.14159265358979323846;

TEST(Polygonize, SphereIsASphere) {
  const Sphere<3> sphere({0.1, 0.2, 0.3}, 1.0);
  const Polygonization result = polygonize(sphere, one_seed(1.1, 0.2, 0.3), {.cells = 20});
  const MeshReport report = check_mesh(result.mesh);
  EXPECT_TRUE(is_closed_manifold(report));
  EXPECT_EQ(report.components, 1);
  EXPECT_EQ(report.genus, 0);
  EXPECT_EQ(result.components, 1);
  EXPECT_FALSE(result.clipped);
  EXPECT_EQ(result.seeds_on_surface, 1);
  EXPECT_GT(report.volume, 0) << "faces must look outward";
  EXPECT_LT(farthest_off(sphere, result.mesh), 1e-11);
  ASSERT_TRUE(result.mesh.has_normals());
  for (Index v = 0; v < result.mesh.vertices.cols(); ++v)
    EXPECT_GT(result.mesh.normals.col(v).dot(result.mesh.vertices.col(v) - Point<3>(0.1, 0.2, 0.3)),
              1 - 1e-9);
}

// Linear triangles: errors of area and volume shrink with the square of the cell.
TEST(Polygonize, AreaAndVolumeConvergeAtSecondOrder) {
  const Sphere<3> sphere({0.1, 0.2, 0.3}, 1.0);
  const Torus torus({0, 0, 0}, {0.1, 0.2, 1}, 1.0, 0.4);
  struct Case {
    const Field<3>& field;
    double area, volume;
    Index genus;
  };
  for (const Case& c :
       {Case{sphere, 4 * pi, 4 * pi / 3, 0}, Case{torus, 4 * pi * pi * 0.4, 2 * pi * pi * 0.4 * 0.4, 1}})
    for (const bool improve : {false, true}) {
      std::vector<double> area, volume;
      for (const int cells : {16, 32, 64}) {
        const Polygonization result = polygonize(
            c.field, no_seeds(), {.cells = cells, .box = c.field.bounding_box(), .improve = improve});
        const MeshReport report = check_mesh(result.mesh);
        ASSERT_TRUE(is_closed_manifold(report));
        EXPECT_EQ(report.genus, c.genus);
        EXPECT_EQ(report.components, 1);
        area.push_back(std::abs(report.area - c.area));
        volume.push_back(std::abs(report.volume - c.volume));
      }
      // Half the cell, a quarter of the error; a lattice is not a limit, hence some room.
      for (std::size_t i = 1; i < 3; ++i) {
        EXPECT_THAT(area[i - 1] / area[i], testing::AllOf(testing::Gt(3.2), testing::Lt(5.0)));
        EXPECT_THAT(volume[i - 1] / volume[i], testing::AllOf(testing::Gt(3.2), testing::Lt(5.0)));
      }
      EXPECT_LT(area[2] / c.area, 1.5e-3);
    }
}

TEST(Polygonize, ContinuationFindsWhatTheScanFinds) {
  const Torus torus({0, 0, 0}, {0.3, -0.2, 1}, 1.0, 0.4);
  const Box<3> box = cube(1.7);
  const Polygonization scanned = polygonize(torus, no_seeds(), {.cells = 30, .box = box});
  const Point<3> seed = torus.center() + 1.4 * torus.axis().unitOrthogonal();
  const Polygonization crawled = polygonize(torus, seed, {.cells = 30, .box = box});
  EXPECT_EQ(crawled.mesh.vertices, scanned.mesh.vertices);
  EXPECT_EQ(crawled.mesh.faces, scanned.mesh.faces);
  EXPECT_LT(crawled.evaluations, scanned.evaluations / 2);
}

TEST(Polygonize, OnlyTheExhaustiveModeFindsWhatNoSeedTouches) {
  const Sphere<3> left({-1, 0, 0}, 0.5), right({1, 0, 0}, 0.5);
  const TestField both(cube(2), [&](const Point<3>& p) { return std::max(left.value(p), right.value(p)); });
  const Points<3> seed = one_seed(-1.5, 0, 0);
  EXPECT_EQ(polygonize(both, seed, {.cells = 24}).components, 1);
  EXPECT_EQ(polygonize(both, seed, {.cells = 24, .exhaustive = true}).components, 2);
  Points<3> two(3, 2);
  two << -1.5, 1.5, 0, 0, 0, 0;
  EXPECT_EQ(polygonize(both, two, {.cells = 24}).components, 2);
}

TEST(Polygonize, ImprovingLeavesNoNeedles) {
  for (const int cells : {10, 23, 40}) {
    const Torus torus({0.01, 0.02, 0.03}, {0.1, 0.2, 1}, 1.0, 0.4);
    const Polygonization result = polygonize(torus, no_seeds(), {.cells = cells});
    EXPECT_LT(result.smallest_angle_raw, 5);  // what lattices do
    EXPECT_GT(result.smallest_angle, 24);
    EXPECT_NEAR(result.smallest_angle, check_mesh(result.mesh).smallest_angle, 1e-6);
  }
}

TEST(Polygonize, ABoxCutsCleanly) {
  const Sphere<3> sphere({0, 0, 0}, 1.0);
  const Box<3> box(Point<3>(-0.5, -2, -1.9), Point<3>(2, 2, 0.7));
  for (const int cells : {9, 20, 37}) {
    const Polygonization result = polygonize(sphere, one_seed(1, 0, 0), {.cells = cells, .box = box});
    const MeshReport report = check_mesh(result.mesh);
    EXPECT_TRUE(result.clipped);
    EXPECT_TRUE(report.manifold && report.oriented);
    EXPECT_EQ(report.boundary_loops, 1);
    EXPECT_EQ(report.euler_characteristic, 1);  // a disc
    EXPECT_LT(farthest_off(sphere, result.mesh), 1e-11);
    // Every vertex is in the box; those of the boundary are on its faces, to the last digit.
    Index on_box = 0;
    for (Index v = 0; v < result.mesh.vertices.cols(); ++v) {
      const Point<3> p = result.mesh.vertices.col(v);
      EXPECT_TRUE(box.contains(p));
      on_box += p.x() == -0.5 || p.z() == 0.7 ? 1 : 0;
    }
    EXPECT_EQ(on_box, report.boundary_edges);
    // The sphere without the caps x < -0.5 and z > 0.7, which overlap: between these two.
    const double caps = 2 * pi * (0.5 + 0.3);
    EXPECT_GT(report.area, 4 * pi - caps - 0.8);
    EXPECT_LT(report.area, 4 * pi - caps + 0.8);
  }
}

TEST(Polygonize, WithoutABoxASurfaceIsFollowedALittleOutsideOfTheFieldsOwn) {
  const Sphere<3> sphere({0, 0, 0}, 1.0);
  const auto f = [&](const Point<3>& p) { return sphere.value(p); };
  const Polygonization closes = polygonize(TestField(cube(0.8), f), one_seed(0.6, 0.8, 0), {.cells = 20});
  EXPECT_FALSE(closes.clipped);
  EXPECT_TRUE(is_closed_manifold(check_mesh(closes.mesh)));
  // Cut where it would lead too far.
  const Polygonization cut = polygonize(TestField(cube(0.4), f), one_seed(0.6, 0.8, 0), {.cells = 20});
  EXPECT_TRUE(cut.clipped);
  EXPECT_GT(check_mesh(cut.mesh).boundary_edges, 0);
}

TEST(Polygonize, SeedsNeedNotBeOnTheSurface) {
  const Sphere<3> sphere({0, 0, 0}, 1.0);
  Points<3> seeds(3, 4);
  seeds << 1.03, 0.0, 0.3, 9,  //
      0, -0.98, 0, 0,          //
      0, 0, 0, 0;
  const Polygonization result = polygonize(sphere, seeds, {.cells = 24, .box = cube(1.5)});
  EXPECT_EQ(result.seeds_on_surface, 2);
  EXPECT_EQ(result.seeds_nowhere, 1);
  EXPECT_EQ(result.seeds_outside, 1);
  EXPECT_EQ(result.seeds_missed, 0);
  EXPECT_TRUE(is_closed_manifold(check_mesh(result.mesh)));
}

TEST(Polygonize, NoSurfaceIsNoError) {
  const TestField outside(cube(1), [](const Point<3>&) { return -1.0; });
  const TestField inside(cube(1), [](const Point<3>&) { return 1.0; });
  const TestField boxless(Box<3>(), [](const Point<3>& p) { return p.x(); });
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const TestField nothing(cube(1), [=](const Point<3>&) { return nan; });
  for (const TestField* field : {&outside, &inside, &boxless, &nothing}) {
    const Polygonization result = polygonize(*field, no_seeds(), {.cells = 8});
    EXPECT_EQ(result.mesh.faces.cols(), 0);
    EXPECT_EQ(result.mesh.vertices.cols(), 0);
    EXPECT_EQ(result.smallest_angle, 0);
  }
  EXPECT_EQ(polygonize(outside, one_seed(0.1, 0.2, 0.3), {.cells = 8}).seeds_nowhere, 1);
  EXPECT_EQ(polygonize(inside, one_seed(nan, 0, 0), {.cells = 8}).seeds_outside, 1);
  const Sphere<3> sphere({0, 0, 0}, 1.0);
  EXPECT_EQ(polygonize(sphere, no_seeds(), {.box = Box<3>()}).mesh.faces.cols(), 0);
  const Box<3> flat(Point<3>(-1, -1, 0), Point<3>(1, 1, 0));
  EXPECT_EQ(polygonize(sphere, no_seeds(), {.box = flat}).mesh.faces.cols(), 0);
}

// Where there is no number there is no inside: half a sphere with a flat lid, closed.
TEST(Polygonize, WhatIsNotFiniteIsOutside) {
  const Sphere<3> sphere({0, 0, 0}, 1.0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const TestField half(cube(1.5), [&](const Point<3>& p) { return p.x() > 0.123 ? nan : sphere.value(p); });
  const Polygonization result = polygonize(half, one_seed(-1, 0, 0), {.cells = 20});
  const MeshReport report = check_mesh(result.mesh);
  EXPECT_TRUE(is_closed_manifold(report));
  EXPECT_EQ(report.genus, 0);
  EXPECT_GT(result.nonfinite, 0);
  EXPECT_TRUE(result.mesh.vertices.allFinite());
  EXPECT_TRUE(result.mesh.normals.allFinite());
  // The exact solid: pi (2/3 + h - h^3 / 3) with h = 0.123; the lid's rim is cut at the size of a cell.
  EXPECT_NEAR(report.volume, pi * (2.0 / 3 + 0.123 - 0.00062), 0.1);
}

TEST(Polygonize, ProgressRisesAndCancelStops) {
  const Torus torus({0, 0, 0}, {0, 0, 1}, 1.0, 0.4);
  std::vector<double> seen;
  polygonize(torus, no_seeds(), {.cells = 40}, [&](double fraction) {
    seen.push_back(fraction);
    return true;
  });
  ASSERT_GT(seen.size(), 5u);
  for (std::size_t i = 1; i < seen.size(); ++i) EXPECT_GE(seen[i], seen[i - 1]);
  EXPECT_GE(seen.front(), 0);
  EXPECT_EQ(seen.back(), 1);
  for (const double stop : {0.0, 0.3, 0.7, 0.9})
    EXPECT_THROW(
        polygonize(torus, no_seeds(), {.cells = 40}, [=](double fraction) { return fraction < stop; }),
        Cancelled);
}

TEST(Polygonize, MemoryIsBounded) {
  const Sphere<3> sphere({0, 0, 0}, 1.0);
  for (const bool exhaustive : {false, true}) {
    const PolygonizeOptions options{.cells = 4000, .exhaustive = exhaustive, .memory_limit = 20'000'000};
    try {
      polygonize(sphere, one_seed(1, 0, 0), options);
      ADD_FAILURE() << "16 million cubes in 20 MB";
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("use fewer cells or allow more memory"));
    }
  }
}

}  // namespace
}  // namespace seesaw
