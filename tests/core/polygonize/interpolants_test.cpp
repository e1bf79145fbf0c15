// The surfaces that all this is for: T&O 2002's interpolants, and their topology at three sizes of the
// lattice.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/rbf/fit.h"
#include "tests/core/polygonize/test_fields.h"

namespace seesaw {
namespace {

Points<3> boundaries(const Constraints<3>& constraints) {
  Points<3> result(3, 0);
  for (const Constraint<3>& c : constraints)
    if (c.kind == ConstraintKind::boundary) {
      result.conservativeResize(3, result.cols() + 1);
      result.rightCols(1) = c.at;
    }
  return result;
}

// The distance from p to the nearest vertex or middle of a face: no less than that to the mesh.
double about_distance(const TriangleMesh& mesh, const Point<3>& p) {
  double least = (mesh.vertices.colwise() - p).colwise().norm().minCoeff();
  for (Index f = 0; f < mesh.faces.cols(); ++f) {
    const Point<3> middle = (mesh.vertices.col(mesh.faces(0, f)) + mesh.vertices.col(mesh.faces(1, f)) +
                             mesh.vertices.col(mesh.faces(2, f))) /
                            3;
    least = std::min(least, (middle - p).norm());
  }
  return least;
}

void expect_one_of_genus(const Constraints<3>& constraints, Index genus, const std::vector<int>& sizes) {
  const Interpolant<3> f = fit(constraints, {.condition = false}).function;
  const Points<3> seeds = boundaries(constraints);
  for (const int cells : sizes) {
    const Polygonization result = polygonize(f, seeds, {.cells = cells});
    const MeshReport report = check_mesh(result.mesh);
    EXPECT_TRUE(is_closed_manifold(report)) << cells;
    EXPECT_EQ(report.components, 1) << cells;
    EXPECT_EQ(report.genus, genus) << cells;
    EXPECT_FALSE(result.clipped);
    EXPECT_EQ(result.seeds_on_surface, seeds.cols()) << cells;
    EXPECT_LE(farthest_off(f, result.mesh), 1e-10);
    EXPECT_EQ(result.unpolished, 0);
    EXPECT_GT(result.smallest_angle, 22) << cells;
    for (Index i = 0; i < seeds.cols(); ++i)
      EXPECT_LT(about_distance(result.mesh, seeds.col(i)), 0.8 * result.cell) << cells;
  }
}

TEST(Interpolants, Fig2LeftIsRound) {
  Constraints<3> tetrahedron = {boundary<3>({1, 1, 1}), boundary<3>({1, -1, -1}), boundary<3>({-1, 1, -1}),
                                boundary<3>({-1, -1, 1}), interior<3>({0, 0, 0})};
  expect_one_of_genus(tetrahedron, 0, {8, 16, 32});
}

// A torus by boundary and normal constraints, as a model gives them (section 4.3).
TEST(Interpolants, ATorusOfConstraintsHasItsHole) {
  Constraints<3> torus;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 8; ++j) {
      const double u = 2 * 3.14159265358979 * i / 20, v = 2 * 3.14159265358979 * (j + 0.5 * (i % 2)) / 8;
      const Point<3> n(std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v));
      torus.push_back(boundary<3>(Point<3>(std::cos(u), std::sin(u), 0) + 0.4 * n, n, 0.02));
    }
  expect_one_of_genus(torus, 1, {20, 40, 80});
}

// Shapes at random: whatever their topology is, three lattices agree on it.
TEST(Interpolants, LatticesAgreeOnLumps) {
  Random random(5);
  for (int trial = 0; trial < 4; ++trial) {
    Constraints<3> ball = {interior<3>({0, 0, 0})};
    for (int i = 0; i < 40; ++i) {
      const Point<3> n = random.direction<3>();
      ball.push_back(boundary<3>(random.uniform(0.8, 1.1) * n));
      ball.push_back(exterior<3>(2 * n));
    }
    const Interpolant<3> f = fit(ball, {.condition = false}).function;
    const Points<3> seeds = boundaries(ball);
    std::vector<Index> euler, components;
    for (const int cells : {16, 32, 64}) {
      const Polygonization result = polygonize(f, seeds, {.cells = cells});
      const MeshReport report = check_mesh(result.mesh);
      EXPECT_TRUE(is_closed_manifold(report));
      EXPECT_EQ(result.seeds_on_surface, 40);
      euler.push_back(report.euler_characteristic);
      components.push_back(report.components);
    }
    EXPECT_THAT(euler, testing::Each(euler[0])) << trial;
    EXPECT_THAT(components, testing::Each(components[0])) << trial;
  }
}

// |x| has a cone at every center, and the centers are on the surface: no gradient there.
TEST(Interpolants, KernelsWithoutGradientsAtTheirCenters) {
  Random random(9);
  Constraints<3> ball = {interior<3>({0, 0, 0})};
  for (int i = 0; i < 60; ++i) ball.push_back(boundary<3>(random.uniform(0.9, 1.1) * random.direction<3>()));
  for (int c = 0; c < 8; ++c)
    ball.push_back(exterior<3>(2 * Point<3>(c & 1 ? 1 : -1, c & 2 ? 1 : -1, c & 4 ? 1 : -1)));
  const Interpolant<3> f = fit(ball, {.kernel = Kernel::linear, .condition = false}).function;
  for (const int cells : {15, 40}) {
    const Polygonization result = polygonize(f, boundaries(ball), {.cells = cells});
    const MeshReport report = check_mesh(result.mesh);
    EXPECT_TRUE(is_closed_manifold(report));
    EXPECT_EQ(result.seeds_missed, 0);
    EXPECT_EQ(result.seeds_on_surface + result.seeds_nowhere, 60);
    EXPECT_TRUE(result.mesh.normals.allFinite());
    EXPECT_EQ(result.unpolished, 0);
  }
}

}  // namespace
}  // namespace seesaw
