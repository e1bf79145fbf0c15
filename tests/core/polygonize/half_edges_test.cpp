// The net that improve.h changes, and the table that made it.
#include "core/polygonize/half_edges.h"

#include <gtest/gtest.h>

#include <set>

#include "core/base/random.h"
#include "core/implicit/primitives.h"
#include "core/implicit/torus.h"
#include "core/polygonize/cube_table.h"
#include "tests/core/polygonize/test_fields.h"

namespace seesaw {
namespace {

TEST(CubeTable, VerticesLieOnTheEdgesThatChangeSign) {
  for (unsigned inside = 0; inside < 256; ++inside) {
    std::set<int> used, crossed;
    for (const auto& triangle : cube_triangles(inside)) used.insert(triangle.begin(), triangle.end());
    for (int e = 0; e < 12; ++e) {
      const CubeEdge& edge = cube_edges[static_cast<std::size_t>(e)];
      if ((inside >> edge.low & 1u) != (inside >> edge.high() & 1u)) crossed.insert(e);
    }
    EXPECT_EQ(used, crossed) << inside;
  }
}

// One corner inside: one triangle, which looks away from it.
TEST(CubeTable, TrianglesLookOutward) {
  for (int corner = 0; corner < 8; ++corner) {
    const CubeTriangles& triangles = cube_triangles(1u << corner);
    ASSERT_EQ(triangles.size(), 1u);
    Points<3> p(3, 3);
    for (std::size_t k = 0; k < 3; ++k) {
      const CubeEdge& edge = cube_edges[triangles[0][k]];
      p.col(static_cast<Index>(k)) = Point<3>(edge.low & 1, edge.low >> 1 & 1, edge.low >> 2);
      p(edge.axis, static_cast<Index>(k)) += 0.5;
    }
    const Point<3> at(corner & 1, corner >> 1 & 1, corner >> 2);
    EXPECT_GT((p.col(1) - p.col(0)).cross(p.col(2) - p.col(0)).dot(p.col(0) - at), 0);
  }
}

// Collapses and flips at random, as many as there can be, on a torus, a sphere and two pieces with a rim: the
// topology never changes.
TEST(HalfEdges, NothingTearsIt) {
  const Torus torus({0, 0, 0}, {0.1, 0.2, 1}, 1, 0.4);
  const Sphere<3> sphere({0.1, 0.2, 0.3}, 1);
  struct Case {
    const Field<3>& field;
    Box<3> box;
  };
  for (const Case& c : {Case{torus, cube(1.6)}, Case{sphere, cube(1.5)},
                        Case{torus, Box<3>(Point<3>(-0.2, -2, -2), Point<3>(2, 0.3, 2))},
                        Case{sphere, Box<3>(Point<3>(-2, -2, 0.1), Point<3>(2, 2, 0.9))}}) {
    TriangleMesh mesh = polygonize(c.field, no_seeds(), {.cells = 14, .box = c.box, .improve = false}).mesh;
    const MeshReport before = check_mesh(mesh);
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      Random random(seed);
      HalfEdges net(mesh.faces, mesh.vertices.cols());
      Index collapsed = 0, flipped = 0;
      for (int step = 0; step < 20000; ++step) {
        const int h = static_cast<int>(random.index(net.size()));
        if (!net.is_alive(h)) continue;
        if (random.index(2) == 0) {
          if (net.can_flip(h)) net.flip(h), ++flipped;
        } else if (net.can_collapse(h)) {
          net.collapse(h), ++collapsed;
        }
        // What every half-edge must know of its neighbors.
        if (step % 500 != 0) continue;
        for (int g = 0; g < net.size(); ++g) {
          if (!net.is_alive(g)) continue;
          const int t = net.twin(g);
          if (t >= 0) {
            ASSERT_EQ(net.twin(t), g);
            ASSERT_EQ(net.origin(t), net.target(g));
            ASSERT_EQ(net.target(t), net.origin(g));
          } else {
            ASSERT_TRUE(net.is_boundary(net.origin(g)));
            ASSERT_EQ(net.leaving(net.origin(g)), g);
          }
        }
      }
      EXPECT_GT(collapsed, mesh.vertices.cols() / 3);
      EXPECT_GT(flipped, 100);
      TriangleMesh after = mesh;
      after.faces = net.faces();
      const MeshReport report = check_mesh(after);
      EXPECT_TRUE(report.manifold && report.oriented);
      EXPECT_EQ(report.closed, before.closed);
      EXPECT_EQ(report.components, before.components);
      EXPECT_EQ(report.euler_characteristic, before.euler_characteristic);
      EXPECT_EQ(report.boundary_loops, before.boundary_loops);
    }
  }
}

}  // namespace
}  // namespace seesaw
