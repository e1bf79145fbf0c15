// The papers' models, polygonized on three lattices: the topology that they state, whatever the lattice.
#include <gtest/gtest.h>

#include <filesystem>

#include "core/mesh/mesh_check.h"
#include "core/mesh/mesh_file.h"
#include "core/mesh/simplify.h"
#include "core/modelling/blend.h"
#include "core/modelling/branching_prisms.h"
#include "core/modelling/model_constraints.h"
#include "core/modelling/polygonal_torus.h"
#include "core/modelling/triangle_tree.h"
#include "core/polygonize/polygonize.h"
#include "core/rbf/fit.h"

namespace seesaw {
namespace {

// Under the sanitizers one lattice keeps the time bearable.
#if defined(__SANITIZE_ADDRESS__)
constexpr int lattices[] = {50};
#else
constexpr int lattices[] = {50, 80, 120};
#endif

void expect_topology(const Constraints<3>& constraints, Index components, Index genus) {
  const Interpolant<3> f = fit(constraints, {.condition = false}).function;
  const Points<3> seeds = boundary_points(constraints);
  for (const int cells : lattices) {
    SCOPED_TRACE(cells);
    const Polygonization made = polygonize(f, seeds, {.cells = cells});
    const MeshReport report = check_mesh(made.mesh);
    EXPECT_TRUE(report.closed && report.manifold && report.oriented);
    EXPECT_EQ(report.boundary_edges, 0);
    EXPECT_EQ(report.components, components);
    EXPECT_EQ(report.genus, genus);
    EXPECT_EQ(made.seeds_missed, 0);
    const TriangleTree tree(made.mesh.vertices, made.mesh.faces);
    double farthest = 0;
    for (Index i = 0; i < seeds.cols(); ++i)
      farthest = std::max(farthest, tree.nearest(seeds.col(i)).distance);
    EXPECT_LT(farthest, 0.5 * made.cell);
  }
}

TEST(LatticeSizes, Tetrahedron) {  // Fig. 2 left
  expect_topology({boundary<3>({1, 1, 1}), boundary<3>({1, -1, -1}), boundary<3>({-1, 1, -1}),
                   boundary<3>({-1, -1, 1}), interior<3>({0, 0, 0})},
                  1, 0);
}

TEST(LatticeSizes, Branching) { expect_topology(branching_prisms().constraints, 1, 0); }  // Fig. 2 right

TEST(LatticeSizes, Fist) {  // Fig. 3
  const TriangleMesh model = read_mesh(SEESAW_SOURCE_DIR "/figures/data/fist_750.obj").mesh;
  expect_topology(constraints_from(model).constraints, 1, 0);
}

TEST(LatticeSizes, Bunny) {  // Fig. 6
  const char* const path = "/usr/share/glmark2/models/bunny.obj";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "needs the package glmark2-data";
  expect_topology(constraints_from(simplify(read_mesh(path).mesh, 800)).constraints, 1, 0);
}

TEST(LatticeSizes, Torus) { expect_topology(constraints_from(polygonal_torus({})).constraints, 1, 1); }

TEST(LatticeSizes, TwoToriBlended) {  // Fig. 9
  // Side by side, their tubes one where they touch: a surface with the holes of both.
  std::vector<Constraints<3>> objects;
  std::vector<Fit<3>> fits;
  for (const double side : {-1.0, 1.0}) {
    objects.push_back(
        constraints_from(polygonal_torus({.center = {0.9 * side, 0, 0}, .major = 1, .minor = 0.35}))
            .constraints);
    fits.push_back(fit(objects.back(), {.condition = false}));
  }
  const Blend<3> mixed = blend<3>({{objects[0], &fits[0].function}, {objects[1], &fits[1].function}});
  expect_topology(mixed.constraints, 1, 2);
}

}  // namespace
}  // namespace seesaw
