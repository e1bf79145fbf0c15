// What improve.h promises of each of its moves, and of all together.
#include "core/polygonize/improve.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <vector>

#include "core/implicit/primitives.h"
#include "core/implicit/torus.h"
#include "core/polygonize/collapse.h"
#include "core/polygonize/flip.h"
#include "core/polygonize/scan.h"
#include "core/polygonize/slide.h"
#include "core/polygonize/triangle_quality.h"
#include "tests/core/polygonize/test_fields.h"

namespace seesaw {
namespace {

// A torus with a bumpy skin: needles of all kinds, and nothing symmetric.
class Bumpy {
 public:
  double operator()(const Point<3>& p) const {
    return torus_.value(p) + 0.04 * std::sin(9 * p.x()) * std::sin(8 * p.y()) * std::cos(7 * p.z());
  }

 private:
  Torus torus_{{0.01, 0.02, 0.03}, {0.1, 0.2, 1}, 1.0, 0.4};
};

// The mesh as the lattice makes it; cut by the box or whole.
LatticeMesh raw_mesh(Sampler& sampler, bool cut, int n, double& cell) {
  Lattice lattice;
  lattice.box = cut ? Box<3>(Point<3>(-0.31, -1.7, -0.9), Point<3>(1.7, 0.45, 0.9)) : cube(1.7);
  lattice.n = {n, n, n};
  lattice.step = lattice.box.sizes() / n;
  lattice.range = {{0, 0, 0}, lattice.n};
  cell = lattice.cell();
  CrossedCubes found = scan(lattice, sampler, MemoryBound(std::size_t{1} << 30));
  return assemble(lattice, found, sampler, 0.01 * cell);
}

std::vector<Point<3>> normals_of(const WorkingMesh& work) {
  std::vector<Point<3>> normals;
  for (int h = 0; h < work.net.size(); h += 3)
    normals.push_back(work.net.is_alive(h)
                          ? normal_of(work.at(work.net.origin(h)), work.at(work.net.origin(h + 1)),
                                      work.at(work.net.origin(h + 2)))
                          : Point<3>(0, 0, 0));
  return normals;
}

double worst_of(const WorkingMesh& work) {
  return *std::min_element(work.quality.begin(), work.quality.end());
}

MeshReport report_of(const WorkingMesh& work) {
  TriangleMesh mesh;
  mesh.vertices = work.mesh.positions;
  mesh.faces = work.net.faces();
  return check_mesh(mesh);
}

TEST(Improve, EachMoveKeepsItsPromises) {
  const TestField field(cube(1.7), Bumpy());
  for (const bool cut : {false, true}) {
    const Progress none;
    Sampler sampler(field, none);
    double cell = 0;
    LatticeMesh mesh = raw_mesh(sampler, cut, 34, cell);
    WorkingMesh work(mesh, cell);
    const MeshReport before = report_of(work);
    ASSERT_TRUE(before.manifold && before.oriented);
    ASSERT_EQ(before.closed, !cut);
    ASSERT_LT(before.smallest_angle, 5);
    const auto check = [&](const char* move) {
      const MeshReport now = report_of(work);
      EXPECT_TRUE(now.manifold && now.oriented) << move;
      EXPECT_EQ(now.euler_characteristic, before.euler_characteristic) << move;
      EXPECT_EQ(now.boundary_loops, before.boundary_loops) << move;
      // The same arithmetic, so the same bits.
      const std::vector<double> kept = work.quality;
      work.renew_all();
      EXPECT_EQ(kept, work.quality) << move;
    };
    collapse_short_edges(work, 0.45 * cell);
    EXPECT_LT(report_of(work).faces, before.faces);
    check("collapse");
    double worst = worst_of(work);
    for (int round = 0; round < 3; ++round) {
      flip_edges(work);
      EXPECT_GE(worst_of(work), worst);
      check("flip");
      worst = worst_of(work);
      const std::vector<Point<3>> was = normals_of(work);
      const Points<3> stood = work.mesh.positions;
      slide_vertices(work, sampler);
      EXPECT_GE(worst_of(work), std::min(worst, good_enough));
      check("slide");
      worst = worst_of(work);
      const std::vector<Point<3>> is = normals_of(work);
      for (std::size_t f = 0; f < was.size(); ++f)
        EXPECT_TRUE(was[f].isZero(0) || within(was[f], is[f], largest_turn)) << f;
      EXPECT_NE(stood, work.mesh.positions);
      for (Index v = 0; v < stood.cols(); ++v) {
        if (work.mesh.on_range[static_cast<std::size_t>(v)] == 0) continue;
        EXPECT_EQ(Point<3>(stood.col(v)), work.at(static_cast<int>(v)));
      }
    }
    const auto needles = [&] {
      return std::count_if(work.quality.begin(), work.quality.end(),
                           [](double q) { return q < good_enough; });
    };
    const auto many = needles();
    collapse_needles(work);
    EXPECT_LT(needles(), many);
    EXPECT_GE(worst_of(work), worst);
    check("needles");
  }
}

// Surfaces that lie badly in their lattices: an octant's corner in a corner's corner, bumps, planes askew.
TEST(Improve, NoAngleIsSmall) {
  const Sphere<3> sphere({0.1, 0.2, 0.3}, 1.0);
  const TestField bumpy(cube(1.7), Bumpy());
  for (const Field<3>* field : {static_cast<const Field<3>*>(&sphere), static_cast<const Field<3>*>(&bumpy)})
    for (const int cells : {20, 37, 64}) {
      const Polygonization result = polygonize(*field, no_seeds(), {.cells = cells});
      EXPECT_TRUE(is_closed_manifold(check_mesh(result.mesh)));
      EXPECT_LT(result.smallest_angle_raw, 5);
      EXPECT_GT(result.smallest_angle, 22) << cells;
    }
}

TEST(Improve, TheNumberOfThreadsChangesNothing) {
  const TestField field(cube(1.7), Bumpy());
  std::vector<Polygonization> results;
  for (const std::size_t threads : {1, 2, 5}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    results.push_back(polygonize(field, one_seed(1.4, 0.1, -0.1), {.cells = 36}));
  }
  ASSERT_GT(results[0].mesh.faces.cols(), 4096);  // several blocks
  for (const Polygonization& result : results) {
    EXPECT_EQ(result.mesh.vertices, results[0].mesh.vertices);
    EXPECT_EQ(result.mesh.normals, results[0].mesh.normals);
    EXPECT_EQ(result.mesh.faces, results[0].mesh.faces);
    EXPECT_EQ(result.evaluations, results[0].evaluations);
  }
}

}  // namespace
}  // namespace seesaw
