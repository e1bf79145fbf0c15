#include "core/mesh/mesh_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/mesh/vertex_normals.h"
#include "tests/core/mesh/test_meshes.h"

namespace seesaw {
namespace {

void expect_watertight(const MeshReport& report) {
  EXPECT_TRUE(report.closed && report.manifold && report.oriented);
  EXPECT_EQ(report.boundary_edges, 0);
  EXPECT_EQ(report.boundary_loops, 0);
  EXPECT_EQ(report.nonmanifold_edges + report.nonmanifold_vertices + report.misoriented_edges, 0);
  // Every edge of a closed surface of triangles has two faces, every face three edges.
  EXPECT_EQ(2 * report.edges, 3 * report.faces);
}

TEST(MeshCheck, ATetrahedronIsKnownInClosedForm) {
  const MeshReport report = check_mesh(tetrahedron());
  expect_watertight(report);
  EXPECT_EQ(report.components, 1);
  EXPECT_EQ(report.euler_characteristic, 2);
  EXPECT_EQ(report.genus, 0);
  EXPECT_NEAR(report.volume, 1.0 / 6, 1e-16);
  EXPECT_NEAR(report.area, (3 + std::sqrt(3.0)) / 2, 1e-15);
  EXPECT_NEAR(report.smallest_angle, 45, 1e-13);
  EXPECT_NEAR(report.largest_angle, 90, 1e-13);
  EXPECT_TRUE(report.box.isApprox(Box<3>(Point<3>(0, 0, 0), Point<3>(1, 1, 1))));
}

TEST(MeshCheck, GenusAddsUpOverComponents) {
  const TriangleMesh torus = torus_mesh(24, 12);
  expect_watertight(check_mesh(torus));
  EXPECT_EQ(check_mesh(torus).genus, 1);
  EXPECT_EQ(check_mesh(torus).euler_characteristic, 0);
  const MeshReport three = check_mesh(joined(joined(torus, moved(torus, 1, {5, 0, 0})), sphere_mesh(1)));
  expect_watertight(three);
  EXPECT_EQ(three.components, 3);
  EXPECT_EQ(three.euler_characteristic, 2);
  EXPECT_EQ(three.genus, 2);
}

TEST(MeshCheck, AreaAndVolumeConvergeAtSecondOrder) {
  double error[2][4];
  for (int i = 0; i < 2; ++i) {
    const MeshReport sphere = check_mesh(sphere_mesh(3 + i));
    const MeshReport torus = check_mesh(torus_mesh(48 << i, 24 << i, 1, 0.4));
    error[i][0] = 4 * pi - sphere.area;
    error[i][1] = 4 * pi / 3 - sphere.volume;
    error[i][2] = 4 * pi * pi * 0.4 - torus.area;
    error[i][3] = 2 * pi * pi * 0.16 - torus.volume;
  }
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(error[0][k] / error[1][k], 4, 0.1) << k;
}

TEST(MeshCheck, MovingScalingAndTurningInsideOut) {
  const TriangleMesh torus = torus_mesh(16, 8);
  const MeshReport report = check_mesh(torus);
  const MeshReport far = check_mesh(moved(torus, 2, {4.5e6, -4.5e6, 1e6}));
  // Coordinates of 4.5e6 are rounded to 5e-10.
  EXPECT_NEAR(far.volume, 8 * report.volume, 1e-7);
  EXPECT_NEAR(far.area, 4 * report.area, 1e-7);
  EXPECT_NEAR(far.smallest_angle, report.smallest_angle, 1e-6);
  const MeshReport turned = check_mesh(inside_out(torus));
  expect_watertight(turned);
  EXPECT_NEAR(turned.volume, -report.volume, 1e-14);
}

TriangleMesh without(const TriangleMesh& mesh, const std::vector<int>& faces) {
  TriangleMesh rest = mesh;
  rest.faces.resize(3, 0);
  for (int f = 0; f < mesh.faces.cols(); ++f) {
    if (std::find(faces.begin(), faces.end(), f) != faces.end()) continue;
    rest.faces.conservativeResize(3, rest.faces.cols() + 1);
    rest.faces.rightCols(1) = mesh.faces.col(f);
  }
  return rest;
}

TEST(MeshCheck, HolesAreLoops) {
  const TriangleMesh sphere = sphere_mesh(2);
  const auto common = [&](int f, int g) {
    int n = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) n += sphere.faces(i, f) == sphere.faces(j, g);
    return n;
  };
  int apart = -1, touching = -1;
  for (int f = 1; f < sphere.faces.cols(); ++f) {
    if (common(0, f) == 0) apart = f;
    if (common(0, f) == 1) touching = f;
  }
  const MeshReport two = check_mesh(without(sphere, {0, apart}));
  EXPECT_FALSE(two.closed);
  EXPECT_TRUE(two.oriented && two.manifold);
  EXPECT_EQ(two.faces, sphere.faces.cols() - 2);
  EXPECT_EQ(two.boundary_edges, 6);
  EXPECT_EQ(two.boundary_loops, 2);
  EXPECT_EQ(two.euler_characteristic, 0);
  EXPECT_EQ(two.genus, -1);
  EXPECT_TRUE(std::isnan(two.volume));
  // Two holes that touch in a vertex have one rim: who walks along it crosses over there, and back again.
  const MeshReport eight = check_mesh(without(sphere, {0, touching}));
  EXPECT_EQ(eight.boundary_edges, 6);
  EXPECT_EQ(eight.boundary_loops, 1);
  EXPECT_EQ(eight.nonmanifold_vertices, 1);
}

TEST(MeshCheck, AMoebiusBandHasOneBoundaryAndNoSides) {
  const MeshReport report = check_mesh(moebius_mesh(20));
  EXPECT_TRUE(report.manifold);
  EXPECT_FALSE(report.closed);
  EXPECT_FALSE(report.oriented);
  EXPECT_EQ(report.misoriented_edges, 2);  // one cut through two bands
  EXPECT_EQ(report.boundary_loops, 1);
  EXPECT_EQ(report.boundary_edges, 40);
  EXPECT_EQ(report.euler_characteristic, 0);
}

TEST(MeshCheck, NonManifold) {
  // Two tetrahedra that share vertex 0 only, then an edge only.
  const TriangleMesh one = tetrahedron();
  TriangleMesh vertex = joined(one, moved(one, -1, {0, 0, 0}));
  vertex.faces = vertex.faces.unaryExpr([](int v) { return v == 4 ? 0 : v; });
  vertex.faces.rightCols(4).row(0).swap(vertex.faces.rightCols(4).row(1));
  MeshReport report = check_mesh(vertex);
  EXPECT_TRUE(report.closed && report.oriented);
  EXPECT_FALSE(report.manifold);
  EXPECT_EQ(report.nonmanifold_vertices, 1);
  EXPECT_EQ(report.components, 1);
  EXPECT_EQ(report.unused_vertices, 1);
  EXPECT_EQ(report.euler_characteristic, 3);
  EXPECT_EQ(report.genus, -1);
  EXPECT_NEAR(report.volume, 1.0 / 3, 1e-15);

  TriangleMesh edge = joined(one, one);
  edge.vertices.rightCols(4) = edge.vertices.leftCols(4);
  edge.vertices.rightCols(4).topRows(2) *= -1;
  edge.faces = edge.faces.unaryExpr([](int v) { return v == 4 ? 0 : v == 7 ? 3 : v; });
  report = check_mesh(edge);
  EXPECT_TRUE(report.closed && report.oriented);
  EXPECT_FALSE(report.manifold);
  EXPECT_EQ(report.nonmanifold_edges, 1);
  EXPECT_EQ(report.nonmanifold_vertices, 0);  // the edge joins the fans at its ends

  // A fin: three faces at one edge.
  report = check_mesh(
      make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}));
  EXPECT_EQ(report.nonmanifold_edges, 1);
  EXPECT_FALSE(report.closed);
  EXPECT_FALSE(report.manifold);
}

TEST(MeshCheck, DegenerateFacesAndUnusedVerticesAreCounted) {
  TriangleMesh mesh = make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {9, 9, 9}},
                                {{0, 1, 2}, {0, 1, 3}, {0, 0, 2}, {2, 2, 2}});
  const MeshReport report = check_mesh(mesh);
  EXPECT_EQ(report.degenerate_faces, 3);
  EXPECT_EQ(report.unused_vertices, 1);
  EXPECT_EQ(report.components, 1);
  EXPECT_DOUBLE_EQ(report.area, 0.5);
  EXPECT_EQ(report.smallest_angle, 0);
  EXPECT_EQ(report.box.max(), Point<3>(2, 1, 0));
}

TEST(MeshCheck, Nothing) {
  const MeshReport report = check_mesh({});
  EXPECT_FALSE(report.closed);
  EXPECT_EQ(report.components, 0);
  EXPECT_EQ(report.euler_characteristic, 0);
  EXPECT_EQ(report.genus, -1);
  EXPECT_EQ(report.area, 0);
  EXPECT_TRUE(report.box.isEmpty());
}

TEST(MeshCheckDeath, AnIndexOutOfRangeIsTheProgrammersMistake) {
  TriangleMesh mesh = tetrahedron();
  mesh.faces(0, 0) = 4;
  EXPECT_DEATH(check_mesh(mesh), "right = 4");
  mesh.faces(0, 0) = -1;
  EXPECT_DEATH(check_mesh(mesh), "right = -1");
}

TEST(VertexNormals, ACubesCornersLookAlongItsDiagonalsHoweverItIsCut) {
  const TriangleMesh cube = unit_cube();
  const Points<3> normals = vertex_normals(cube);
  for (Index v = 0; v < 8; ++v) {
    const Point<3> expected = (cube.vertices.col(v) - Point<3>::Constant(0.5)).normalized();
    EXPECT_LT((normals.col(v) - expected).norm(), 1e-15) << v;
  }
  EXPECT_LT((vertex_normals(moved(cube, 1e-170, {0, 0, 0})) - normals).norm(), 1e-14);
  EXPECT_LT((vertex_normals(inside_out(cube)) + normals).norm(), 1e-14);
}

TEST(VertexNormals, OfASphereConvergeToTheRadius) {
  double worst[2];
  for (int i = 0; i < 2; ++i) {
    const TriangleMesh sphere = sphere_mesh(3 + i);
    worst[i] = (vertex_normals(sphere) - sphere.vertices).colwise().norm().maxCoeff();
  }
  // First order: around the icosahedron's own corners the faces are not alike.
  EXPECT_LT(worst[0], 0.01);
  EXPECT_GT(worst[0] / worst[1], 1.9);
}

TEST(VertexNormals, UnknownIsZero) {
  const TriangleMesh sheet =
      make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0.1}, {5, 5, 5}, {2, 0, 0}}, {{0, 1, 2}, {0, 2, 1}, {0, 1, 4}});
  EXPECT_EQ(vertex_normals(sheet), Points<3>::Zero(3, 5));
}

}  // namespace
}  // namespace seesaw
