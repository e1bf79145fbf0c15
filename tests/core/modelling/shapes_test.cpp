// Cages, prisms, tori, blends.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/implicit/booleans.h"
#include "core/mesh/mesh_check.h"
#include "core/mesh/self_intersections.h"
#include "core/modelling/blend.h"
#include "core/modelling/branching_prisms.h"
#include "core/modelling/cage.h"
#include "core/modelling/model_constraints.h"
#include "core/modelling/polygonal_torus.h"
#include "core/rbf/fit.h"
#include "tests/core/modelling/models.h"

namespace seesaw {
namespace {

using std::numbers::pi;

TEST(Cage, Circle) {
  const Constraints<2> cage = circle_cage({1, 2}, 3, 8, pi / 2);
  ASSERT_EQ(cage.size(), 8u);
  for (const Constraint<2>& each : cage) {
    EXPECT_EQ(each.kind, ConstraintKind::exterior);
    EXPECT_EQ(each.value, -1);
    EXPECT_NEAR((each.at - Point<2>(1, 2)).norm(), 3, 1e-15);
  }
  EXPECT_NEAR((cage[0].at - Point<2>(1, 5)).norm(), 0, 1e-15);
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_NEAR((cage[i].at - cage[(i + 1) % 8].at).norm(), 6 * std::sin(pi / 8), 1e-14);
}

TEST(Cage, SphereIsEven) {
  for (const int n : {4, 20, 100, 500}) {
    const Constraints<3> cage = sphere_cage({1, 2, 3}, 2, n);
    ASSERT_EQ(static_cast<int>(cage.size()), n);
    double nearest = 9;
    Point<3> middle = Point<3>::Zero();
    for (std::size_t i = 0; i < cage.size(); ++i) {
      EXPECT_NEAR((cage[i].at - Point<3>(1, 2, 3)).norm(), 2, 1e-14);
      middle += cage[i].at / n;
      for (std::size_t j = 0; j < i; ++j) nearest = std::min(nearest, (cage[i].at - cage[j].at).norm());
    }
    EXPECT_GT(nearest, 3.0 * 2 / std::sqrt(n));
    EXPECT_LT((middle - Point<3>(1, 2, 3)).norm(), 2.0 * 2 / n);
  }
}

TEST(Cage, Cube) {
  const Constraints<3> corners = cube_cage({0, 0, 1}, 6);
  ASSERT_EQ(corners.size(), 8u);
  for (const Constraint<3>& each : corners)
    EXPECT_EQ((each.at - Point<3>(0, 0, 1)).cwiseAbs(), Point<3>(3, 3, 3));
  EXPECT_EQ(cube_cage({0, 0, 0}, 1, 5).size(), 6u * 16 + 2);
}

TEST(Cage, AShapeWithinIsClosed) {  // section 5: a tetrahedron's corners in a cube of side 6
  Constraints<3> scene = cube_cage(Point<3>::Zero(), 6);
  for (const Point<3>& corner :
       {Point<3>(1, 1, 1), Point<3>(1, -1, -1), Point<3>(-1, 1, -1), Point<3>(-1, -1, 1)})
    scene.push_back(boundary<3>(0.35 * corner));
  const Fit<3> fitted = fit(scene);
  EXPECT_GT(fitted.function.value({0, 0, 0}), 0);
  Random random(1);
  for (int i = 0; i < 100; ++i) EXPECT_LT(fitted.function.value(2 * random.direction<3>()), 0);
}

TEST(PolygonalTorus, IsAClosedTorus) {
  for (const auto& [around, across] : {std::pair(24, 12), std::pair(7, 5), std::pair(3, 3)}) {
    const TorusShape shape{.center = {1, 2, 3}, .axis = {1, 1, 0}, .major = 2, .minor = 0.5};
    const TriangleMesh mesh = polygonal_torus(shape, around, across);
    const MeshReport report = check_mesh(mesh);
    EXPECT_EQ(report.vertices, around * across);
    EXPECT_TRUE(report.closed && report.manifold && report.oriented);
    EXPECT_EQ(report.components, 1);
    EXPECT_EQ(report.genus, 1);
    EXPECT_GT(report.volume, 0);  // outward
    if (around == 24) {
      EXPECT_NEAR(report.volume, 2 * pi * pi * 2 * 0.25, 0.08 * report.volume);
      EXPECT_GT(report.smallest_angle, 20);
    }
    for (Index i = 0; i < mesh.vertices.cols(); ++i) {
      const Point<3> x = mesh.vertices.col(i) - shape.center;
      const double height = x.dot(shape.axis.normalized());
      EXPECT_NEAR(std::hypot((x - height * shape.axis.normalized()).norm() - 2, height), 0.5, 1e-14);
      // The given normal leads out along the tube's radius.
      const Point<3> core = shape.center + 2 * (x - height * shape.axis.normalized()).normalized();
      EXPECT_NEAR((mesh.vertices.col(i) - core).normalized().dot(mesh.normals.col(i)), 1, 1e-13);
    }
  }
}

TEST(BranchingPrisms, Count) {  // 1 + 3 + 9 + 27 prisms of six corners and a center
  const BranchingPrisms made = branching_prisms();
  ASSERT_EQ(made.constraints.size(), 40u * 7);
  EXPECT_EQ(made.prisms.vertices.cols(), 40 * 6);
  for (std::size_t i = 0; i < made.constraints.size(); ++i) {
    const bool center = i % 7 == 6;
    EXPECT_EQ(made.constraints[i].kind, center ? ConstraintKind::interior : ConstraintKind::boundary);
    if (center) continue;
    EXPECT_EQ(made.constraints[i].at,
              Point<3>(made.prisms.vertices.col(static_cast<Index>(i / 7 * 6 + i % 7))));
  }
  const MeshReport report = check_mesh(made.prisms);
  EXPECT_TRUE(report.closed && report.manifold && report.oriented);
  EXPECT_EQ(report.components, 40);
  EXPECT_EQ(report.genus, 0);
  // Each generation has 3 shrink^3 the volume of its parents.
  const BranchingPrismsOptions o;
  const double first = 0.75 * std::sqrt(3) * o.radius * o.radius * o.height, q = 3 * std::pow(o.shrink, 3);
  EXPECT_NEAR(report.volume, first * (1 + q + q * q + q * q * q), 1e-12 * report.volume);
  EXPECT_EQ(branching_prisms({.generations = 1}).constraints.size(), 7u);
}

// The pairs of different prisms whose faces cross.
std::set<std::pair<int, int>> crossing_prisms(const BranchingPrismsOptions& options) {
  std::set<std::pair<int, int>> crossing;
  for (const auto& [a, b] : self_intersections(branching_prisms(options).prisms))
    if (a / 8 != b / 8) crossing.insert(std::minmax(a / 8, b / 8));
  return crossing;
}

TEST(BranchingPrisms, ChildrenStandOnTheirParents) {
  // A gap of 0 is where they touch: a hair above nothing crosses, a hair below every child cuts its own
  // parent and nothing else.
  std::set<std::pair<int, int>> families;
  for (int child = 1; child < 40; ++child) families.insert({(child - 1) / 3, child});
  for (BranchingPrismsOptions each : {BranchingPrismsOptions{},
                                      {.tilt = 0},
                                      {.shrink = 0.3, .tilt = 40, .spread = 0.4},  // foot within the top
                                      {.shrink = 0.4, .tilt = -10}}) {
    SCOPED_TRACE(each.tilt);
    each.gap = 0.001;
    EXPECT_TRUE(crossing_prisms(each).empty());
    each.gap = -0.001;
    EXPECT_EQ(crossing_prisms(each), families);
  }
  EXPECT_LE(BranchingPrismsOptions().gap, 0.1);
}

TEST(BranchingPrisms, ThreefoldSymmetry) {
  const BranchingPrisms made = branching_prisms({.generations = 3});
  const Fit<3> fitted = fit(made.constraints, {.condition = false});
  EXPECT_LT(fitted.report.max_residual, 2e-8);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(2 * pi / 3, Point<3>::UnitZ()).toRotationMatrix();
  Random random(2);
  for (int i = 0; i < 20; ++i) {
    const Point<3> x = random.points_in<3>(fitted.function.bounding_box(), 1).col(0);
    EXPECT_NEAR(fitted.function.value(x), fitted.function.value(turn * x), 1e-7);
  }
}

// Blends.

struct Object {
  Constraints<3> constraints;
  Fit<3> fitted;
  explicit Object(const TriangleMesh& mesh)
      : constraints(constraints_from(mesh).constraints), fitted(fit(constraints, {.condition = false})) {}
  BlendObject<3> as_object() const { return {constraints, &fitted.function}; }
};

std::vector<Object> three_tori() {  // Fig. 9
  std::vector<Object> tori;
  for (int k = 0; k < 3; ++k) {
    const double angle = 2 * pi * k / 3;
    tori.emplace_back(polygonal_torus({.center = 0.9 * Point<3>(std::cos(angle), std::sin(angle), 0),
                                       .axis = {std::cos(angle + 1), std::sin(angle + 1), 1.5},
                                       .major = 1,
                                       .minor = 0.3},
                                      20, 9));
  }
  return tori;
}

TEST(Blend, KeepsWhatIsOutsideAllOthers) {
  const std::vector<Object> tori = three_tori();
  const Blend<3> mixed = blend<3>({tori[0].as_object(), tori[1].as_object(), tori[2].as_object()});
  ASSERT_EQ(mixed.constraints.size(), mixed.origins.size());
  std::vector<Index> kept(3, 0);
  for (std::size_t i = 0; i < mixed.constraints.size(); ++i) {
    const auto [object, index] = mixed.origins[i];
    const Constraint<3>& each = mixed.constraints[i];
    EXPECT_EQ(each.at, tori[object].constraints[index].at);
    kept[object] += 1 + each.normal.has_value();
    for (std::size_t other = 0; other < 3; ++other) {
      if (other == object) continue;
      EXPECT_LT(tori[other].fitted.function.value(each.at), 0);
      if (!each.normal) continue;
      const Point<3> companion = each.at - each.normal->offset * each.normal->direction;
      EXPECT_LT(tori[other].fitted.function.value(companion), 0);
    }
  }
  EXPECT_EQ(kept, mixed.kept);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(mixed.kept[k] + mixed.dropped[k], 2 * 180);
    EXPECT_GT(mixed.dropped[k], 10);
  }
  // Nothing was dropped without a reason.
  std::size_t outside = 0;
  for (std::size_t a = 0; a < 3; ++a)
    for (const Constraint<3>& each : tori[a].constraints) {
      bool in = false;
      for (std::size_t b = 0; b < 3; ++b) in |= b != a && tori[b].fitted.function.value(each.at) >= 0;
      outside += !in;
    }
  EXPECT_EQ(mixed.constraints.size(), outside);
}

TEST(Blend, OrderDoesNotMatterAndFarFromSeamsItIsTheUnion) {
  const std::vector<Object> tori = three_tori();
  const BlendObject<3> a = tori[0].as_object(), b = tori[1].as_object(), c = tori[2].as_object();
  const Fit<3> one = fit(blend<3>({a, b, c}).constraints), two = fit(blend<3>({c, a, b}).constraints);
  const Union<3> hard({borrow<3>(*a.function), borrow<3>(*b.function), borrow<3>(*c.function)});
  Random random(3);
  const Points<3> x = random.points_in<3>(hard.bounding_box(), 20000);
  const Values f = one.function.values(x), g = two.function.values(x), h = hard.values(x);
  EXPECT_LT((f - g).cwiseAbs().maxCoeff(), 1e-6 * f.cwiseAbs().maxCoeff());
  Points<3> slopes(3, x.cols());
  Values again(x.cols());
  hard.evaluate(x, again, slopes);
  int asked = 0, differ = 0;
  for (Index i = 0; i < x.cols(); ++i) {
    // Far from the surface, by a tenth of the tube, the sign is the union's; seams only ever fill in.
    if (std::abs(h[i]) < 0.1 * slopes.col(i).norm()) continue;
    ++asked;
    differ += (f[i] > 0) != (h[i] > 0);
  }
  EXPECT_GT(asked, 10000);
  EXPECT_LT(differ, 0.002 * asked);
}

TEST(Blend, CompanionsGoWithTheirBoundaryConstraint) {
  // A box of which one boundary constraint is inside B, and of another only the companion.
  const Fit<2> b = fit<2>({boundary<2>({-1, 0}), boundary<2>({1, 0}), boundary<2>({0, -1}),
                           boundary<2>({0, 1}), interior<2>({0, 0})});
  const Constraints<2> mine = {boundary<2>({0.5, 0}, {1, 0}, 1.5),  // inside B, its companion is not
                               boundary<2>({1.1, 0}, {1, 0}, 0.5),  // the other way round
                               boundary<2>({3, 0}, {1, 0}, 0.5),    // both outside
                               boundary<2>({1, 0}, {-1, 0}, 0.5),   // exactly on B: not outside
                               interior<2>({0.1, 0.2}),
                               exterior<2>({4, 0})};
  const Fit<2> a = fit(mine);
  const Blend<2> mixed = blend<2>({{mine, &a.function}, {{}, &b.function}});
  ASSERT_EQ(mixed.constraints.size(), 3u);
  EXPECT_EQ(mixed.origins[0].constraint, 1u);
  EXPECT_FALSE(mixed.constraints[0].normal.has_value());
  EXPECT_TRUE(mixed.constraints[1].normal.has_value());
  EXPECT_EQ(mixed.constraints[2].kind, ConstraintKind::exterior);
  EXPECT_EQ(mixed.kept[0], 4);
  EXPECT_EQ(mixed.dropped[0], 6);
}

TEST(Blend, OneAloneAndNoneLeft) {
  const Object torus(polygonal_torus({}, 12, 8));
  const Blend<3> alone = blend<3>({torus.as_object()});
  EXPECT_EQ(alone.constraints.size(), torus.constraints.size());
  EXPECT_EQ(alone.dropped[0], 0);
  EXPECT_THROW(blend<3>({}), Error);
  // Two objects that are one another's inside.
  const Constraints<2> in_b = {boundary<2>({0.1, 0})}, in_a = {boundary<2>({-0.1, 0})};
  const Fit<2> big = fit<2>({boundary<2>({-1, 0}), boundary<2>({1, 0}), boundary<2>({0, -1}),
                             boundary<2>({0, 1}), interior<2>({0, 0})});
  EXPECT_THROW(blend<2>({{in_b, &big.function}, {in_a, &big.function}}), Error);
}

}  // namespace
}  // namespace seesaw
