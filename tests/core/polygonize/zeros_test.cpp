// Exact zeros at lattice corners, and values without any order: whatever they are, the mesh is a closed,
// oriented manifold.
#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/implicit/primitives.h"
#include "tests/core/polygonize/test_fields.h"

namespace seesaw {
namespace {

// The field of libfive's tests: a value at random at every corner, of few different ones so that many are
// exactly zero, and outside all around, so that whatever there is closes.
TEST(Zeros, RandomValuesAtCornersGiveClosedManifolds) {
  Index faces = 0, zeros = 0, dropped = 0;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    const int different = 2 + static_cast<int>(seed % 5);
    const TestField field(
        cube(2),
        [=](const Point<3>& p) {
          if (p.cwiseAbs().maxCoeff() > 1.75) return -1.0;
          return static_cast<double>(hash_of(p, seed) % static_cast<std::uint64_t>(different)) -
                 (different - 1) / 2;
        },
        [](const Point<3>&) -> Point<3> { return Point<3>::Zero(); });
    // Two cubes of lattice have width 1: corners at -2, -1, 0, 1, 2, or finer.
    const int cells = seed % 3 == 0 ? 5 : 4;
    const Polygonization result =
        polygonize(field, no_seeds(), {.cells = cells, .box = cube(2), .improve = seed % 2 == 0});
    if (result.mesh.faces.cols() == 0) {
      ++dropped;
      continue;
    }
    const MeshReport report = check_mesh(result.mesh);
    ASSERT_TRUE(is_closed_manifold(report)) << "seed " << seed;
    ASSERT_TRUE(result.mesh.vertices.allFinite() && result.mesh.normals.allFinite());
    ASSERT_EQ(report.components, result.components);
    ASSERT_GE(report.volume, -1e-12) << "seed " << seed;
    faces += report.faces;
    zeros += report.degenerate_faces;
  }
  EXPECT_GT(faces, 100'000);
  EXPECT_LT(dropped, 300);
  std::cout << faces << " faces, " << zeros << " without area, " << dropped << " meshes of nothing\n";
}

// Corners of the lattice on the sphere: (1, 0, 0), (0.6, 0.8, 0), (2, 1, 2) / 3 ...
TEST(Zeros, ASphereThroughLatticeCorners) {
  for (const int n : {5, 15, 30}) {
    const double r = n;
    const TestField ball(
        cube(2), [=](const Point<3>& p) { return r * r - p.squaredNorm(); },
        [](const Point<3>& p) -> Point<3> { return -2 * p; });
    // Cells of width 1, corners at whole numbers.
    const Box<3> box = cube(n + 2);
    const Polygonization raw =
        polygonize(ball, one_seed(r, 0, 0), {.cells = 2 * (n + 2), .box = box, .improve = false});
    const Polygonization fine = polygonize(ball, one_seed(r, 0, 0), {.cells = 2 * (n + 2), .box = box});
    for (const Polygonization* result : {&raw, &fine}) {
      const MeshReport report = check_mesh(result->mesh);
      EXPECT_TRUE(is_closed_manifold(report));
      EXPECT_EQ(report.genus, 0);
      EXPECT_EQ(report.components, 1);
      EXPECT_EQ(report.degenerate_faces, 0) << n << (result == &raw ? " raw" : "");
      EXPECT_LT(farthest_off(ball, result->mesh), 1e-10);
    }
    EXPECT_GT(fine.smallest_angle, 15) << n;
  }
}

TEST(Zeros, PlanesThroughCorners) {
  for (const Point<3>& normal :
       {Point<3>(1, 0, 0), Point<3>(0, -1, 0), Point<3>(1, 1, 0), Point<3>(1, 1, 1), Point<3>(2, -1, 1)}) {
    const TestField plane(
        cube(1), [=](const Point<3>& p) { return normal.dot(p); }, [=](const Point<3>&) { return normal; });
    const Polygonization result = polygonize(plane, one_seed(0, 0, 0), {.cells = 8, .box = cube(1)});
    const MeshReport report = check_mesh(result.mesh);
    EXPECT_TRUE(report.manifold && report.oriented);
    EXPECT_EQ(report.components, 1);
    EXPECT_EQ(report.euler_characteristic, 1);
    EXPECT_EQ(report.degenerate_faces, 0) << normal.transpose();
    EXPECT_LT(farthest_off(plane, result.mesh), 1e-12);
    EXPECT_TRUE(result.clipped);
    EXPECT_EQ(result.seeds_on_surface, 1);
  }
}

// f >= 0 in a point, on a line, on a sheet, and nowhere more: there is no surface.
TEST(Zeros, WhatHasNothingInsideIsDropped) {
  const TestField point(cube(2), [](const Point<3>& p) { return -p.squaredNorm(); });
  const TestField line(cube(2), [](const Point<3>& p) { return -p.head<2>().squaredNorm(); });
  const TestField sheet(cube(2), [](const Point<3>& p) { return -p.x() * p.x(); });
  const TestField shell(cube(2),
                        [](const Point<3>& p) { return -std::abs(p.lpNorm<Eigen::Infinity>() - 1); });
  for (const TestField* field : {&point, &line, &sheet, &shell})
    for (const bool exhaustive : {false, true}) {
      const Polygonization result =
          polygonize(*field, one_seed(0, 0, 0), {.cells = 8, .box = cube(2), .exhaustive = exhaustive});
      EXPECT_EQ(result.mesh.faces.cols(), 0);
      EXPECT_EQ(result.seeds_nowhere, 1);
    }
  // Beside a real surface, and the real surface stays.
  const TestField both(cube(2), [](const Point<3>& p) {
    return std::max(-(p - Point<3>(1, 1, 1)).squaredNorm(), 0.5 - (p + Point<3>(0.5, 0.5, 0.5)).norm());
  });
  EXPECT_EQ(polygonize(both, no_seeds(), {.cells = 8, .box = cube(2)}).components, 1);
}

// -0.0 is inside, as 0.0 is.
TEST(Zeros, MinusZeroIsZero) {
  const auto f = [](double zero) {
    return TestField(cube(2), [=](const Point<3>& p) {
      const double v = 1 - p.lpNorm<Eigen::Infinity>();
      return v == 0 ? zero : v;
    });
  };
  const Polygonization plus = polygonize(f(0.0), no_seeds(), {.cells = 8, .box = cube(2)});
  const Polygonization minus = polygonize(f(-0.0), no_seeds(), {.cells = 8, .box = cube(2)});
  EXPECT_EQ(plus.mesh.faces, minus.mesh.faces);
  EXPECT_EQ(plus.mesh.vertices, minus.mesh.vertices);
  EXPECT_TRUE(is_closed_manifold(check_mesh(plus.mesh)));
  EXPECT_NEAR(check_mesh(plus.mesh).volume, 8, 0.2);  // edges are cut off at the size of a cell
}

}  // namespace
}  // namespace seesaw
