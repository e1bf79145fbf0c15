// A component through a seed is never lost: smaller than a cell, thinner than a cell, closer than a cell.
#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/implicit/primitives.h"
#include "tests/core/polygonize/test_fields.h"

namespace seesaw {
namespace {

// Of several solids that may overlap, or bubbles in them (negative radius), all by signed distance.
struct Balls {
  std::vector<Point<3>> centers;
  std::vector<double> radii;
  double operator()(const Point<3>& p) const {
    double f = -1e9;
    for (std::size_t i = 0; i < radii.size(); ++i)
      if (radii[i] > 0) f = std::max(f, radii[i] - (p - centers[i]).norm());
    for (std::size_t i = 0; i < radii.size(); ++i)
      if (radii[i] < 0) f = std::min(f, (p - centers[i]).norm() + radii[i]);
    return f;
  }
  Points<3> seeds() const {
    Points<3> result(3, static_cast<Index>(radii.size()));
    for (std::size_t i = 0; i < radii.size(); ++i)
      result.col(static_cast<Index>(i)) = centers[i] + std::abs(radii[i]) * Point<3>(0.6, 0, -0.8);
    return result;
  }
};

TEST(Small, ATinyBallBesideALargeOne) {
  const double h = 0.1;  // the cell
  for (const double radius : {0.2 * h, 0.05 * h, 0.005 * h}) {
    // Between the corners of the lattice, which knows nothing of it.
    const Balls balls{{{0, 0, 0}, {1.35, 0.36, 0.45}}, {1, radius}};
    const TestField field(cube(2), balls);
    const Polygonization result = polygonize(field, balls.seeds(), {.cells = 40, .box = cube(2)});
    const MeshReport report = check_mesh(result.mesh);
    EXPECT_TRUE(is_closed_manifold(report));
    EXPECT_EQ(report.components, 2);
    EXPECT_EQ(report.genus, 0);
    EXPECT_EQ(result.small_components, 1);
    EXPECT_EQ(result.seeds_on_surface, 2);
    EXPECT_EQ(result.halved, 0) << "a small component costs no halving";
    // And it has its shape: a ball of eight cells or more across.
    const double volume = 4.18879 * radius * radius * radius;
    const auto tiny = bounding_box_of<3>(result.mesh.vertices.rightCols(60));
    EXPECT_LT(tiny.sizes().maxCoeff(), 2.1 * radius);
    Balls alone{{balls.centers[0]}, {1}};
    const double large =
        check_mesh(polygonize(TestField(cube(2), alone), alone.seeds(), {.cells = 40, .box = cube(2)}).mesh)
            .volume;
    EXPECT_NEAR((report.volume - large) / volume, 1, 0.1);
  }
}

TEST(Small, BubblesInTheSolid) {
  const Balls balls{{{0, 0, 0}, {0.35, 0.36, 0.45}, {-0.44, 0.05, 0.06}}, {1, -0.015, -0.01}};
  const TestField field(cube(2), balls);
  const Polygonization result = polygonize(field, balls.seeds(), {.cells = 40, .box = cube(2)});
  const MeshReport report = check_mesh(result.mesh);
  EXPECT_TRUE(is_closed_manifold(report));
  EXPECT_EQ(report.components, 3);
  EXPECT_EQ(result.small_components, 2);
  EXPECT_EQ(result.seeds_on_surface, 3);
}

TEST(Small, DustAtRandomPlaces) {
  Random random(7);
  for (int trial = 0; trial < 5; ++trial) {
    Balls balls;
    while (balls.radii.size() < 30) {
      const Point<3> center = random.points_in<3>(cube(1.7), 1).col(0);
      const double radius = std::pow(10.0, random.uniform(-2.7, -0.7));
      bool apart = true;
      for (std::size_t i = 0; i < balls.radii.size(); ++i)
        apart = apart && (center - balls.centers[i]).norm() > 1.5 * (radius + balls.radii[i]) + 0.01;
      if (!apart) continue;
      balls.centers.push_back(center);
      balls.radii.push_back(radius);
    }
    const TestField field(cube(2), balls);
    const Polygonization result = polygonize(field, balls.seeds(), {.cells = 30, .box = cube(2)});
    const MeshReport report = check_mesh(result.mesh);
    EXPECT_TRUE(is_closed_manifold(report));
    EXPECT_EQ(result.seeds_on_surface, 30) << "trial " << trial << ", missed " << result.seeds_missed;
    EXPECT_EQ(report.components, 30) << "trial " << trial;
    EXPECT_EQ(report.genus, 0);
  }
}

// A slab thinner than a cell, off the lattice's corners: only halving finds it.
TEST(Small, AThinSlab) {
  const Point<3> center(0.03, 0.02, 0.046);
  for (const double half : {0.03, 0.018}) {
    const TestField slab(cube(2), [=](const Point<3>& p) {
      const Point<3> q = p - center;
      return std::min(half - std::abs(q.z()), 1.0 - q.head<2>().norm());
    });
    Points<3> seeds(3, 3);
    seeds << 0.03, 0.5, -0.4, 0.02, 0.1, 0.3, center.z() + half, center.z() - half, center.z() + half;
    const PolygonizeOptions options{.cells = 40, .box = cube(2), .halvings = 3};
    const Polygonization result = polygonize(slab, seeds, options);
    const MeshReport report = check_mesh(result.mesh);
    EXPECT_TRUE(is_closed_manifold(report));
    EXPECT_EQ(report.components, 1);
    EXPECT_EQ(report.genus, 0);
    EXPECT_GT(result.halved, 0);
    EXPECT_DOUBLE_EQ(result.cell, 0.1 / (1 << result.halved));
    EXPECT_EQ(result.seeds_on_surface, 3);
    // Where halving is not allowed, the truth is told.
    const Polygonization coarse = polygonize(slab, seeds, {.cells = 40, .box = cube(2), .halvings = 0});
    EXPECT_EQ(coarse.seeds_missed, 3);
    EXPECT_EQ(coarse.halved, 0);
    // And where memory does not allow it, too: what there is room for comes back.
    const Polygonization poor =
        polygonize(slab, seeds, {.cells = 40, .box = cube(2), .halvings = 9, .memory_limit = 1'000'000});
    EXPECT_LT(poor.halved, 3);
  }
}

// A second sheet just above a large one, facing the same way: near a triangle is not on its sheet.
TEST(Small, ASheetHiddenAboveAnother) {
  const TestField field(cube(2), [](const Point<3>& p) {
    const double r = p.norm();
    return std::max(1 - r, 0.015 - std::abs(r - 1.045));  // a ball, and a shell around it
  });
  Random random(11);
  Points<3> seeds(3, 300);
  for (Index i = 0; i < 300; ++i) {
    const double radius = i % 3 == 0 ? 1.0 : i % 3 == 1 ? 1.06 : 1.03;
    seeds.col(i) = radius * random.direction<3>();
  }
  const Polygonization result = polygonize(field, seeds, {.cells = 40, .box = cube(2), .halvings = 4});
  const MeshReport report = check_mesh(result.mesh);
  EXPECT_TRUE(is_closed_manifold(report));
  EXPECT_EQ(result.seeds_on_surface, 300);
  EXPECT_GT(report.components, 1);
  EXPECT_GT(result.halved, 0);
  EXPECT_GT(polygonize(field, seeds, {.cells = 40, .box = cube(2), .halvings = 0}).seeds_missed, 50);
}

}  // namespace
}  // namespace seesaw
