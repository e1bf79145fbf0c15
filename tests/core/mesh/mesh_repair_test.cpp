#include "core/mesh/mesh_repair.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "core/mesh/mesh_check.h"
#include "core/mesh/polygon_triangles.h"
#include "core/mesh/self_intersections.h"
#include "tests/core/mesh/test_meshes.h"

namespace seesaw {
namespace {

/// Every face with vertices of its own, as in STL.
TriangleMesh exploded(const TriangleMesh& mesh) {
  TriangleMesh result;
  result.vertices.resize(3, mesh.faces.size());
  result.faces.resize(3, mesh.faces.cols());
  for (int i = 0; i < mesh.faces.size(); ++i) {
    result.vertices.col(i) = mesh.vertices.col(mesh.faces.data()[i]);
    result.faces.data()[i] = i;
  }
  return result;
}

PolygonSoup soup_of(const std::vector<Point<3>>& vertices, const std::vector<std::vector<int>>& polygons) {
  PolygonSoup soup;
  for (const Point<3>& p : vertices) soup.coordinates.insert(soup.coordinates.end(), p.data(), p.data() + 3);
  for (const auto& polygon : polygons) {
    soup.corners.insert(soup.corners.end(), polygon.begin(), polygon.end());
    soup.end_polygon();
  }
  return soup;
}

TEST(Repair, WeldsExactDuplicatesAndNothingElse) {
  const TriangleMesh sphere = sphere_mesh(2);
  const LoadedMesh welded = repair(exploded(sphere));
  EXPECT_EQ(welded.mesh.vertices.cols(), sphere.vertices.cols());
  EXPECT_EQ(welded.repairs.welded_vertices, sphere.faces.size() - sphere.vertices.cols());
  EXPECT_EQ(check_mesh(welded.mesh).genus, 0);
  TriangleMesh nearly = exploded(tetrahedron());
  nearly.vertices(0, 0) = -0.0;    // is 0
  nearly.vertices(1, 0) = 5e-324;  // is not
  EXPECT_EQ(repair(nearly).mesh.vertices.cols(), 5);
  EXPECT_EQ(repair(nearly, {.weld = false}).mesh.vertices.cols(), 12);
}

TEST(Repair, DoesNotWeldWhatThatWouldSpoil) {
  // Two cubes that touch along an edge, each a closed manifold.
  const TriangleMesh cubes = joined(unit_cube(), moved(unit_cube(), 1, {1, 1, 0}));
  EXPECT_FALSE(repair(cubes).repairs.any());
  EXPECT_TRUE(check_mesh(repair(cubes).mesh).manifold);
  // Without connectivity of its own there is nothing to spoil.
  EXPECT_EQ(repair(exploded(cubes)).mesh.vertices.cols(), 14);
}

TEST(Repair, DropsDegenerateAndDuplicateFacesAndUnusedVertices) {
  TriangleMesh mesh = joined(unit_cube(), tetrahedron());
  mesh.faces.rightCols(4) << 0, 0, 2, 3, 0, 2, 2, 2, 1, 1, 2, 0;  // (0 0 1) (0 2 1) (2 2 2) (3 2 0)
  const LoadedMesh repaired = repair(mesh, {.weld = false});
  EXPECT_EQ(repaired.repairs.degenerate_faces, 2);
  EXPECT_EQ(repaired.repairs.duplicate_faces, 2);
  EXPECT_EQ(repaired.repairs.unused_vertices, 4);
  EXPECT_EQ(repaired.mesh.faces, unit_cube().faces);
  EXPECT_EQ(repaired.mesh.vertices, unit_cube().vertices);
}

TEST(Repair, FlatFacesGoWithoutASlit) {
  // Vertices in the middle of a cube's edge, which only one of the two faces at the edge knows; a flat face
  // with three different corners closes the slit: (1, middle, 2), then one more step along the line.
  TriangleMesh cube = unit_cube();
  cube.vertices.conservativeResize(3, 10);
  cube.vertices.col(8) = Point<3>(1, 0.5, 0);
  cube.vertices.col(9) = Point<3>(1, 0.75, 0);
  // The face (0 2 1) becomes (0 8 1) and (0 2 8), the latter (0 9 8) and (0 2 9).
  cube.faces.conservativeResize(3, 16);
  cube.faces.col(0) << 0, 8, 1;
  cube.faces.col(12) << 0, 9, 8;
  cube.faces.col(13) << 0, 2, 9;
  cube.faces.col(14) << 1, 8, 9;
  cube.faces.col(15) << 1, 9, 2;
  ASSERT_TRUE(check_mesh(cube).closed);
  const LoadedMesh repaired = repair(cube);
  const MeshReport report = check_mesh(repaired.mesh);
  EXPECT_EQ(repaired.repairs.degenerate_faces, 2);
  EXPECT_EQ(report.degenerate_faces, 0);
  EXPECT_EQ(report.genus, 0);
  EXPECT_EQ(report.faces, 16);
  EXPECT_DOUBLE_EQ(report.volume, 1);
  EXPECT_TRUE(self_intersections(repaired.mesh).empty());
}

TEST(Repair, NeighborsAgreeAndTheMajorityDecides) {
  Random random(11);
  const TriangleMesh torus = torus_mesh(20, 10);
  TriangleMesh mixed = torus;
  Index turned = 0;
  for (Index f = 0; f < mixed.faces.cols(); ++f)
    if (random.uniform() < 0.3) {
      std::swap(mixed.faces(0, f), mixed.faces(1, f));
      ++turned;
    }
  EXPECT_FALSE(check_mesh(mixed).oriented);
  const LoadedMesh repaired = repair(mixed);
  EXPECT_EQ(repaired.repairs.turned_faces, turned);
  EXPECT_EQ(repaired.repairs.turned_shells, 0);
  EXPECT_EQ(check_mesh(repaired.mesh).genus, 1);
  EXPECT_GT(check_mesh(repaired.mesh).volume, 0);
  // An open mesh too; and a Moebius band is left and said.
  TriangleMesh sheet = grid_mesh(5, 5, false, false, false, [](int i, int j) { return Point<3>(i, j, 0); });
  std::swap(sheet.faces(0, 3), sheet.faces(1, 3));
  EXPECT_EQ(repair(sheet).repairs.turned_faces, 1);
  const LoadedMesh band = repair(moebius_mesh(12));
  EXPECT_EQ(band.repairs.one_sided, 1);
  EXPECT_EQ(band.mesh.faces, moebius_mesh(12).faces);
  EXPECT_FALSE(repair(mixed, {.orient = false}).repairs.turned_faces);
}

TEST(Repair, InsideOutIsTurnedButAnInnerShellIsNot) {
  const TriangleMesh ball = sphere_mesh(2);
  const auto at = [&](double radius) { return moved(ball, radius, {0.1, 0.2, 0.3}); };
  const auto turned_in = [](const TriangleMesh& mesh) { return repair(mesh).repairs.turned_shells; };
  EXPECT_EQ(turned_in(ball), 0);
  EXPECT_EQ(turned_in(inside_out(ball)), 1);
  EXPECT_NEAR(check_mesh(repair(inside_out(ball)).mesh).volume, check_mesh(ball).volume, 1e-12);
  // A hollow ball: the cavity's wall looks inward and stays so.
  const TriangleMesh hollow = joined(at(2), inside_out(at(1)));
  EXPECT_EQ(turned_in(hollow), 0);
  // All of it inside out: both turn.
  const LoadedMesh both = repair(inside_out(hollow));
  EXPECT_EQ(both.repairs.turned_shells, 2);
  EXPECT_EQ(both.mesh.faces.row(0), hollow.faces.row(0));
  EXPECT_NEAR(check_mesh(both.mesh).volume, check_mesh(hollow).volume, 1e-12);
  // Only the outer wall inside out: the inner one is right as it is.
  EXPECT_EQ(turned_in(joined(inside_out(at(2)), inside_out(at(1)))), 1);
  // A ball in the hollow of a ball is a solid again.
  EXPECT_EQ(turned_in(joined(hollow, at(0.5))), 0);
  EXPECT_EQ(turned_in(inside_out(joined(hollow, at(0.5)))), 3);
  // A shell that looks outward within another is left alone: perhaps it is a solid of its own.
  EXPECT_EQ(turned_in(joined(at(2), at(1))), 0);
  // Side by side, and overlapping: each for itself.
  EXPECT_EQ(turned_in(joined(ball, moved(inside_out(ball), 1, {5, 0, 0}))), 1);
  EXPECT_EQ(turned_in(joined(ball, moved(inside_out(ball), 1, {0.5, 0, 0}))), 1);
  EXPECT_EQ(turned_in(joined(inside_out(ball), moved(ball, 0.9, {0.5, 0, 0}))), 1);
  // A cube in a cube: the ray from its corner runs along faces and edges of the other exactly.
  const TriangleMesh box = moved(unit_cube(), 3, {-1, -1, -1});
  EXPECT_EQ(turned_in(joined(box, inside_out(unit_cube()))), 0);
  EXPECT_EQ(turned_in(inside_out(joined(box, inside_out(unit_cube())))), 2);
}

TEST(Repair, NormalsStayOnlyWhereTheyStillMeanSomething) {
  TriangleMesh ball = sphere_mesh(1);
  ball.normals = 3 * ball.vertices;
  EXPECT_LT((repair(ball).mesh.normals - ball.vertices).norm(), 1e-14);
  EXPECT_FALSE(repair(inside_out(ball)).mesh.has_normals());
  TriangleMesh against = ball;
  against.normals *= -1;
  EXPECT_FALSE(repair(against).mesh.has_normals());
  TriangleMesh unknown = ball;
  unknown.normals.col(5).setZero();
  EXPECT_FALSE(repair(unknown).mesh.has_normals());
}

TEST(Repair, EveryRepairHasAPhrase) {
  MeshRepairs repairs;
  EXPECT_FALSE(repairs.any());
  EXPECT_TRUE(repairs.in_words().empty());
  repairs = {1, 2, 3, 1, 1, 1, 1, 1, 1};
  EXPECT_EQ(repairs.in_words().size(), repairs.named().size());
  EXPECT_EQ(repairs.in_words()[0], "1 vertex welded to others with equal coordinates");
  EXPECT_EQ(repairs.in_words()[1], "2 vertices dropped that no face uses");
  EXPECT_EQ(repairs.in_words()[2], "3 faces of no area removed");
}

// --- polygons

/// The triangles of one polygon, as areas with a sign along `up`, and how well they tile it.
void expect_tiled(const std::vector<Point<3>>& corners, const Point<3>& up, bool simple = true) {
  std::vector<int> polygon;
  Points<3> points(3, static_cast<Index>(corners.size()));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    points.col(static_cast<Index>(i)) = corners[i];
    polygon.push_back(static_cast<int>(i));
  }
  std::vector<std::array<int, 3>> triangles;
  EXPECT_EQ(cut_polygon(points, polygon, triangles), simple);
  EXPECT_EQ(triangles.size(), corners.size() - 2);
  Point<3> whole = Point<3>::Zero();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    whole += (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]) / 2;
  double sum = 0;
  for (const auto& t : triangles) {
    const double area =
        (points.col(t[1]) - points.col(t[0])).cross(points.col(t[2]) - points.col(t[0])).dot(up) / 2;
    if (simple) {
      EXPECT_GE(area, 0);
    }
    sum += std::abs(area);
  }
  // Triangles that all run the polygon's way and whose areas add up to its own cover it once.
  if (simple) {
    EXPECT_NEAR(sum, whole.dot(up), 1e-12 * (1 + sum));
  }
}

TEST(CutPolygon, ConcaveOnesInAnyPlane) {
  Random random(5);
  for (int n = 4; n < 60; ++n) {
    const Point<3> up = random.direction<3>();
    const Point<3> u = up.unitOrthogonal(), v = up.cross(u);
    std::vector<Point<3>> star;
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * pi * i / n, radius = random.uniform(0.05, 1);
      star.push_back(radius * (std::cos(angle) * u + std::sin(angle) * v));
    }
    expect_tiled(star, up);
  }
  // Combs, a spiral, corners on straight sides.
  std::vector<Point<3>> comb = {{0, 0, 0}, {10, 0, 0}};
  for (int i = 10; i > 0; --i) comb.push_back({i - 0.5, i % 2 ? 3.0 : 1.0, 0});
  expect_tiled(comb, {0, 0, 1});
  std::vector<Point<3>> spiral;
  for (int i = 0; i <= 60; ++i)
    spiral.push_back({(1 + 0.1 * i) * std::cos(0.3 * i), (1 + 0.1 * i) * std::sin(0.3 * i), 0});
  for (int i = 60; i >= 0; --i)
    spiral.push_back({(0.7 + 0.1 * i) * std::cos(0.3 * i), (0.7 + 0.1 * i) * std::sin(0.3 * i), 0});
  expect_tiled(spiral, {0, 0, 1});
  expect_tiled({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}},
               {0, 0, 1});
  expect_tiled({{0, 0, 0}, {2, 0, 0}, {0.5, 0.5, 0}, {0, 2, 0}}, {0, 0, 1});
  // A square ring: the hole joined to the rim by an edge there and back.
  expect_tiled({{0, 0, 0},
                {4, 0, 0},
                {4, 4, 0},
                {0, 4, 0},
                {0, 0, 0},
                {1, 1, 0},
                {1, 3, 0},
                {3, 3, 0},
                {3, 1, 0},
                {1, 1, 0}},
               {0, 0, 1});
}

TEST(CutPolygon, WhatCrossesItselfIsCutSomehowAndSaid) {
  expect_tiled({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 0, 1}, false);
  const LoadedMesh bow = repair(soup_of({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}));
  EXPECT_EQ(bow.repairs.crossing_polygons, 1);
}

TEST(CutPolygon, ACubeOfSquaresAndAPrismOfAStar) {
  const TriangleMesh cube = unit_cube();
  std::vector<Point<3>> corners;
  for (Index v = 0; v < 8; ++v) corners.push_back(cube.vertices.col(v));
  const LoadedMesh squares = repair(
      soup_of(corners, {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}));
  EXPECT_FALSE(squares.repairs.any());
  EXPECT_EQ(check_mesh(squares.mesh).genus, 0);
  EXPECT_DOUBLE_EQ(check_mesh(squares.mesh).volume, 1);

  const int n = 10;
  std::vector<Point<3>> star;
  std::vector<std::vector<int>> polygons(2);
  for (int z = 0; z < 2; ++z)
    for (int i = 0; i < n; ++i) {
      const double radius = i % 2 ? 0.3 : 1;
      star.push_back(
          {radius * std::cos(2 * pi * i / n), radius * std::sin(2 * pi * i / n), static_cast<double>(z)});
    }
  for (int i = 0; i < n; ++i) {
    polygons[0].push_back(n - 1 - i);
    polygons[1].push_back(n + i);
    polygons.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  const LoadedMesh prism = repair(soup_of(star, polygons));
  const MeshReport report = check_mesh(prism.mesh);
  EXPECT_EQ(report.genus, 0);
  EXPECT_NEAR(report.volume, n / 2.0 * 0.3 * std::sin(2 * pi / n), 1e-12);
  EXPECT_TRUE(self_intersections(prism.mesh).empty());
}

}  // namespace
}  // namespace seesaw
