#include "core/contour/roots.h"

#include <gtest/gtest.h>

#include "tests/core/contour/test_fields.h"

namespace seesaw {
namespace {

struct Answer {
  Point<2> position;
  Point<2> gradient;
  Index evaluations;
};

Answer root(const FunctionField::Function& function, const Point<2>& inside, const Point<2>& outside) {
  const FunctionField field(function);
  Sampler sampler(field, 0);
  Values f;
  sampler.evaluate(inside, f);
  const Values f_in = f;
  sampler.evaluate(outside, f);
  EXPECT_TRUE(is_inside(f_in[0]));
  EXPECT_FALSE(is_inside(f[0]));
  const Roots roots = find_roots(sampler, inside, outside, f_in, f, 1e-13);
  return {roots.positions.col(0), roots.gradients.col(0), sampler.evaluations - 2};
}

TEST(Roots, SmoothFieldsTakeAHandfulOfEvaluations) {
  const Answer a = root(
      [](const Point<2>& p) {
        return Jet{2 - std::exp(p.x()), {-std::exp(p.x()), 0}};
      },
      {0, 3}, {1, 3});
  EXPECT_NEAR(a.position.x(), std::log(2.0), 1e-13);
  EXPECT_EQ(a.position.y(), 3) << "a shared coordinate is shared exactly";
  EXPECT_NEAR(a.gradient.x(), -2, 1e-12);
  EXPECT_LE(a.evaluations, 6);
}

TEST(Roots, AnExactZeroAtTheInsideEndIsTheRoot) {
  const Answer a = root(
      [](const Point<2>& p) {
        return Jet{-p.x() * (1 + p.x()), {-1 - 2 * p.x(), 0}};
      },
      {0, 0}, {1, 0});
  EXPECT_EQ(a.position, Point<2>(0, 0));
  EXPECT_EQ(a.gradient, Point<2>(-1, 0));
  EXPECT_EQ(a.evaluations, 1);
  const Answer minus = root(
      [](const Point<2>& p) {
        return Jet{p.x() == 0 ? -0.0 : -p.x(), {-1, 0}};
      },
      {0, 0}, {1, 0});
  EXPECT_EQ(minus.position, Point<2>(0, 0)) << "-0.0 is zero";
}

TEST(Roots, HardFunctionsEndToo) {
  const double where = 0.3141592653589793;
  const auto check = [&](const char* name, double tolerance, const std::function<Jet(double)>& f) {
    const Answer a = root([&](const Point<2>& p) { return f(where - p.x()); }, {0, 0}, {1, 0});
    EXPECT_NEAR(a.position.x(), where, tolerance) << name;
    EXPECT_LE(a.evaluations, 120) << name;
  };
  check("triple root", 1e-9, [](double u) { return Jet{u * u * u, {-3 * u * u, 0}}; });
  check("vertical tangent", 1e-10, [](double u) {
    return Jet{std::cbrt(u), {-1 / (3 * std::pow(std::cbrt(u), 2)), 0}};
  });
  check("jump", 1e-12, [](double u) { return Jet{u >= 0 ? 1.0 : -1.0, {0, 0}}; });
  check("no gradient", 1e-12, [](double u) { return Jet{u * (1 + u * u), {0, 0}}; });
  check("wrong gradient", 1e-12, [](double u) { return Jet{u, {+1, 0}}; });
  check("flat then steep", 1e-12, [](double u) {
    return Jet{std::expm1(50 * u), {-50 * std::exp(50 * u), 0}};
  });
  check("undefined outside", 1e-12, [](double u) {
    return Jet{u >= 0 ? 1 + u : std::numeric_limits<double>::quiet_NaN(), {-1, 0}};
  });
  // Rounding in f of 1e-11, as in fields with huge weights: as near as that allows, and no more steps than
  // needed.
  const Answer noisy = root(
      [&](const Point<2>& p) {
        const double u = where - p.x();
        return Jet{u + 1e-11 * std::sin(1e15 * u), {-1, 0}};
      },
      {0, 0}, {1, 0});
  EXPECT_NEAR(noisy.position.x(), where, 1e-10);
  EXPECT_LE(noisy.evaluations, 12);
}

}  // namespace
}  // namespace seesaw
