// Floaters on surfaces that move: carried along, stretched, torn, closed up, and gone.
#include <gtest/gtest.h>

#include <cmath>

#include "core/particles/floaters.h"
#include "core/particles/integrals.h"
#include "core/particles/measures.h"
#include "tests/core/particles/test_surfaces.h"

namespace seesaw {
namespace {

constexpr double dt = 0.03;

// A blobby of two spheres, `apart` from each other along x.
std::shared_ptr<const BlobbySpheres<3>> two_blobs(double apart) {
  Points<3> centers = Points<3>::Zero(3, 2);
  centers(0, 0) = -0.5 * apart;
  centers(0, 1) = 0.5 * apart;
  const double s = BlobbySpheres<3>::deviation_for(1, 0.3);
  return share(BlobbySpheres<3>(0.3, centers, Values{{s, s}}));
}

TEST(MovingSurface, CarriesItsFloaters) {  // with f_t given, and without: max |f| / |f_x| < 1e-3 sigma
  for (const bool told : {true, false}) {
    if (sanitized && !told) continue;
    const auto at = [](double t) { return Point<3>(std::sin(t), 0.5 * t, 0); };
    Moving field(share(Sphere<3>(at(0), 1)));
    Floaters floaters(field, {.desired_radius = 0.08});
    floaters.equilibrate(field);
    const FloaterCounts counts = floaters.counts();
    double off = 0, gap = 0;
    // Across its own diameter in two seconds: a third of a floater's radius in each step.
    for (int k = 0; k < 100; ++k) {
      const Point<3> velocity = (at((k + 1) * dt) - at(k * dt)) / dt;
      // f(x - c(t)): f_t = -f_x . c'
      const Values rates = -(touch(field, floaters.positions()).gradients.transpose() * velocity);
      floaters.choose_velocities(field, told ? rates : Values());
      field.now = share(Sphere<3>(at((k + 1) * dt), 1));
      floaters.move(field);
      off = std::max(off, measure(floaters, field).most_off_radii);
      gap = std::max(gap, largest_gap(floaters.positions(), points_on_sphere(at((k + 1) * dt), 1, 3000)) /
                              floaters.radii().mean());
    }
    EXPECT_LT(off, 1e-3);
    EXPECT_EQ(floaters.counts().lost, 0);
    // Eq. 5 moves them as little as it can, along the normal: they part in front and crowd behind, and births
    // and deaths see to the rest.
    EXPECT_GT(floaters.counts().births, counts.births);
    EXPECT_LT(gap, 3.5);
    EXPECT_LT(floaters.equilibrate(field), 500);
    EXPECT_LT(measure(floaters, field).spacing.variation, 0.05);
  }
}

TEST(MovingSurface, BlobbyUnderADrag) {  // one sphere of two is pulled away, by f_q . q'
  double apart = 1.5;
  Moving field(two_blobs(apart));
  Floaters floaters(field, {.desired_radius = 0.06});
  floaters.equilibrate(field);
  double off = 0;
  for (int k = 0; k < 100; ++k) {  // until just before the neck breaks
    const double speed = 0.35, step = 1e-6;
    const Values rates = (two_blobs(apart + step)->values(floaters.positions()) -
                          two_blobs(apart - step)->values(floaters.positions())) /
                         (2 * step) * speed;
    floaters.choose_velocities(field, rates);
    apart += speed * dt;
    field.now = two_blobs(apart);
    floaters.move(field);
    off = std::max(off, measure(floaters, field).most_off_radii);
  }
  EXPECT_LT(off, 1e-3);
  EXPECT_EQ(floaters.counts().lost, 0);
  EXPECT_LT(floaters.equilibrate(field), 1000);
  EXPECT_LT(measure(floaters, field).spacing.variation, 0.06);
}

TEST(MovingSurface, AViolentStretchHeals) {  // Fig. 1: four times as long in a quarter of a second
  for (const bool told : {true, false}) {
    if (sanitized && told) continue;
    Capsule cylinder(0.6, 0.3);
    Floaters floaters(cylinder, {.desired_radius = 0.04, .diameter = 2});
    floaters.equilibrate(cylinder);
    const Index before = floaters.size();
    const double speed = (4 * 0.9 - 0.9) / (8 * dt);
    for (int k = 0; k < 8; ++k) {
      const Values rates = speed * cylinder.length_rates(floaters.positions());
      floaters.choose_velocities(cylinder, told ? rates : Values());
      cylinder.half_length += speed * dt;
      floaters.move(cylinder);
    }
    Points<3> surface(3, 16000);  // on its side
    for (Index i = 0; i < 16000; ++i) {
      const double a = 2 * 3.14159265 * static_cast<double>(i % 40) / 40;
      surface.col(i) << cylinder.half_length * (2 * static_cast<double>(i / 40) / 399 - 1), 0.3 * std::cos(a),
          0.3 * std::sin(a);
    }
    EXPECT_GT(largest_gap(floaters.positions(), surface), 8 * floaters.radii().mean());  // it was violent
    // "This process takes about four seconds": 133 steps. At twice that it must be over.
    for (int k = 0; k < 270; ++k) floaters.step(cylinder);
    const FloaterMeasures found = measure(floaters, cylinder);
    EXPECT_LT(largest_gap(floaters.positions(), surface), 2 * found.mean_radius) << told;
    EXPECT_LT(found.spacing.variation, 0.06) << told;
    EXPECT_LT(found.most_off_radii, 1e-3);
    EXPECT_EQ(found.astray, 0);
    // As dense as before.
    EXPECT_NEAR(static_cast<double>(floaters.size()) / static_cast<double>(before),
                cylinder.area() / Capsule(0.6, 0.3).area(), 0.15);
  }
}

TEST(MovingSurface, ANeckBreaks) {  // both parts keep floaters, and none is left where the neck was
  double apart = 1.5;
  Moving field(two_blobs(apart));
  Floaters floaters(field, {.desired_radius = 0.06});
  floaters.equilibrate(field);
  for (; apart < 4; apart += 0.02) {
    field.now = two_blobs(apart);
    floaters.step(field);
  }
  for (int k = 0; k < 30; ++k) floaters.step(field);
  ASSERT_LT(field.value({0, 0, 0}), 0);  // it did break
  EXPECT_LT(measure(floaters, field).most_off_radii, 1e-3);
  EXPECT_EQ(floaters.astray(), 0);
  floaters.equilibrate(field);
  const double left = static_cast<double>((floaters.positions().row(0).array() < 0).count());
  EXPECT_NEAR(left / static_cast<double>(floaters.size()), 0.5, 0.05);
  EXPECT_LT(measure(floaters, field).spacing.variation, 0.06);
}

TEST(MovingSurface, ATorusCloses) {  // the tube grows until the hole is gone: f = r - distance, r > R
  // Beyond r = R the distance to the core circle still makes a surface: an apple, with a dimple at its axis.
  class Apple final : public Field<3> {
   public:
    double tube = 0.3;
    void evaluate(const PointsRef<3>& points, Eigen::Ref<Values> values) const override {
      Points<3> gradients(3, points.cols());
      evaluate(points, values, gradients);
    }
    void evaluate(const PointsRef<3>& points, Eigen::Ref<Values> values,
                  Eigen::Ref<Points<3>> gradients) const override {
      for (Index i = 0; i < points.cols(); ++i) {
        const Point<3> x = points.col(i);
        const double rho = x.head<2>().norm(), distance = std::hypot(rho - 1, x[2]);
        values[i] = tube - distance;
        gradients.col(i).setZero();
        if (rho > 0 && distance > 0)
          gradients.col(i) << -(rho - 1) / rho * x[0] / distance, -(rho - 1) / rho * x[1] / distance,
              -x[2] / distance;
      }
    }
    double gradient_bound(const Box<3>&) const override { return 1; }
    Box<3> bounding_box() const override {
      return Box<3>(Point<3>(-2.5, -2.5, -1.5), Point<3>(2.5, 2.5, 1.5));
    }
  };
  Apple field;
  Floaters floaters(field, {.desired_radius = sanitized ? 0.05 : 0.03});
  floaters.equilibrate(field);
  const Index before = floaters.size();
  for (; field.tube < 1.3; field.tube += 0.01) floaters.step(field);
  for (int k = 0; k < 30; ++k) floaters.step(field);
  const FloaterMeasures found = measure(floaters, field);
  EXPECT_LT(found.most_off_radii, 1e-3);
  EXPECT_EQ(found.astray, 0);
  EXPECT_GT(found.floaters, before);
  // The inner part of the tube is inside the solid now; whoever was there has left or died.
  for (Index i = 0; i < floaters.size(); ++i) {
    const Point<3> x = floaters.positions().col(i), out = x + 1e-3 * floaters.normals().col(i);
    if (x.head<2>().norm() > 1e-2) {  // across the dimple's tip is inside again
      EXPECT_LT(field.value(out), 0);
    }
  }
  // The dimple ends in a point, where floaters of its sides do not see each other: no rest, but even.
  for (int k = 0; k < 200; ++k) floaters.step(field);
  EXPECT_LT(measure(floaters, field).spacing.variation, 0.12);
}

TEST(MovingSurface, WhereAComponentVanishesItsFloatersDie) {  // and none turns up on the other
  double radius = 0.5;
  const auto now = [&] {
    return share(Union<3>({share(Sphere<3>({0, 0, 0}, 1)), share(Sphere<3>({1.6, 0, 0}, radius))}));
  };
  Moving field(now());
  Floaters floaters(field, Points<3>{{-1, 2.1}, {0, 0}, {0, 0}}, {.desired_radius = 0.03});
  floaters.equilibrate(field);
  const Index on_first = (floaters.positions().colwise().norm().array() < 1.05).count();
  EXPECT_GT(floaters.size(), on_first + 50);
  for (; radius > 0.02; radius -= 0.01) {
    field.now = now();
    floaters.step(field);
  }
  field.now = share(Sphere<3>({0, 0, 0}, 1));
  for (int k = 0; k < 20; ++k) floaters.step(field);
  EXPECT_LT(measure(floaters, field).most_off_radii, 1e-3);
  EXPECT_GT(floaters.counts().lost, 0);
  EXPECT_NEAR(static_cast<double>(floaters.size()) / static_cast<double>(on_first), 1, 0.05);
}

TEST(MovingSurface, GoneAndBack) {
  const auto ball = share(Sphere<3>({0, 0, 0}, 1));
  const auto nothing = share(BlobbySpheres<3>(2, Point<3>(0, 0, 0), Values{{1.0}}));  // f < 0 everywhere
  Moving field(ball);
  Floaters floaters(field, {.desired_radius = 0.1});
  floaters.equilibrate(field);
  const Index before = floaters.size();
  field.now = nothing;
  for (int k = 0; k < 15; ++k) floaters.step(field);
  EXPECT_EQ(floaters.size(), 0);
  EXPECT_GE(floaters.counts().lost, before);
  field.now = ball;
  floaters.step(field);
  EXPECT_EQ(floaters.size(), 1);
  floaters.equilibrate(field);
  EXPECT_NEAR(static_cast<double>(floaters.size()), static_cast<double>(before), 4);
}

TEST(MovingSurface, NoGradientNoMotion) {  // "it is best to leave such floaters motionless"
  // f = z^2 - x^2 - y^2: at the tip of the double cone f and its gradient are zero.
  class Cone final : public Field<3> {
   public:
    double shift = 0;
    void evaluate(const PointsRef<3>& points, Eigen::Ref<Values> values) const override {
      Points<3> gradients(3, points.cols());
      evaluate(points, values, gradients);
    }
    void evaluate(const PointsRef<3>& points, Eigen::Ref<Values> values,
                  Eigen::Ref<Points<3>> gradients) const override {
      for (Index i = 0; i < points.cols(); ++i) {
        const Point<3> x = points.col(i);
        values[i] = x[2] * x[2] - x[0] * x[0] - x[1] * x[1] + shift * x[0];
        gradients.col(i) << -2 * x[0] + shift, -2 * x[1], 2 * x[2];
      }
    }
    double gradient_bound(const Box<3>&) const override { return INFINITY; }
    Box<3> bounding_box() const override { return Box<3>(Point<3>(-1, -1, -1), Point<3>(1, 1, 1)); }
  };
  Cone cone;
  cone.shift = 1;  // a gradient at the origin, to get a floater there
  Floaters floaters(cone, Point<3>(0, 0, 0), {.desired_radius = 1e-3});
  ASSERT_EQ(floaters.size(), 1);
  ASSERT_EQ(floaters.positions().norm(), 0);
  cone.shift = 0;
  floaters.choose_velocities(cone, Values{{3.0}});
  floaters.move(cone);
  EXPECT_EQ(floaters.positions().col(0).norm(), 0);
  EXPECT_EQ(floaters.counts().lost, 0);
}

}  // namespace
}  // namespace seesaw
