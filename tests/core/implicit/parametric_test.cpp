// Witkin & Heckbert's four functions, for each of their shapes: F, F_x, F_q, bounding box.
#include "core/implicit/parametric.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/implicit/parametric_shapes.h"
#include "tests/support/differences.h"
#include "tests/support/parametric.h"

namespace seesaw {
namespace {

template <int Dim>
Points<Dim> random_points(Random& random, Index n) {
  return random.points_in<Dim>(Box<Dim>(Point<Dim>::Constant(-1), Point<Dim>::Constant(1)), n);
}

Values random_deviations(Random& random, Index n) {
  Values s(n);
  for (Index i = 0; i < n; ++i) s[i] = random.uniform(0.3, 1);
  return s;
}

// One of each class, at random.
template <int Dim>
std::vector<std::unique_ptr<ParametricField<Dim>>> all_shapes(Random& random) {
  std::vector<std::unique_ptr<ParametricField<Dim>>> shapes;
  shapes.push_back(
      std::make_unique<ParametricSphere<Dim>>(random_points<Dim>(random, 1).col(0), random.uniform(0.5, 2)));
  const Points<Dim> centers = random_points<Dim>(random, 4), ends = random_points<Dim>(random, 4);
  shapes.push_back(std::make_unique<ParametricBlobbySpheres<Dim>>(
      BlobbySpheres<Dim>(random.uniform(0.1, 0.9), centers, random_deviations(random, 4))));
  shapes.push_back(std::make_unique<ParametricBlobbyCylinders<Dim>>(
      BlobbyCylinders<Dim>(random.uniform(0.1, 0.9), centers, ends, random_deviations(random, 4))));
  return shapes;
}

template <int Dim>
void expect_four_functions_agree(std::uint64_t seed) {
  Random random(seed);
  for (const auto& shape : all_shapes<Dim>(random)) {
    SCOPED_TRACE(shape->names().back());
    ASSERT_EQ(shape->parameters(), static_cast<Index>(shape->names().size()));
    const Points<Dim> points = random.points_in<Dim>(shape->bounding_box(), 20);
    for (const auto& x : points.colwise()) {
      // Where a segment's nearest point passes an end, second derivatives jump: O(step) instead of O(step^2).
      expect_gradient_matches_differences<Dim>(*shape, x, 1e-6, 1e-5, 1e-2);
      for (const double size : {1.0, 0.1}) {
        const Box<Dim> box(x - Point<Dim>::Constant(size), x + Point<Dim>::Constant(size));
        expect_gradient_bound_holds<Dim>(*shape, box, 100, random);
      }
    }
    expect_q_gradients_match_differences<Dim>(*shape, points, 1e-6, 1e-5);
    const Box<Dim> box = shape->bounding_box();
    const Points<Dim> around = random.points_in<Dim>(grown(box, 1.0), 2000);
    for (const auto& x : around.colwise())
      EXPECT_TRUE(box.contains(Point<Dim>(x)) || shape->value(x) < 0) << x.transpose();
  }
}

TEST(ParametricShapes, GradientsBoundsAndBoxes2D) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) expect_four_functions_agree<2>(seed);
}
TEST(ParametricShapes, GradientsBoundsAndBoxes3D) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) expect_four_functions_agree<3>(seed);
}

TEST(ParametricShapes, CountsAndNamesAreThePapers) {
  Random random(1);
  const auto shapes = all_shapes<3>(random);
  EXPECT_EQ(shapes[0]->names(), (std::vector<std::string>{"c.x", "c.y", "c.z", "r"}));
  EXPECT_EQ(shapes[1]->parameters(), 4 * 4 + 1);
  EXPECT_EQ(shapes[2]->parameters(), 7 * 4 + 1);
  EXPECT_EQ(shapes[1]->names()[4], "s0");
  EXPECT_EQ(shapes[2]->names()[4], "b0.x");
}

// f = -F with F as printed in section 5.
TEST(ParametricShapes, SignIsOurs) {
  Random random(2);
  const Points<3> centers = random_points<3>(random, 3);
  const Values s = random_deviations(random, 3);
  const ParametricBlobbySpheres<3> blobs(BlobbySpheres<3>(0.4, centers, s));
  const Point<3> x(0.2, -0.3, 0.5);
  double theirs = 0.4;
  Values their_q(13);
  their_q[0] = 1;
  for (Index i = 0; i < 3; ++i) {
    const Point<3> away = x - centers.col(i);
    const double g = std::exp(-away.squaredNorm() / (s[i] * s[i]));
    theirs -= g;
    their_q.segment<3>(1 + 4 * i) = -2 * away / (s[i] * s[i]) * g;
    their_q[4 + 4 * i] = -2 * away.squaredNorm() / std::pow(s[i], 3) * g;
  }
  EXPECT_NEAR(blobs.value(x), -theirs, 1e-15);
  EXPECT_LT((blobs.q_gradients(x) + their_q).norm(), 1e-14);

  const ParametricSphere<3> sphere({1, 2, 3}, 2);
  EXPECT_DOUBLE_EQ(sphere.value({1, 2, 3.5}), 4 - 0.25);
  EXPECT_DOUBLE_EQ(sphere.value({1, 5, 3}), 4 - 9);
}

TEST(ParametricShapes, FrozenParametersDoNotMove) {
  Random random(3);
  for (const auto& shape : all_shapes<3>(random)) expect_freezing_works(*shape, random);
}

TEST(ParametricShapes, RefuseWhatIsNoNumber) {
  Random random(7);
  for (const auto& shape : all_shapes<3>(random)) {
    const Values before = shape->q();
    Values q = before;
    q[1] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(shape->set_q(q), Error);
    EXPECT_EQ(shape->q(), before);
  }
}

// Dynamics may carry a radius through zero; the shape is even in it.
TEST(ParametricShapes, RadiiMayChangeSign) {
  Random random(4);
  for (const auto& shape : all_shapes<3>(random)) {
    const Points<3> x = random_points<3>(random, 10);
    const Values before = shape->values(x);
    Values q = shape->q();
    const std::vector<std::string> names = shape->names();
    for (Index i = 0; i < q.size(); ++i) {
      const char kind = names[static_cast<std::size_t>(i)][0];
      if (kind == 's' || kind == 'r') q[i] = -q[i];
    }
    shape->set_q(q);
    EXPECT_EQ(shape->q(), q);
    EXPECT_EQ(shape->values(x), before);
    expect_q_gradients_match_differences<3>(*shape, x, 1e-6, 1e-5);
    for (Index i = 0; i < q.size(); ++i)
      if (q[i] < 0 && names[static_cast<std::size_t>(i)][0] == 's') q[i] = 0;
    shape->set_q(q);
    EXPECT_TRUE(shape->values(x).allFinite());
    EXPECT_TRUE(shape->q_gradients(x).allFinite());
  }
}

TEST(BlobbyCylinders, OneIsACylinderWithRoundEnds) {
  const double radius = 0.5, t = 0.3;
  const BlobbyCylinders<3> one(t, Point<3>(0, 0, 0), Point<3>(2, 0, 0),
                               Values{{BlobbySpheres<3>::deviation_for(radius, t)}});
  Random random(5);
  for (int i = 0; i < 20; ++i) {
    const double angle = random.uniform(0, 6.28), x = random.uniform(0, 2);
    EXPECT_NEAR(one.value({x, radius * std::cos(angle), radius * std::sin(angle)}), 0, 1e-15);
    Point<3> out = random.direction<3>();
    out.x() = std::abs(out.x());
    EXPECT_NEAR(one.value(Point<3>(2, 0, 0) + radius * out), 0, 1e-15);
  }
  EXPECT_GT(one.value({1, 0, 0}), 0);
}

TEST(BlobbyCylinders, WithoutLengthAreBlobbySpheres) {
  Random random(6);
  const Points<3> centers = random_points<3>(random, 3), x = random_points<3>(random, 50);
  const Values s = random_deviations(random, 3);
  const ParametricBlobbyCylinders<3> cylinders(BlobbyCylinders<3>(0.5, centers, centers, s));
  const BlobbySpheres<3> spheres(0.5, centers, s);
  EXPECT_EQ(cylinders.values(x), spheres.values(x));
  const Box<3> box(Point<3>::Constant(-0.2), Point<3>::Constant(0.3));
  EXPECT_LE(spheres.gradient_bound(box), cylinders.gradient_bound(box));
  EXPECT_TRUE(cylinders.q_gradients(x).allFinite());
}

}  // namespace
}  // namespace seesaw
