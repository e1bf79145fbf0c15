// Where a click in the plane, or a ray in space, meets the shape.
#include "core/editing/pick.h"

#include <gtest/gtest.h>

#include "core/editing/editor.h"
#include "tests/core/editing/documents.h"

namespace seesaw {
namespace {

TEST(Pick, FindsThePointOfTheCurveThatIsNearest) {
  const auto function = Editor<2>(start_document<2>()).shape().function;
  const Points<2> seeds = boundary_points(start_document<2>());
  Random random(3);
  for (int i = 0; i < 20; ++i) {
    const Point<2> near = random.points_in<2>(Box<2>(Point<2>(-2, -2), Point<2>(2, 2)), 1).col(0);
    const auto foot = nearest_on_curve(*function, near, seeds);
    ASSERT_TRUE(foot);
    EXPECT_LT(std::abs(function->value(*foot)), 1e-14);
    // No point of a circle a little smaller is on the other side of the curve. At the foot's own angle the
    // circle and the curve touch: an error e of the foot costs only e^2 of the distance.
    const double distance = (*foot - near).norm();
    EXPECT_LT(
        std::abs(
            (*foot - near)
                .normalized()
                .dot(Point<2>(function->gradient(*foot).y(), -function->gradient(*foot).x()).normalized())),
        1e-9);
    for (int k = 0; k < 720; ++k) {
      const double angle = k * M_PI / 360;
      const Point<2> on = near + (distance - 1e-9) * Point<2>(std::cos(angle), std::sin(angle));
      EXPECT_EQ(function->value(on) >= 0, function->value(near) >= 0) << i << " " << k;
    }
  }
  const Fit<2> empty = fit<2>({exterior<2>({0, 0}), exterior<2>({1, 0}), exterior<2>({0, 1})});
  EXPECT_FALSE(nearest_on_curve(empty.function, {0, 0}, Points<2>(2, 0)));
}

TEST(Pick, ARayMeetsTheSurfaceFirstWhereAPersonSeesIt) {
  // Two balls behind one another, and rays from in front, between, within and behind.
  Constraints<3> balls;
  for (const double z : {0.0, 4.0}) {
    balls.push_back(interior<3>({0, 0, z}));
    for (const Point<3>& d : {Point<3>(1, 0, 0), Point<3>(0, 1, 0), Point<3>(0, 0, 1)})
      for (const double s : {-1.0, 1.0}) balls.push_back(boundary<3>(Point<3>(0, 0, z) + s * d));
  }
  balls.push_back(exterior<3>({0, 0, 2}));
  const auto f = std::make_shared<const Interpolant<3>>(fit(balls).function);
  const auto hit = [&](double z, double direction) {
    const auto found = first_on_surface(f, {0, 0, z}, {0, 0, 100 * direction});
    return found ? found->z() : std::nan("");
  };
  EXPECT_NEAR(hit(20, -1), 5, 1e-12);
  EXPECT_NEAR(hit(4, -1), 3, 1e-12) << "from within, out";
  EXPECT_NEAR(hit(2, -1), 1, 1e-12);
  EXPECT_NEAR(hit(2, 1), 3, 1e-12);
  EXPECT_NEAR(hit(-20, 1), -1, 1e-12);
  EXPECT_TRUE(std::isnan(hit(20, 1)));
}

TEST(Pick, WhereTheBoxCutsTheSolidIsNoSurface) {
  // A plane: all below z = 0 is inside, as far as the box goes.
  const auto f =
      std::make_shared<const Interpolant<3>>(fit<3>({boundary<3>({1, 0, 0}), boundary<3>({-1, 0, 0}),
                                                     boundary<3>({0, 1, 0}), interior<3>({0, 0, -1})})
                                                 .function);
  const auto up = first_on_surface(f, {0.1, 0.2, -20}, {0, 0, 1});
  ASSERT_TRUE(up);
  EXPECT_NEAR(up->z(), 0, 1e-12);
  EXPECT_FALSE(first_on_surface(f, {-20, 0.1, -0.5}, {1, 0, 0}));
}

}  // namespace
}  // namespace seesaw
