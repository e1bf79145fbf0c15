#include "core/mesh/self_intersections.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "core/mesh/predicates.h"
#include "tests/core/mesh/test_meshes.h"

namespace seesaw {
namespace {

using Pair = std::pair<int, int>;

bool meet(const std::vector<Point<3>>& vertices, const std::vector<Eigen::Vector3i>& faces) {
  return !self_intersections(make_mesh(vertices, faces)).empty();
}

TEST(Predicates, SignsOfPointsAnUlpFromALineOrPlane) {
  const double ulp = 0x1p-52;
  // The line y = x far along it, where the plain determinant is rounding.
  for (const double step : {-ulp, 0.0, ulp})
    EXPECT_EQ(side_of_line({0.5, 0.5}, {12, 12}, {24, 24 * (1 + step)}), (step > 0) - (step < 0));
  const Point<3> a(0.1, 0.2, 0.3), u(1.25, 0.5, -0.75), v(-0.5, 3, 1);
  // In the plane up to rounding: an ulp of one coordinate decides, and exactly antisymmetric.
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j) {
      Point<3> d = a + i / 7.0 * u + j / 7.0 * v;
      const int side = side_of_plane(a, a + u, a + v, d);
      EXPECT_EQ(side, -side_of_plane(a + u, a, a + v, d));
      EXPECT_EQ(side, -side_of_plane(d, a + u, a + v, a));
      EXPECT_EQ(side, -side_of_plane(a, d, a + v, a + u));
      d += 1e-14 * u.cross(v);
      EXPECT_EQ(side_of_plane(a, a + u, a + v, d), 1);
    }
  EXPECT_EQ(side_of_plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
  EXPECT_EQ(side_of_plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {7, 7, 0}), 0);
}

TEST(SelfIntersections, CleanMeshesHaveNone) {
  EXPECT_TRUE(self_intersections({}).empty());
  EXPECT_TRUE(self_intersections(tetrahedron()).empty());
  EXPECT_TRUE(self_intersections(unit_cube()).empty());
  EXPECT_TRUE(self_intersections(sphere_mesh(3)).empty());
  EXPECT_TRUE(self_intersections(torus_mesh(40, 20)).empty());
  EXPECT_TRUE(self_intersections(moebius_mesh(30)).empty());
  // A flat sheet at a slant: every neighbor lies in one plane up to rounding, and rounding is what decides.
  const Point<3> u(1, 0.3, 0.7), v(-0.2, 1, 0.1);
  EXPECT_TRUE(self_intersections(grid_mesh(20, 20, false, false, false, [&](int i, int j) -> Point<3> {
                return 0.1 * i * v + 0.1 * j * u;
              })).empty());
}

TEST(SelfIntersections, PairsByTheVerticesTheyShare) {
  const std::vector<Point<3>> flat = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const auto with = [&](std::vector<Point<3>> more) {
    more.insert(more.begin(), flat.begin(), flat.end());
    return more;
  };
  const std::vector<Eigen::Vector3i> none = {{0, 1, 2}, {3, 4, 5}};
  EXPECT_TRUE(meet(with({{1, 1, -1}, {1, 1, 1}, {9, 9, 0}}), none));       // through the middle
  EXPECT_TRUE(meet(with({{1, 1, 0}, {1, 1, 1}, {2, 2, 1}}), none));        // a tip on the face
  EXPECT_TRUE(meet(with({{2, 2, -1}, {2, 2, 1}, {9, 9, 0}}), none));       // edge on edge
  EXPECT_TRUE(meet(with({{4, 0, 0}, {5, 0, 1}, {5, 0, 2}}), none));        // tip on tip, not welded
  EXPECT_FALSE(meet(with({{1, 1, 1e-300}, {1, 1, 1}, {2, 2, 1}}), none));  // not quite
  EXPECT_FALSE(meet(with({{3, 3, -1}, {3, 3, 1}, {9, 9, 0}}), none));
  // In one plane.
  EXPECT_TRUE(meet(with({{1, 1, 0}, {1.5, 1, 0}, {1, 1.5, 0}}), none));    // one within the other
  EXPECT_TRUE(meet(with({{-9, -9, 0}, {30, -9, 0}, {-9, 30, 0}}), none));  // and around it
  EXPECT_TRUE(meet(with({{-1, 1, 0}, {5, 1, 0}, {5, 2, 0}}), none));       // across
  EXPECT_TRUE(meet(with({{1, 0, 0}, {3, 0, 0}, {2, -1, 0}}), none));       // along an edge
  EXPECT_FALSE(meet(with({{2.1, 2, 0}, {9, 2, 0}, {9, 9, 0}}), none));

  const std::vector<Eigen::Vector3i> one = {{0, 1, 2}, {0, 3, 4}};
  EXPECT_FALSE(meet(with({{-1, -1, 0}, {-1, 0, 1}}), one));
  EXPECT_FALSE(meet(with({{1, 1, 1}, {1, 1, 2}}), one));
  EXPECT_TRUE(meet(with({{1, 1, 1}, {1, 1, -1}}), one));  // through the face
  EXPECT_TRUE(meet(with({{1, 1, 0}, {1, 1, 1}}), one));   // along a ray within the face
  EXPECT_TRUE(meet(with({{9, 9, 0}, {1, 1, 1}}), one));   // the ray leaves the face
  EXPECT_TRUE(meet(with({{1, 1, 0}, {-1, 3, 0}}), one));  // overlap in one plane
  EXPECT_TRUE(meet(with({{9, 1, 0}, {1, 9, 0}}), one));   // the other is larger
  EXPECT_FALSE(meet(with({{-1, 1, 0}, {-1, 0, 0}}), one));

  const std::vector<Eigen::Vector3i> two = {{0, 1, 2}, {1, 0, 3}};
  EXPECT_FALSE(meet(with({{1, -1, 0}}), two));
  EXPECT_FALSE(meet(with({{1, 1, 1e-300}}), two));  // a sharp fold is not an overlap
  EXPECT_TRUE(meet(with({{1, 1, 0}}), two));
  EXPECT_TRUE(meet(with({{9, 1, 0}}), two));
  EXPECT_TRUE(meet(flat, {{0, 1, 2}, {2, 1, 0}}));
  // Faces of no area are left out.
  EXPECT_FALSE(meet(with({{1, 1, -1}, {1, 1, 1}}), {{0, 1, 2}, {3, 4, 4}}));
}

TEST(SelfIntersections, TwoSpheresMeetAlongACircle) {
  const TriangleMesh sphere = sphere_mesh(3);
  const TriangleMesh mesh = joined(sphere, moved(sphere, 1, {1, 0.01, 0.02}));
  const auto pairs = self_intersections(mesh);
  const auto count = static_cast<int>(sphere.faces.cols());
  EXPECT_GT(pairs.size(), 100u);
  for (const auto& [f, g] : pairs) {
    EXPECT_LT(f, count);
    EXPECT_GE(g, count);
    // Both circle around the line between the centers at x = 1/2, up to the size of a face (0.17 wide).
    for (const int face : {f, g})
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(mesh.vertices(0, mesh.faces(k, face)), 0.5, 0.25);
  }
  EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end()));
}

// Against the definition, pair by pair: do two triangles without common vertices have a point in common?
// Random triangles are in general position, so plain arithmetic can tell: along an edge of one through the
// other.
TEST(SelfIntersections, RandomTrianglesAgainstPlainArithmetic) {
  Random random(7);
  const int triangles = 150;
  TriangleMesh mesh;
  mesh.vertices.resize(3, 3 * triangles);
  mesh.faces.resize(3, triangles);
  for (int f = 0; f < triangles; ++f) {
    const Point<3> middle(random.uniform(), random.uniform(), random.uniform());
    for (int k = 0; k < 3; ++k) {
      mesh.faces(k, f) = 3 * f + k;
      mesh.vertices.col(3 * f + k) = middle + 0.25 * random.direction<3>();
    }
  }
  const auto crosses = [&](int f, int g) {
    const Point<3> a = mesh.vertices.col(3 * g);
    const Point<3> u = mesh.vertices.col(3 * g + 1) - a, v = mesh.vertices.col(3 * g + 2) - a;
    for (int k = 0; k < 3; ++k) {
      const Point<3> p = mesh.vertices.col(3 * f + k);
      const Point<3> d = mesh.vertices.col(3 * f + (k + 1) % 3) - p;
      // p + t d = a + x u + y v by Cramer's rule.
      const double determinant = u.dot(v.cross(-d));
      const double x = (p - a).dot(v.cross(-d)) / determinant;
      const double y = u.dot((p - a).cross(-d)) / determinant;
      const double t = u.dot(v.cross(p - a)) / determinant;
      if (x >= 0 && y >= 0 && x + y <= 1 && t >= 0 && t <= 1) return true;
    }
    return false;
  };
  std::vector<Pair> expected;
  for (int f = 0; f < triangles; ++f)
    for (int g = f + 1; g < triangles; ++g)
      if (crosses(f, g) || crosses(g, f)) expected.emplace_back(f, g);
  EXPECT_GT(expected.size(), 100u);
  EXPECT_EQ(self_intersections(mesh), expected);
}

TEST(SelfIntersections, CanBeCancelled) {
  EXPECT_THROW(self_intersections(tetrahedron(), [](double) { return false; }), Cancelled);
}

}  // namespace
}  // namespace seesaw
