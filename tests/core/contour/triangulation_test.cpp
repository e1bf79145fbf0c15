#include "core/contour/triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/base/random.h"

namespace seesaw {
namespace {

double twice_area(const Triangulation& mesh, int t) {
  const auto& v = mesh.triangle(t).vertex;
  const Point<2> a = mesh.uv(v[0]), b = mesh.uv(v[1]) - a, c = mesh.uv(v[2]) - a;
  return b.x() * c.y() - b.y() * c.x();
}

// Leaves tile the made cells, share whole edges and no more, and know their neighbors.
void expect_conforming(const Triangulation& mesh) {
  std::map<std::pair<int, int>, int> owners;
  double area = 0;
  for (int t = 0; t < mesh.size(); ++t) {
    if (!mesh.is_leaf(t)) continue;
    EXPECT_GT(twice_area(mesh, t), 0);
    area += 0.5 * twice_area(mesh, t);
    const auto [l, r] = mesh.edge(t, 0);
    const auto& v = mesh.triangle(t).vertex;
    const Point<2> left = mesh.uv(l) - mesh.uv(v[0]), right = mesh.uv(r) - mesh.uv(v[0]);
    EXPECT_EQ(left.dot(right), 0) << "a right angle at the apex";
    EXPECT_EQ(left.squaredNorm(), right.squaredNorm());
    for (int k = 0; k < 3; ++k) {
      const auto [a, b] = mesh.edge(t, k);
      EXPECT_TRUE(owners.emplace(std::pair(a, b), t).second) << "two triangles on one side of an edge";
    }
  }
  double cells = 0;
  for (int j = 0; j < mesh.lattice().ny; ++j)
    for (int i = 0; i < mesh.lattice().nx; ++i) cells += mesh.first_triangle(i, j) >= 0;
  EXPECT_EQ(area, cells);
  for (const auto& [edge, t] : owners) {
    int k = 0;
    while (mesh.edge(t, k) != std::array<int, 2>{edge.first, edge.second}) ++k;
    const int neighbor = mesh.triangle(t).neighbor[static_cast<std::size_t>(k)];
    const auto other = owners.find({edge.second, edge.first});
    if (other != owners.end()) {
      EXPECT_EQ(neighbor, other->second);
    } else {
      EXPECT_LT(neighbor, 0);
      const Point<2> middle = 0.5 * (mesh.uv(edge.first) + mesh.uv(edge.second));
      const bool on_box = middle.x() == 0 || middle.y() == 0 || middle.x() == mesh.lattice().nx ||
                          middle.y() == mesh.lattice().ny;
      EXPECT_EQ(neighbor, on_box ? Triangle::box_side : Triangle::not_made);
    }
  }
}

Lattice lattice_of(int nx, int ny) {
  Lattice lattice = make_lattice(Box<2>(Point<2>(0, 0), Point<2>(nx, ny)), std::max(nx, ny));
  lattice.values = Values::Constant(lattice.corners(), -1.0);
  return lattice;
}

TEST(Triangulation, CellsAreAsSquareAsTheBoxAllows) {
  const Lattice lattice = make_lattice(Box<2>(Point<2>(0, 0), Point<2>(4, 1)), 128);
  EXPECT_EQ(lattice.nx, 128);
  EXPECT_EQ(lattice.ny, 32);
  EXPECT_EQ(make_lattice(Box<2>(Point<2>(0, 0), Point<2>(1, 1e-9)), 16).ny, 1);
  EXPECT_EQ(lattice.position({128, 32}), Point<2>(4, 1));
  EXPECT_EQ(lattice.position({0, 16}), Point<2>(0, 0.5));
}

TEST(Triangulation, OnlyCellsOfBothSignsAreMade) {
  Lattice lattice = lattice_of(4, 4);
  EXPECT_EQ(Triangulation(lattice, 0).size(), 0);
  lattice.values[lattice.corner(2, 2)] = 0;  // zero is inside
  const Triangulation mesh(lattice, 0);
  EXPECT_EQ(mesh.size(), 8);
  expect_conforming(mesh);
}

TEST(Triangulation, RandomBisectionsNeverLeaveAGap) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    Lattice lattice = lattice_of(5, 3);
    for (double& value : lattice.values) value = random.uniform(-1, 0.3);
    Triangulation mesh(lattice, 0);
    const Point<2> target(random.uniform(0, 5), random.uniform(0, 3));
    mesh.make_around(target, 0);
    for (int step = 0; step < 60; ++step) {
      std::vector<int> leaves;
      // Half of the time anywhere, half of the time ever deeper around one point.
      if (step % 2 == 0) {
        mesh.leaves_near(target, 1e-12, leaves);
      } else {
        for (int t = 0; t < mesh.size(); ++t)
          if (mesh.is_leaf(t)) leaves.push_back(t);
        leaves = {leaves[static_cast<std::size_t>(random.index(std::ssize(leaves)))]};
      }
      ASSERT_FALSE(leaves.empty());
      for (const int t : leaves)
        if (mesh.is_leaf(t)) mesh.bisect(t);
      mesh.set_new_values(Values::Zero(mesh.new_positions().cols()));
    }
    expect_conforming(mesh);
  }
}

TEST(Triangulation, LeavesNearAPointHoldIt) {
  Lattice lattice = lattice_of(2, 2);
  Triangulation mesh(lattice, 0);
  mesh.make_around({1, 1}, 0.1);
  std::vector<int> leaves;
  mesh.leaves_near({1, 1}, 1e-12, leaves);
  // Cells alternate their diagonals: all four meet the middle corner with both triangles, or with one.
  int expected = 0;
  for (int t = 0; t < mesh.size(); ++t) {
    const auto& v = mesh.triangle(t).vertex;
    expected +=
        std::any_of(v.begin(), v.end(), [&](int vertex) { return mesh.uv(vertex) == Point<2>(1, 1); });
  }
  EXPECT_EQ(std::ssize(leaves), expected);
  mesh.leaves_near({0.25, 0.125}, 0, leaves);
  EXPECT_EQ(leaves.size(), 1u);
}

}  // namespace
}  // namespace seesaw
