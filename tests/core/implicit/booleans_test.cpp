#include "core/implicit/booleans.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/implicit/blobby.h"
#include "core/implicit/boxed.h"
#include "core/implicit/primitives.h"
#include "core/implicit/torus.h"
#include "tests/support/differences.h"

namespace seesaw {
namespace {

const Box<3> room(Point<3>::Constant(-3), Point<3>::Constant(3));

// A plane x_d = 0, inside above it, without any bound of its slope.
class Unbounded final : public Field<3> {
 public:
  void evaluate(const PointsRef<3>& points, Eigen::Ref<Values> values) const override {
    values = points.row(2);
  }
  void evaluate(const PointsRef<3>& points, Eigen::Ref<Values> values,
                Eigen::Ref<Points<3>> gradients) const override {
    evaluate(points, values);
    gradients.colwise() = Point<3>(0, 0, 1);
  }
  double gradient_bound(const Box<3>&) const override { return infinity; }
  Box<3> bounding_box() const override { return Box<3>(); }
};

struct Solids {
  FieldPointer<3> ball = share(Sphere<3>({0.5, 0, 0}, 1.2));
  FieldPointer<3> ring = share(Torus({0, 0, 0.2}, {1, 2, 3}, 1.5, 0.6));
  FieldPointer<3> blob =
      share(BlobbySpheres<3>(0.4, Points<3>{{-1, 0.2}, {0, 0.7}, {0.3, -0.5}}, Values{{0.9, 1.1}}));
};

TEST(Booleans, SignsAreTheSetOperations) {
  const Solids s;
  const Union<3> any({s.ball, s.ring, s.blob});
  const Intersection<3> all({s.ball, s.ring, s.blob});
  const Difference<3> cut(s.ball, s.ring);
  const Difference<3> deep(share(Union<3>({s.ball, s.blob})), share(Intersection<3>({s.ring, s.blob})));
  Random random(1);
  const Points<3> x = random.points_in<3>(room, 10000);
  const Values a = s.ball->values(x), b = s.ring->values(x), c = s.blob->values(x);
  const Values u = any.values(x), i = all.values(x), d = cut.values(x), e = deep.values(x);
  int inside[4] = {};
  for (Index k = 0; k < x.cols(); ++k) {
    const bool in_a = a[k] > 0, in_b = b[k] > 0, in_c = c[k] > 0;
    ASSERT_EQ(u[k] > 0, in_a || in_b || in_c);
    ASSERT_EQ(i[k] > 0, in_a && in_b && in_c);
    ASSERT_EQ(d[k] > 0, in_a && !in_b);
    ASSERT_EQ(e[k] > 0, (in_a || in_c) && !(in_b && in_c));
    inside[0] += u[k] > 0, inside[1] += i[k] > 0, inside[2] += d[k] > 0, inside[3] += e[k] > 0;
  }
  for (const int count : inside) EXPECT_GT(count, 20);  // each was asked on both sides
}

TEST(Booleans, DeMorgan) {  // a without (b or c) = (a without b) and (a without c), values included
  const Solids s;
  const Difference<3> one(s.ball, share(Union<3>({s.ring, s.blob})));
  const Intersection<3> two({share(Difference<3>(s.ball, s.ring)), share(Difference<3>(s.ball, s.blob))});
  Random random(2);
  const Points<3> x = random.points_in<3>(room, 500);
  EXPECT_EQ(one.values(x), two.values(x));
}

TEST(Booleans, GradientAndItsBound) {
  const Solids s;
  const std::vector<FieldPointer<3>> fields = {share(Union<3>({s.ball, s.ring, s.blob})),
                                               share(Intersection<3>({s.ball, s.ring, s.blob})),
                                               share(Difference<3>(s.blob, s.ring))};
  Random random(3);
  for (const FieldPointer<3>& field : fields) {
    for (int i = 0; i < 100; ++i) {
      const Point<3> x = random.points_in<3>(room, 1).col(0);
      // Differences must not reach across a seam: all their points have one winner.
      const auto& boolean = dynamic_cast<const Boolean<3>&>(*field);
      Points<3> around(3, 7);
      around << x, Points<3>(x.replicate(1, 3) + 1e-5 * Eigen::Matrix3d::Identity()),
          Points<3>(x.replicate(1, 3) - 1e-5 * Eigen::Matrix3d::Identity());
      const std::vector<int> winners = boolean.winners(around);
      if (winners != std::vector<int>(7, winners[0])) continue;
      expect_gradient_matches_differences<3>(*field, x, 1e-5, 1e-6, 1e-2);
      EXPECT_EQ(field->value(x), boolean.values(around)[0]);
    }
    for (const double size : {3.0, 0.5, 0.05}) {
      const Point<3> x = random.points_in<3>(room, 1).col(0);
      const Box<3> box(x - Point<3>::Constant(size), x + Point<3>::Constant(size));
      expect_gradient_bound_holds<3>(*field, box, 300, random);
    }
  }
}

TEST(Booleans, ALoserDoesNotLoosenTheBound) {
  const Union<3> both({share(Sphere<3>({0, 0, 2}, 1)), share(Unbounded())});
  EXPECT_EQ(both.gradient_bound(Box<3>(Point<3>(-1, -1, -1), Point<3>(1, 1, 1))), infinity);
  const Union<3> balls(
      {share(Sphere<3>({0, 0, 0}, 1)), share(BlobbySpheres<3>(0.9, Point<3>(5, 0, 0), Values{{0.01}}))});
  EXPECT_EQ(balls.gradient_bound(Box<3>(Point<3>(-0.1, -0.1, -0.1), Point<3>(0.1, 0.1, 0.1))), 1);
  EXPECT_GT(balls.gradient_bound(Box<3>(Point<3>(4.9, -0.1, -0.1), Point<3>(5.1, 0.1, 0.1))), 80);
}

TEST(Booleans, SeamsAndZeros) {
  const FieldPointer<3> left = share(Sphere<3>({-1, 0, 0}, 2)), right = share(Sphere<3>({1, 0, 0}, 2));
  const Point<3> seam(0, std::sqrt(3), 0);
  EXPECT_EQ(Union<3>({left, right}).gradient(seam), left->gradient(seam));  // not zero: a normal for a vertex
  EXPECT_EQ(Difference<3>(left, right).gradient({0, 0, 0}), Point<3>(-right->gradient({0, 0, 0})));
  EXPECT_EQ(Difference<3>(share(Sphere<3>({0, 0, 0}, 3)), left).value({1, 0, 0}), 0);  // on the wall: kept
}

TEST(Booleans, Boxes) {
  const FieldPointer<3> a = share(Sphere<3>({0, 0, 0}, 1)), b = share(Sphere<3>({1, 0, 0}, 1)),
                        far = share(Sphere<3>({9, 0, 0}, 1));
  EXPECT_EQ(Union<3>({a, far}).bounding_box().sizes().x(), 11.5);
  EXPECT_EQ(Intersection<3>({a, b}).bounding_box().sizes().x(), 1.5);
  EXPECT_TRUE(Intersection<3>({a, far}).bounding_box().isEmpty());
  EXPECT_EQ(Difference<3>(a, b).bounding_box().sizes().x(), 2.5);
  const Sphere<3> kept({0, 0, 0}, 1);
  EXPECT_EQ(Union<3>({borrow(kept)}).value({0, 0, 0}), 1);
}

TEST(Boxed, IsTheSameFieldInAnotherBox) {
  const Sphere<3> sphere({0, 0, 0}, 1);
  const Box<3> box(Point<3>(-2, -1, 0), Point<3>(1, 3, 4));
  const Boxed<3> boxed(borrow<3>(sphere), box);
  EXPECT_EQ(boxed.bounding_box().min(), box.min());
  EXPECT_EQ(boxed.bounding_box().max(), box.max());
  const Point<3> x(0.3, -0.4, 5);
  EXPECT_EQ(boxed.value(x), sphere.value(x));
  EXPECT_EQ(boxed.gradient(x), sphere.gradient(x));
  EXPECT_EQ(boxed.gradient_bound(box), sphere.gradient_bound(box));
}

}  // namespace
}  // namespace seesaw
