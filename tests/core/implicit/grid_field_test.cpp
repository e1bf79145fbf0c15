#include "core/implicit/grid_field.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"

namespace seesaw {
namespace {

// Smooth, and no polynomial.
class Waves final : public Field<2> {
 public:
  void evaluate(const PointsRef<2>& p, Eigen::Ref<Values> v) const override {
    for (Index i = 0; i < p.cols(); ++i) v[i] = std::sin(2 * p(0, i)) * std::cos(p(1, i)) + 0.3 * p(0, i);
  }
  void evaluate(const PointsRef<2>& p, Eigen::Ref<Values> v, Eigen::Ref<Points<2>> g) const override {
    evaluate(p, v);
    for (Index i = 0; i < p.cols(); ++i)
      g.col(i) = Point<2>(2 * std::cos(2 * p(0, i)) * std::cos(p(1, i)) + 0.3,
                          -std::sin(2 * p(0, i)) * std::sin(p(1, i)));
  }
  double gradient_bound(const Box<2>&) const override { return 2.6; }
  Box<2> bounding_box() const override { return {Point<2>(-1, -1), Point<2>(2, 1)}; }
};

Points<2> random_points(const Box<2>& box, Index count) {
  Random random(5);
  return random.points_in<2>(box, count);
}

double largest_error(const Field<2>& a, const Field<2>& b, const Points<2>& points) {
  return (a.values(points) - b.values(points)).cwiseAbs().maxCoeff();
}

TEST(GridField, IsExactAtItsCornersWithItsGradient) {
  const Waves waves;
  const Box<2> box = waves.bounding_box();
  const GridField grid(waves, box, 12, 8);
  for (int r = 0; r <= 8; ++r)
    for (int c = 0; c <= 12; ++c) {
      const Point<2> p = box.min() + Point<2>(0.25 * c, 0.25 * r);
      EXPECT_NEAR(grid.value(p), waves.value(p), 1e-14);
      EXPECT_LT((grid.gradient(p) - waves.gradient(p)).norm(), 1e-13);
    }
}

// The one-sided differences of the mixed derivative at the rim are of lower order; inside it is the fourth.
TEST(GridField, IsOffByTheFourthPowerOfACell) {
  const Waves waves;
  const Box<2> box = waves.bounding_box();
  const Points<2> inside = random_points({Point<2>(-0.7, -0.7), Point<2>(1.7, 0.7)}, 2000);
  const double coarse = largest_error(GridField(waves, box, 12, 8), waves, inside);
  const double fine = largest_error(GridField(waves, box, 24, 16), waves, inside);
  EXPECT_LT(coarse, 1e-3);
  EXPECT_GT(coarse / fine, 11) << "16 for the fourth order";
  const Points<2> anywhere = random_points(box, 2000);
  EXPECT_LT(largest_error(GridField(waves, box, 48, 32), waves, anywhere), 2e-5);
}

TEST(GridField, HasTheGradientOfItsValues) {
  const GridField grid(Waves(), Waves().bounding_box(), 9, 7);
  const Points<2> points = random_points(grid.bounding_box(), 500);
  for (Index i = 0; i < points.cols(); ++i) {
    const Point<2> p = points.col(i), g = grid.gradient(p);
    constexpr double h = 1e-6;
    for (int d = 0; d < 2; ++d) {
      Point<2> step = Point<2>::Zero();
      step[d] = h;
      EXPECT_NEAR((grid.value(p + step) - grid.value(p - step)) / (2 * h), g[d], 1e-7);
    }
  }
}

TEST(GridField, GoesOnBeyondItsRimAndAnswersWhatIsNoPlace) {
  const GridField grid(Waves(), Waves().bounding_box(), 9, 7);
  const Point<2> rim(2, 0.3);
  EXPECT_NEAR(grid.value(rim + Point<2>(1e-9, 0)), grid.value(rim), 1e-8);
  EXPECT_TRUE(std::isfinite(grid.value({3, 5})));
  EXPECT_TRUE(std::isnan(grid.value({std::nan(""), 0})));
  EXPECT_TRUE(std::isnan(grid.value({infinity, 0})));
}

}  // namespace
}  // namespace seesaw
