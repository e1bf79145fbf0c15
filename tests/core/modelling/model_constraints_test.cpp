#include "core/modelling/model_constraints.h"

#include <gtest/gtest.h>

#include <limits>
#include <tuple>

#include "core/modelling/point_sampling.h"
#include "core/modelling/polygonal_torus.h"
#include "core/modelling/triangle_tree.h"
#include "core/rbf/fit.h"
#include "core/rbf/system.h"
#include "tests/core/modelling/models.h"

namespace seesaw {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Points<3> normals_of(const Constraints<3>& constraints) {
  Points<3> normals(3, static_cast<Index>(constraints.size()));
  for (std::size_t i = 0; i < constraints.size(); ++i)
    normals.col(static_cast<Index>(i)) = constraints[i].normal->direction;
  return normals;
}

// The tree against a look at all triangles.

TEST(TriangleTree, AgreesWithBruteForce) {
  Random random(1);
  const Box<3> box(Point<3>::Constant(-1), Point<3>::Constant(1));
  // Scattered triangles, a quarter of them degenerate: two or three corners in one.
  const Points<3> vertices = random.points_in<3>(box, 300);
  Faces faces(3, 200);
  for (Index f = 0; f < faces.cols(); ++f)
    for (int k = 0; k < 3; ++k) faces(k, f) = static_cast<int>(random.index(vertices.cols()));
  for (Index f = 0; f < 50; ++f) faces(1, f) = faces(2, f);
  for (Index f = 0; f < 25; ++f) faces(0, f) = faces(2, f);
  const TriangleTree tree(vertices, faces);
  const auto corner = [&](Index f, int k) { return Point<3>(vertices.col(faces(k, f))); };
  int hits = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const Point<3> x = random.points_in<3>(grown(box, 0.2), 1).col(0);
    const Point<3> direction = trial % 4 ? random.direction<3>() : Point<3>(Point<3>::Unit(trial / 4 % 3));
    const auto odd = [&](int face) { return trial % 2 && face % 2; };
    double nearest = infinity, first = nearest;
    int within = 0;
    for (Index f = 0; f < faces.cols(); ++f) {
      const double d = (nearest_in_triangle(x, corner(f, 0), corner(f, 1), corner(f, 2)) - x).norm();
      within += d <= 0.3;
      if (odd(static_cast<int>(f))) continue;
      nearest = std::min(nearest, d);
      first = std::min(first, ray_hits_triangle(x, direction, corner(f, 0), corner(f, 1), corner(f, 2)));
    }
    const auto found = tree.nearest(x, infinity, odd);
    EXPECT_NEAR(found.distance, nearest, 1e-15);
    EXPECT_NEAR((found.point - x).norm(), nearest, 1e-15);
    EXPECT_EQ(tree.nearest(x, 0.99 * nearest, odd).face, -1);
    EXPECT_EQ(tree.first_hit(x, direction, infinity, odd).distance, first);
    hits += first < 10;
    int visited = 0;
    tree.visit_within(x, 0.3, [&](int) { ++visited; });
    EXPECT_EQ(visited, within);
  }
  EXPECT_GT(hits, 100);
  EXPECT_EQ(TriangleTree(vertices, Faces(3, 0)).nearest({0, 0, 0}).face, -1);
}

TEST(TriangleTree, NearestPointIsNearest) {  // no point of the triangle is nearer
  Random random(2);
  const Box<3> box(Point<3>::Constant(-1), Point<3>::Constant(1));
  for (int trial = 0; trial < 50; ++trial) {
    const Points<3> t = random.points_in<3>(box, 3);
    const Point<3> x = random.points_in<3>(box, 1).col(0);
    const Point<3> foot = nearest_in_triangle(x, t.col(0), t.col(1), t.col(2));
    for (int i = 0; i < 100; ++i) {
      const double u = random.uniform(), v = random.uniform(0, 1 - u);
      const Point<3> other = t.col(0) + u * (t.col(1) - t.col(0)) + v * (t.col(2) - t.col(0));
      EXPECT_LE((foot - x).norm(), (other - x).norm() + 1e-14);
    }
  }
}

// The paper's rule.

TEST(ModelConstraints, OneOfEachAVertex) {
  const TriangleMesh mesh = ellipsoid({3, 2, 1.5});
  const ModelConstraints made = constraints_from(mesh);
  ASSERT_EQ(static_cast<Index>(made.constraints.size()), mesh.vertices.cols());
  EXPECT_EQ(made.report.boundary, mesh.vertices.cols());
  EXPECT_EQ(made.report.normal, mesh.vertices.cols());
  EXPECT_EQ(made.report.shrunk + made.report.lowered + made.report.no_room + made.report.crowded, 0);
  const double longest = bounding_box_of<3>(mesh.vertices).sizes().maxCoeff();
  for (std::size_t i = 0; i < made.constraints.size(); ++i) {
    const Constraint<3>& each = made.constraints[i];
    EXPECT_EQ(each.at, Point<3>(mesh.vertices.col(static_cast<Index>(i))));
    EXPECT_DOUBLE_EQ(each.normal->offset, 0.01 * longest);
    EXPECT_EQ(each.normal->value, 1);
    EXPECT_GT(each.normal->direction.dot(each.at), 0);  // outward
  }
  const Fit<3> fitted = fit(made.constraints);
  EXPECT_LT(fitted.report.max_residual, 2e-8);
  EXPECT_GT(fitted.function.value({0, 0, 0}), 0);
  EXPECT_LT(fitted.function.value({3.1, 0, 0}), 0);
}

TEST(ModelConstraints, UnitCubeAndSides) {
  const TriangleMesh mesh = ellipsoid({30, 20, 15});
  const ModelConstraints unit = constraints_from(mesh, {.offset = 0.02, .to_unit_cube = true});
  Box<3> box;
  for (const Constraint<3>& each : unit.constraints) box.extend(each.at);
  EXPECT_NEAR(box.sizes().maxCoeff(), 1, 1e-15);
  EXPECT_NEAR(box.center().norm(), 0, 1e-15);
  EXPECT_EQ(unit.constraints[0].normal->offset, 0.02);
  const ModelConstraints outside =
      constraints_from(mesh, {.side = NormalSide::outside, .to_unit_cube = true});
  EXPECT_EQ(outside.constraints[0].normal->offset, -0.01);
  EXPECT_EQ(outside.constraints[0].normal->value, -1);
  const ModelConstraints both = constraints_from(mesh, {.side = NormalSide::both, .to_unit_cube = true});
  EXPECT_EQ(both.report.normal, 2 * mesh.vertices.cols());
  EXPECT_EQ(static_cast<Index>(both.constraints.size()), 2 * mesh.vertices.cols());
  for (const auto& made : {outside, both}) {
    const Fit<3> fitted = fit(made.constraints);
    EXPECT_GT(fitted.function.value({0, 0, 0}), 0);
    EXPECT_LT(fitted.function.value({0, 0, 0.3}), 0);
  }
}

TEST(ModelConstraints, AtAnyPlaceAndSize) {  // the same constraints, moved and scaled
  const TriangleMesh mesh = ellipsoid({0.5, 0.3, 0.012});
  const ModelConstraints here = constraints_from(mesh);
  EXPECT_GT(here.report.shrunk, 100);
  for (const auto& [scale, shift, digits] : {std::tuple(1e-9, 0.0, 1e-12), std::tuple(1.0, 1e7, 1e-5)}) {
    TriangleMesh moved = mesh;
    moved.vertices = (scale * mesh.vertices).array() + shift;
    const ModelConstraints there = constraints_from(moved);
    EXPECT_EQ(there.report.normal, here.report.normal);
    EXPECT_EQ(there.report.shrunk, here.report.shrunk);
    for (std::size_t i = 0; i < here.constraints.size(); ++i) {
      EXPECT_NEAR(there.constraints[i].normal->offset / scale, here.constraints[i].normal->offset, digits);
      EXPECT_NEAR(there.constraints[i].normal->value, here.constraints[i].normal->value, 1e3 * digits);
    }
    const Fit<3> fitted = fit(there.constraints);
    EXPECT_GT(fitted.function.value(Point<3>::Constant(shift)), 0);
    EXPECT_LT(fitted.function.value(Point<3>(shift, shift, shift + 0.03 * scale)), 0);
  }
}

// Thin places. What is inside an ellipsoid is known exactly.

double wrong_share(const Field<3>& field, const Point<3>& radii) {
  Random random(5);
  const Box<3> room(-2 * radii, 2 * radii);
  Points<3> x = random.points_in<3>(room, 20000);
  const Values f = field.values(x);
  int wrong = 0, asked = 0;
  for (Index i = 0; i < x.cols(); ++i) {
    const double q = x.col(i).cwiseQuotient(radii).norm();
    if (std::abs(q - 1) < 0.15) continue;  // the ellipsoid is not what polygons interpolate
    ++asked;
    wrong += (f[i] > 0) != (q < 1);
  }
  return static_cast<double>(wrong) / asked;
}

TEST(ModelConstraints, AThinBladeWantsLess) {
  for (const double half : {0.015, 0.008}) {
    const Point<3> radii(0.5, 0.3, half);
    const TriangleMesh mesh = ellipsoid(radii, 36, 20);
    const ModelConstraints fixed = constraints_from(mesh, {.shrink = false});
    const ModelConstraints made = constraints_from(mesh);
    EXPECT_EQ(fixed.report.shrunk, 0);
    EXPECT_GT(made.report.shrunk, mesh.vertices.cols() / 2);
    EXPECT_GT(made.report.smallest, 1e-4);
    EXPECT_LT(made.report.smallest, 0.01);
    // Every companion is inside the solid, where the fixed ones are not.
    int out = 0;
    const auto companion_is_out = [&](const Constraint<3>& each) {
      const Point<3> at = each.at - each.normal->offset * each.normal->direction;
      return at.cwiseQuotient(radii).norm() > 1;
    };
    for (const Constraint<3>& each : made.constraints) EXPECT_FALSE(companion_is_out(each));
    for (const Constraint<3>& each : fixed.constraints) out += companion_is_out(each);
    EXPECT_GT(out, 0);
    EXPECT_LT(wrong_share(fit(made.constraints).function, radii), 0.02) << half;
    EXPECT_GT(wrong_share(fit(fixed.constraints).function, radii), 0.10) << half;
  }
}

TEST(ModelConstraints, APlateOfTwoSheetsEndsAtAThird) {
  // Two squares, 0.012 apart, facing away from each other; far from their rims.
  TriangleMesh mesh;
  constexpr int n = 8;
  mesh.vertices.resize(3, 2 * n * n);
  std::vector<Eigen::Vector3i> faces;
  for (int sheet = 0; sheet < 2; ++sheet)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) {
        const int i = sheet * n * n + y * n + x;
        mesh.vertices.col(i) = Point<3>(x / (n - 1.0), y / (n - 1.0), sheet ? 0.006 : -0.006);
        if (x + 1 == n || y + 1 == n) continue;
        Eigen::Vector3i a(i, i + 1, i + n + 1), b(i, i + n + 1, i + n);
        if (!sheet) std::swap(a[1], a[2]), std::swap(b[1], b[2]);
        faces.push_back(a);
        faces.push_back(b);
      }
  mesh.faces.resize(3, static_cast<Index>(faces.size()));
  for (std::size_t f = 0; f < faces.size(); ++f) mesh.faces.col(static_cast<Index>(f)) = faces[f];
  const ModelConstraints made = constraints_from(mesh);  // a mesh with holes all around: no matter
  EXPECT_EQ(made.report.shrunk, 2 * n * n);
  for (const Constraint<3>& each : made.constraints) {
    EXPECT_NEAR(each.normal->offset, 0.004, 1e-12);
    EXPECT_EQ(each.normal->value, 1);
  }
  // The same by the cloud's rule, which knows no faces: no less safe.
  const PointCloud cloud{mesh.vertices, normals_of(made.constraints)};
  for (const Constraint<3>& each : constraints_from(cloud).constraints)
    EXPECT_NEAR(each.normal->offset, 0.004, 1e-12);
  // Outside there is room for all of it.
  EXPECT_EQ(constraints_from(mesh, {.side = NormalSide::outside}).report.shrunk, 0);
}

TEST(ModelConstraints, AFoldIsSeenFromOutside) {
  // Two tori whose tubes come within 0.005 of each other: outside is where the steps collide.
  TriangleMesh mesh = polygonal_torus({.major = 0.3, .minor = 0.1}, 40, 24);
  const TriangleMesh other = polygonal_torus({.center = {0, 0, 0.205}, .major = 0.3, .minor = 0.1}, 40, 24);
  const Index n = mesh.vertices.cols();
  TriangleMesh two;
  two.vertices.resize(3, 2 * n);
  two.vertices << mesh.vertices, other.vertices;
  two.faces.resize(3, 2 * mesh.faces.cols());
  two.faces << mesh.faces, Faces(other.faces.array() + static_cast<int>(n));
  EXPECT_EQ(constraints_from(two).report.shrunk, 0);
  const ModelConstraints outside = constraints_from(two, {.side = NormalSide::outside});
  EXPECT_GT(outside.report.shrunk, 40);
  EXPECT_LT(outside.report.shrunk, n / 2);
  EXPECT_GT(outside.report.smallest, 0.001);
}

// Clouds.

TEST(ModelConstraints, BadNormalsAreDroppedAndCounted) {
  Random random(7);
  PointCloud cloud = random_sphere(200, random);
  cloud.normals.col(3).setZero();
  cloud.normals.col(50)[1] = nan;
  cloud.normals.col(51)[2] = infinity;
  cloud.normals.col(60) *= 1e-200;  // short, but a direction
  cloud.normals.col(61) *= 1e200;
  const ModelConstraints made = constraints_from(cloud);
  EXPECT_EQ(made.report.boundary, 200);
  EXPECT_EQ(made.report.normal, 197);
  EXPECT_EQ(made.report.normals_unknown, 3);
  EXPECT_FALSE(made.constraints[3].normal.has_value());
  EXPECT_NEAR((made.constraints[60].normal->direction - cloud.points.col(60)).norm(), 0, 1e-15);
  EXPECT_NEAR((made.constraints[61].normal->direction - cloud.points.col(61)).norm(), 0, 1e-15);
  const Fit<3> fitted = fit(made.constraints);
  for (int i = 0; i < 200; ++i) {
    const Point<3> out = random.direction<3>();
    EXPECT_GT(fitted.function.value(0.8 * out), 0);
    EXPECT_LT(fitted.function.value(1.2 * out), 0);
  }
  // Without any, there are boundary constraints alone.
  cloud.normals.resize(3, 0);
  EXPECT_EQ(constraints_from(cloud).report.normals_unknown, 200);
}

TEST(ModelConstraints, OnePositionWithSeveralNormalsKeepsThem) {
  Random random(8);
  PointCloud cloud = random_sphere(100, random);
  // A scan's crease: three normals at each of ten points, one of them twice.
  PointCloud creased;
  creased.points.resize(3, 130);
  creased.normals.resize(3, 130);
  creased.points << cloud.points, cloud.points.leftCols(10), cloud.points.leftCols(10),
      cloud.points.leftCols(10);
  creased.normals << cloud.normals, cloud.normals.leftCols(10), cloud.normals.leftCols(10),
      cloud.normals.leftCols(10);
  for (Index i = 100; i < 120; ++i)
    creased.normals.col(i) = (creased.normals.col(i) + 0.4 * random.direction<3>()).normalized();
  const ModelConstraints made = constraints_from(creased);
  EXPECT_EQ(made.report.boundary, 130);
  EXPECT_EQ(made.report.normal, 130);
  const Fit<3> fitted = fit(made.constraints);
  EXPECT_EQ(fitted.report.rows, 100 + 120);  // positions and distinct normals
  EXPECT_LT(fitted.report.max_residual, 2e-8);
}

TEST(ModelConstraints, CrowdsAreThinned) {  // and the solver then has no complaint
  Random random(9);
  PointCloud cloud = random_sphere(300, random);
  for (Index i = 0; i < 100; ++i)
    cloud.points.col(200 + i) = cloud.points.col(i) + 1e-6 * random.direction<3>();
  const ModelConstraints made = constraints_from(cloud);
  EXPECT_EQ(made.report.crowded, 100);
  EXPECT_EQ(made.report.boundary, 200);
  EXPECT_LT(fit(made.constraints).report.max_residual, 1e-6);
  EXPECT_THROW(fit(constraints_from(cloud, {.crowded = 1e-9}).constraints), ConstraintError);
}

TEST(ModelConstraints, Refusals) {
  EXPECT_THROW(constraints_from(PointCloud()), Error);
  TriangleMesh faceless;
  faceless.vertices = Points<3>::Zero(3, 5);
  EXPECT_THROW(constraints_from(faceless), Error);
  const TriangleMesh mesh = ellipsoid({3, 2, 1.5});
  EXPECT_THROW(constraints_from(mesh, ModelConstraintOptions(), [](double) { return false; }), Cancelled);
}

// Choosing.

TEST(FarthestPoints, SpreadOut) {
  Random random(3);
  const Points<3> points = random.points_in<3>(Box<3>(Point<3>::Zero(), Point<3>(1, 1, 0)), 5000);
  const PointSample sample = farthest_points(points, 100);
  ASSERT_EQ(sample.chosen.size(), 100u);
  double nearest = 9, farthest = 0;
  for (std::size_t i = 0; i < 100; ++i)
    for (std::size_t j = 0; j < i; ++j)
      nearest = std::min(nearest, (points.col(sample.chosen[i]) - points.col(sample.chosen[j])).norm());
  for (Index p = 0; p < points.cols(); ++p) {
    double d = 9;
    for (const Index each : sample.chosen) d = std::min(d, (points.col(p) - points.col(each)).norm());
    farthest = std::max(farthest, d);
  }
  EXPECT_DOUBLE_EQ(sample.covering_radius, farthest);
  EXPECT_GE(nearest, farthest);  // Gonzalez's invariant
  // 100 points of a unit square cannot cover it with less than 0.0707 * 0.87; twice that is guaranteed.
  EXPECT_LT(farthest, 0.13);
  // A prefix of the choice is the smaller choice; a start is kept.
  EXPECT_EQ(farthest_points(points, 10).chosen,
            std::vector<Index>(sample.chosen.begin(), sample.chosen.begin() + 10));
  EXPECT_EQ(farthest_points(points, 3, {17, 4}).chosen[1], 4);
}

TEST(FarthestPoints, NoMoreThanThereAre) {
  Points<3> points(3, 6);
  points << 0, 1, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0;  // three positions
  const PointSample sample = farthest_points(points, 6);
  EXPECT_EQ(sample.chosen.size(), 3u);
  EXPECT_EQ(sample.covering_radius, 0);
  EXPECT_TRUE(farthest_points(Points<3>(3, 0), 5).chosen.empty());
}

}  // namespace
}  // namespace seesaw
