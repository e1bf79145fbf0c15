#include "core/mesh/simplify.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/base/error.h"
#include "core/mesh/edge_collapse.h"
#include "core/mesh/mesh_check.h"
#include "core/mesh/mesh_file.h"
#include "core/mesh/vertex_normals.h"
#include "tests/core/mesh/test_meshes.h"

namespace seesaw {
namespace {

void expect_same_topology(const TriangleMesh& a, const TriangleMesh& b) {
  const MeshReport x = check_mesh(a), y = check_mesh(b);
  EXPECT_EQ(x.closed, y.closed);
  EXPECT_TRUE(x.manifold);
  EXPECT_TRUE(x.oriented);
  EXPECT_EQ(x.components, y.components);
  EXPECT_EQ(x.euler_characteristic, y.euler_characteristic);
  EXPECT_EQ(x.boundary_loops, y.boundary_loops);
  EXPECT_EQ(x.unused_vertices, 0);
}

TEST(Simplify, ASphereToAnyNumberOfVertices) {
  TriangleMesh sphere = sphere_mesh(5);  // 10,242 vertices
  sphere.normals = sphere.vertices;
  for (const Index n : {3000, 801, 500, 12, 4}) {
    const TriangleMesh mesh = simplify(sphere, n);
    EXPECT_EQ(mesh.vertices.cols(), n);
    expect_same_topology(mesh, sphere);
    EXPECT_EQ(mesh.faces.cols(), 2 * n - 4);
    // Vertices of the original, with their normals.
    EXPECT_LT((mesh.vertices.colwise().norm().array() - 1).abs().maxCoeff(), 1e-15);
    EXPECT_EQ(mesh.normals, mesh.vertices);
    // n vertices spread over the sphere cut off caps of about 4 pi / n each: volume is lost at the rate of 1
    // / n.
    if (n >= 500) {
      EXPECT_NEAR(check_mesh(mesh).volume, 4 * pi / 3, 60.0 / static_cast<double>(n));
    }
  }
}

TEST(Simplify, TopologyStaysWhateverItIs) {
  const TriangleMesh torus = torus_mesh(80, 40);
  const TriangleMesh thin = torus_mesh(300, 10, 1, 0.01);
  const TriangleMesh many =
      joined(joined(torus, moved(torus, 1, {3, 0, 0})), moved(sphere_mesh(4), 0.3, {9, 0, 0}));
  const TriangleMesh open = moebius_mesh(400);
  const TriangleMesh sheet =
      grid_mesh(40, 60, false, false, false, [](int i, int j) { return Point<3>(i, j, 0.001 * i * j); });
  for (const TriangleMesh* mesh : {&torus, &thin, &many, &sheet}) {
    const TriangleMesh simple = simplify(*mesh, 97);
    EXPECT_EQ(simple.vertices.cols(), 97);
    expect_same_topology(simple, *mesh);
  }
  EXPECT_EQ(check_mesh(simplify(open, 50)).boundary_loops, 1);
  // Far from the origin floats have no digits for the shape: it is simplified around its own middle.
  const TriangleMesh far = simplify(moved(torus, 1, {4.5e6, 0, 0}), 97);
  expect_same_topology(far, torus);
  EXPECT_NEAR(check_mesh(far).volume, check_mesh(simplify(torus, 97)).volume, 0.05);
}

TEST(Simplify, WhatIsSmallEnoughStays) {
  const TriangleMesh cube = unit_cube();
  EXPECT_EQ(simplify(cube, 8).faces, cube.faces);
  EXPECT_EQ(simplify(cube, 100).vertices, cube.vertices);
  TriangleMesh more = joined(cube, tetrahedron());
  more.faces.conservativeResize(3, 12);
  EXPECT_EQ(simplify(more, 9).vertices.cols(), 8);
  EXPECT_EQ(simplify({}, 9).vertices.cols(), 0);
}

TEST(Simplify, SaysWhatItCannotDo) {
  EXPECT_THROW(simplify(unit_cube(), 3), Error);
  // A torus has at least 7 vertices (Moebius), and two of them 14.
  try {
    simplify(torus_mesh(20, 10), 6);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("without damage"), std::string::npos) << error.what();
  }
  EXPECT_THROW(simplify(sphere_mesh(3), 100, [](double) { return false; }), Cancelled);
}

TEST(Simplify, WhatIsNotManifoldComesAsNearAsItCan) {
  // A ball with a fin: three faces at one edge.
  TriangleMesh finned = sphere_mesh(4);
  finned.vertices.conservativeResize(3, finned.vertices.cols() + 1);
  finned.vertices.rightCols(1) << 3, 0, 0;
  finned.faces.conservativeResize(3, finned.faces.cols() + 1);
  finned.faces.rightCols(1) << finned.faces(0, 7), finned.faces(1, 7),
      static_cast<int>(finned.vertices.cols()) - 1;
  ASSERT_FALSE(check_mesh(finned).manifold);
  const TriangleMesh simple = simplify(finned, 300);
  EXPECT_LE(simple.vertices.cols(), 300);
  EXPECT_GE(simple.vertices.cols(), 290);
  EXPECT_EQ(check_mesh(simple).unused_vertices, 0);
}

TEST(Simplify, OneByOneAsWell) {
  const TriangleMesh torus = torus_mesh(40, 20);
  const TriangleMesh simple = collapse_edges(torus, 60);
  EXPECT_EQ(simple.vertices.cols(), 60);
  expect_same_topology(simple, torus);
  EXPECT_NEAR(check_mesh(simple).volume / check_mesh(torus).volume, 1, 0.15);
}

TEST(Simplify, TheBunnyOfGlmark2) {
  const std::filesystem::path path = "/usr/share/glmark2/models/bunny.obj";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "the package glmark2-data is not installed";
  const TriangleMesh bunny = read_mesh(path).mesh;
  EXPECT_EQ(bunny.vertices.cols(), 34835);
  const MeshReport full = check_mesh(bunny);
  // To 3,000 meshoptimizer alone would pinch an edge.
  for (const Index n : {800, 3000}) {
    const MeshReport report = check_mesh(simplify(bunny, n));
    EXPECT_EQ(report.vertices, n);
    EXPECT_EQ(report.faces, 2 * n - 4);
    EXPECT_TRUE(report.closed && report.manifold && report.oriented);
    EXPECT_EQ(report.components, 1);
    EXPECT_EQ(report.genus, 0);
    EXPECT_NEAR(report.volume / full.volume, 1, 0.02);
  }
}

}  // namespace
}  // namespace seesaw
