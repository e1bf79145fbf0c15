// What Turk & O'Brien 2002 say of the fitted function, as tests; and what must hold of any such fit.
#include "core/rbf/fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <numeric>
#include <thread>

#include "core/rbf/energy.h"
#include "core/rbf/gradient_bound.h"
#include "tests/core/rbf/dense_oracle.h"
#include "tests/support/differences.h"
#include "tests/support/shapes.h"

namespace seesaw {
namespace {

const Kernel kernels[] = {Kernel::thin_plate_spline, Kernel::cubic, Kernel::linear};

template <int Dim>
void expect_meets_constraints(const Constraints<Dim>& constraints, const Interpolant<Dim>& f) {
  const double tolerance = rounding_of(f);
  for (const auto& constraint : constraints) {
    EXPECT_NEAR(f.value(constraint.at), constraint.value, tolerance);
    if (!constraint.normal) continue;
    const auto& normal = *constraint.normal;
    EXPECT_NEAR(f.value(constraint.at - normal.offset * normal.direction.normalized()), normal.value,
                tolerance);
  }
}

TEST(Fit, DocstringExample) {
  Constraints<2> shape = {boundary<2>({-1, 0}), boundary<2>({1, 0}), boundary<2>({0, -1}),
                          boundary<2>({0, 1}), interior<2>({0, 0})};
  const Fit<2> fitted = fit(shape);
  EXPECT_NEAR(fitted.function.value({0, 0}), 1.0, 1e-15);
  EXPECT_LT(fitted.function.value({2, 0}), 0.0);
  EXPECT_LT(fitted.report.max_residual, 1e-15);
}

template <class T>
class FitIn : public testing::Test {};
template <int D>
struct Dimension {
  static constexpr int value = D;
};
using Dimensions = testing::Types<Dimension<2>, Dimension<3>, Dimension<4>>;
TYPED_TEST_SUITE(FitIn, Dimensions);

TYPED_TEST(FitIn, EveryKernelInterpolates) {  // eqs. 6, 7
  constexpr int Dim = TypeParam::value;
  for (const Kernel kernel : kernels) {
    Random random(1);
    const auto constraints = random_constraints<Dim>(30, random);
    const auto fitted = fit(constraints, {.kernel = kernel});
    expect_meets_constraints(constraints, fitted.function);
    EXPECT_LT(fitted.report.max_residual, 3e-11);  // the papers' scale: normals 0.02 inside, |f| up to 2
    EXPECT_EQ(fitted.report.kernel, kernel);
    EXPECT_EQ(fitted.report.boundary + fitted.report.interior + fitted.report.exterior, 30);
    EXPECT_EQ(fitted.report.rows, 40);
    EXPECT_EQ(fitted.report.normal, 10);
    EXPECT_EQ(fitted.report.constraints(), 40);
    EXPECT_EQ(fitted.report.polynomial_rank, Dim + 1);
    EXPECT_FALSE(fitted.report.degenerate);
    EXPECT_GT(fitted.report.reciprocal_condition, 1e-12);
    EXPECT_LE(fitted.report.reciprocal_condition, 1.0);
  }
}

TYPED_TEST(FitIn, WeightsMeetTheSideConditionsOfEquation8) {
  constexpr int Dim = TypeParam::value;
  for (const Kernel kernel : kernels) {
    Random random(2);
    const auto fitted = fit(random_constraints<Dim>(25, random), {.kernel = kernel});
    const Values w = fitted.function.weights();
    const double size = w.cwiseAbs().sum();
    EXPECT_NEAR(w.sum(), 0.0, 1e-14 * size);
    EXPECT_LE((fitted.function.centers() * w).cwiseAbs().maxCoeff(), 1e-14 * size);
  }
}

TYPED_TEST(FitIn, WeightsAndPolynomialAreThoseOfEquation8) {
  // Eq. 8 as printed, in scene units (far from normalized ones), by LU.
  constexpr int Dim = TypeParam::value;
  for (const Kernel kernel : kernels) {
    Random random(3);
    ScatteredData<Dim> data(20, random);
    data.points = (7.5 * data.points).colwise() + Point<Dim>::Constant(3);
    const Index n = 20;
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + Dim + 1, n + Dim + 1);
    for (Index i = 0; i < n; ++i) {
      for (Index j = 0; j < n; ++j) {
        const double r = (data.points.col(i) - data.points.col(j)).norm();
        if (i != j)
          system(i, j) = kernel == Kernel::cubic    ? r * r * r
                         : kernel == Kernel::linear ? r
                                                    : r * r * std::log(r);
      }
      system(i, n) = system(n, i) = 1;
      for (int d = 0; d < Dim; ++d) system(i, n + 1 + d) = system(n + 1 + d, i) = data.points(d, i);
    }
    Values right = Values::Zero(n + Dim + 1);
    right.head(n) = data.values;
    const Values solution = solve_by_lu(system, right);
    const auto f = fit_values<Dim>(data.points, data.values, {.kernel = kernel}).function;
    EXPECT_LE((f.weights() - solution.head(n)).norm(), 1e-10 * solution.head(n).norm()) << name_of(kernel);
    EXPECT_LE((f.polynomial() - solution.tail(Dim + 1)).norm(), 1e-10 * solution.tail(Dim + 1).norm())
        << name_of(kernel);
  }
}

TYPED_TEST(FitIn, DerivativesAgreeWithDifferences) {
  constexpr int Dim = TypeParam::value;
  for (const Kernel kernel : kernels) {
    Random random(4);
    const ScatteredData<Dim> data(15, random);
    const auto f = fit_values<Dim>(data.points, data.values, {.kernel = kernel}).function;
    for (int i = 0; i < 20; ++i) {
      const Point<Dim> x = random.points_in<Dim>(f.bounding_box(), 1).col(0);
      expect_gradient_matches_differences<Dim>(f, x, 1e-5, 1e-6);
      const auto hessian = f.hessian(x);
      Eigen::Matrix<double, Dim, Dim> differences;
      for (int d = 0; d < Dim; ++d) {
        const Point<Dim> h = 1e-5 * Point<Dim>::Unit(d);
        differences.col(d) = (f.gradient(x + h) - f.gradient(x - h)) / 2e-5;
      }
      EXPECT_LE((hessian - differences).norm(), 1e-5 * std::max(1.0, hessian.norm())) << name_of(kernel);
    }
  }
}

TYPED_TEST(FitIn, SimilarityChangesNothing) {
  // Rotated, scaled and moved constraints give the rotated, scaled and moved function.
  constexpr int Dim = TypeParam::value;
  for (const Kernel kernel : kernels) {
    Random random(5);
    const ScatteredData<Dim> data(30, random);
    // Two reflections are a rotation.
    const Point<Dim> u = random.direction<Dim>(), v = random.direction<Dim>();
    const Eigen::Matrix<double, Dim, Dim> one = Eigen::Matrix<double, Dim, Dim>::Identity();
    const Eigen::Matrix<double, Dim, Dim> rotation =
        (one - 2 * u * u.transpose()).lazyProduct(one - 2 * v * v.transpose());
    const Point<Dim> shift = 100 * random.direction<Dim>();
    const auto moved = [&](const Points<Dim>& x) -> Points<Dim> {
      return (37.0 * rotation * x).colwise() + shift;
    };
    const auto f = fit_values<Dim>(data.points, data.values, {.kernel = kernel}).function;
    const auto g = fit_values<Dim>(moved(data.points), data.values, {.kernel = kernel}).function;
    const Points<Dim> x = random.points_in<Dim>(f.bounding_box(), 50);
    EXPECT_LE((f.values(x) - g.values(moved(x))).cwiseAbs().maxCoeff(), 1e-9) << name_of(kernel);
  }
}

TYPED_TEST(FitIn, OrderOfConstraintsIsIrrelevant) {
  constexpr int Dim = TypeParam::value;
  Random random(6);
  auto constraints = random_constraints<Dim>(40, random);
  const auto first = fit(constraints);
  const auto& f = first.function;
  for (std::size_t i = constraints.size(); i > 1; --i)
    std::swap(constraints[i - 1], constraints[static_cast<std::size_t>(random.index(static_cast<Index>(i)))]);
  const auto g = fit(constraints).function;
  const Points<Dim> x = random.points_in<Dim>(f.bounding_box(), 100);
  // Another order rounds otherwise; the condition says how much of that can reach the values.
  const double rounding = 2.2e-16 / first.report.reciprocal_condition * f.values(x).cwiseAbs().maxCoeff();
  EXPECT_LE((f.values(x) - g.values(x)).cwiseAbs().maxCoeff(), rounding);
  EXPECT_LT(rounding, 1e-6);
}

TYPED_TEST(FitIn, GradientBoundHoldsAndTightens) {
  constexpr int Dim = TypeParam::value;
  for (const Kernel kernel : kernels) {
    Random random(8);
    const auto f = fit(random_constraints<Dim>(30, random), {.kernel = kernel}).function;
    for (int i = 0; i < 200; ++i) {
      const Point<Dim> center = i % 4 == 0 ? Point<Dim>(f.centers().col(i % f.size()))
                                           : Point<Dim>(random.points_in<Dim>(f.bounding_box(), 1).col(0));
      const Point<Dim> reach = Point<Dim>::Constant(std::pow(10.0, random.uniform(-6, 0.5)));
      expect_gradient_bound_holds<Dim>(f, Box<Dim>(center - reach, center + reach), 200, random);
    }
    // Away from centers the bound closes in on the gradient at the middle, at first order in the box's size.
    const Point<Dim> x = Point<Dim>::Constant(2.5);
    const double steepness = f.gradient(x).norm();
    double excess = 0;
    for (const double size : {1e-2, 1e-3, 1e-4}) {
      const Point<Dim> reach = Point<Dim>::Constant(size);
      const double now = f.gradient_bound(Box<Dim>(x - reach, x + reach)) / steepness - 1;
      EXPECT_GE(now, 0.0);
      if (excess > 0) {
        EXPECT_LT(now, 0.2 * excess) << name_of(kernel);
      }
      excess = now;
    }
    EXPECT_LT(excess, 1e-3);
  }
}

// One center at a distance of d radii, for which the true maximum is known: at the point of the ball that is
// farthest from it, for r^3 3 (d + 1)^2. Tensors' norms and the sixth derivatives' constants show here.
TYPED_TEST(FitIn, GradientBoundOfOneCenter) {
  constexpr int Dim = TypeParam::value;
  std::array<double, Dim> coordinates;
  std::array<const double*, Dim> rows;
  const double weight = 1;
  for (std::size_t d = 0; d < Dim; ++d) rows[d] = &coordinates[d];
  Random random(9);
  const Box<Dim> box(Point<Dim>::Constant(-1 / std::sqrt(Dim)), Point<Dim>::Constant(1 / std::sqrt(Dim)));
  for (const char* loops : {"portable", "avx2", "avx512"}) {
    const KernelSums* before = &kernel_sums();
    if (!kernel_sums_named(loops)) continue;
    use_kernel_sums(*kernel_sums_named(loops));
    for (const double d : {0.0, 0.5, 1.4, 1.51, 1.6, 2.0, 3.0, 10.0, 1000.0})
      for (int i = 0; i < 5; ++i) {
        const Point<Dim> center = d * random.direction<Dim>();
        for (std::size_t k = 0; k < Dim; ++k) coordinates[k] = center[static_cast<Index>(k)];
        const CenterArrays centers{rows.data(), &weight, 1};
        const double bound = kernel_gradient_bound<Dim>(Kernel::cubic, centers, Point<Dim>::Zero(), box);
        const double largest = 3 * (d + 1) * (d + 1);
        EXPECT_GE(bound, largest * (1 - 1e-12)) << d;
        EXPECT_LE(bound, largest * (d > 2.9 ? 1.6 : 3)) << d;
        // Its gradient is a unit vector everywhere.
        EXPECT_GE(kernel_gradient_bound<Dim>(Kernel::linear, centers, Point<Dim>::Zero(), box), 1);
      }
    use_kernel_sums(*before);
  }
}

TEST(Fit, PositiveInsideNegativeAround) {  // section 4.1, Fig. 1
  const auto constraints = four_around_one();
  const auto f = fit(constraints).function;
  for (int i = 0; i < 64; ++i) {
    const Point<2> direction(std::cos(i * M_PI / 32), std::sin(i * M_PI / 32));
    EXPECT_LT(f.value(2.5 * direction), 0.0);
    EXPECT_LT(f.value(10 * direction), 0.0);
  }
  EXPECT_GT(f.value({0.1, 0.1}), 0.0);
}

TEST(Fit, BoundaryConstraintOnTheCurveChangesNothing) {  // section 5
  const auto constraints = four_around_one();
  const auto f = fit(constraints).function;
  // Walk from inside to a zero by bisection, in several directions.
  auto more = constraints;
  for (int i = 0; i < 5; ++i) {
    const Point<2> direction(std::cos(i * 1.3), std::sin(i * 1.3));
    double inside = 0, outside = 3;
    while (outside - inside > 1e-15) {
      const double middle = 0.5 * (inside + outside);
      if (middle == inside || middle == outside) break;
      (f.value(middle * direction) > 0 ? inside : outside) = middle;
    }
    more.push_back(boundary<2>(inside * direction));
  }
  const auto g = fit(more).function;
  Random random(9);
  const Points<2> x = random.points_in<2>(f.bounding_box(), 1000);
  EXPECT_LE((f.values(x) - g.values(x)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Fit, EnergyIsEquation3ByQuadrature) {  // E(f) = 8 pi w'h in 2D
  const auto constraints = four_around_one();
  const auto fitted = fit(constraints);
  const auto& f = fitted.function;
  // Polar midpoint rule with r = tan: over the whole plane the integrand falls as r^-4, so the tail beyond r
  // costs O(r^-2). The integrand has log^2 peaks at the centers; 4 million points bring their error below
  // 1e-3.
  const Index rings = 1500, spokes = 2400;
  double energy = 0;
  Points<2> x(2, spokes);
  Hessians<2> h(4, spokes);
  for (Index i = 0; i < rings; ++i) {
    const double t = (static_cast<double>(i) + 0.5) / static_cast<double>(rings) * M_PI / 2;
    const double r = std::tan(t), dr = M_PI / 2 / static_cast<double>(rings) / std::pow(std::cos(t), 2);
    for (Index j = 0; j < spokes; ++j) {
      const double angle = 2 * M_PI * (static_cast<double>(j) + 0.5 * static_cast<double>(i % 2)) /
                           static_cast<double>(spokes);
      x.col(j) = r * Point<2>(std::cos(angle), std::sin(angle));
    }
    f.evaluate_hessians(x, h);
    energy += h.squaredNorm() * r * dr * 2 * M_PI / static_cast<double>(spokes);
  }
  EXPECT_NEAR(energy / fitted.report.energy, 1.0, 2e-3);
  // And the closed form: 8 pi w'h with only the interior value not zero.
  EXPECT_NEAR(fitted.report.energy, 8 * M_PI * f.weights()[4], 1e-12 * fitted.report.energy);
}

TEST(Fit, EnergyFactorsAreThoseOfTheFundamentalSolutions) {
  EXPECT_NEAR(energy_factor(Kernel::thin_plate_spline, 2), 8 * M_PI,
              1e-12);                                              // bilaplacian of r^2 log r in 2D
  EXPECT_NEAR(energy_factor(Kernel::linear, 3), 8 * M_PI, 1e-12);  // bilaplacian of r in 3D, but for sign
  EXPECT_NEAR(energy_factor(Kernel::cubic, 3), 96 * M_PI, 1e-11);  // trilaplacian of r^3 in 3D
  EXPECT_NEAR(energy_factor(Kernel::cubic, 1), 12, 1e-12);  // fourth derivative of |x|^3: cubic splines
}

TEST(Fit, EnergyScalesAsTheIntegralDoes) {
  for (const Kernel kernel : kernels) {
    Random random(10);
    const ScatteredData<3> data(20, random);
    const double one = fit_values<3>(data.points, data.values, {.kernel = kernel}).report.energy;
    const double scaled = fit_values<3>(5 * data.points, data.values, {.kernel = kernel}).report.energy;
    const double doubled = fit_values<3>(data.points, 2 * data.values, {.kernel = kernel}).report.energy;
    EXPECT_GT(one, 0);
    EXPECT_NEAR(scaled / one, std::pow(5, -growth_of(kernel)), 1e-9);
    EXPECT_NEAR(doubled / one, 4, 1e-9);
  }
}

TEST(Fit, FewerConstraintsNeedLessEnergy) {
  for (const Kernel kernel : kernels) {
    Random random(11);
    const ScatteredData<2> data(20, random);
    double before = 0;
    for (Index n = 4; n <= 20; ++n) {
      const double energy =
          fit_values<2>(data.points.leftCols(n), data.values.head(n), {.kernel = kernel}).report.energy;
      EXPECT_GE(energy, before * (1 - 1e-9));
      before = energy;
    }
  }
}

TEST(Fit, LinearDataGiveALinearFunction) {
  for (const Kernel kernel : kernels) {
    Random random(12);
    ScatteredData<3> data(30, random);
    const Point<3> slope(2, -1, 0.5);
    data.values = (slope.transpose() * data.points).transpose().array() + 3;
    const auto fitted = fit_values<3>(data.points, data.values, {.kernel = kernel});
    EXPECT_LE(fitted.function.weights().cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LE((fitted.function.gradient({10, 20, 30}) - slope).norm(), 1e-10);
    EXPECT_NEAR(fitted.report.energy, 0, 1e-10);
  }
}

TEST(Fit, SmoothingMissesByLambdaTimesTheWeights) {
  for (const Kernel kernel : kernels) {
    Random random(13);
    const ScatteredData<2> data(40, random);
    const Points<2> points = 3 * data.points;  // not the solver's own units
    const double lambda = 0.3;
    const auto fitted = fit_values<2>(points, data.values, {.kernel = kernel, .smoothing = lambda});
    const Values missed = data.values - fitted.function.values(points);
    const double sign = kernel == Kernel::linear ? -1 : 1;
    EXPECT_LE((missed - lambda * sign * fitted.function.weights()).norm(), 1e-12 * missed.norm() + 1e-13);
    EXPECT_NEAR(fitted.report.max_residual, missed.cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(Fit, StrongSmoothingIsTheLeastSquaresPlane) {
  Random random(14);
  const ScatteredData<2> data(40, random);
  const auto f = fit_values<2>(data.points, data.values, {.smoothing = 1e9}).function;
  Eigen::MatrixXd p(40, 3);
  p << Values::Ones(40), data.points.transpose();
  const Values plane = solve_by_lu(p.transpose() * p, p.transpose() * data.values);
  EXPECT_LE((f.polynomial() - plane).norm(), 1e-6);
}

TEST(Fit, SameResultWhateverTheThreads) {
  Random random(15);
  const ScatteredData<3> data(1200, random);
  std::vector<Interpolant<3>> functions;
  std::vector<Values> values;
  Points<3> x;
  for (const int threads : {1, 2, 5}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);  // also where there are fewer cores
    arena.execute([&] {
      const auto f = fit_values<3>(data.points, data.values).function;
      if (functions.empty()) x = random.points_in<3>(f.bounding_box(), 5000);
      values.push_back(f.values(x));
      functions.push_back(f);
    });
  }
  for (std::size_t k = 0; k < functions.size(); ++k) {
    EXPECT_EQ(functions[k].weights(), functions[0].weights());
    EXPECT_EQ(values[k], values[0]);
  }
  for (Index i = 0; i < x.cols(); i += 97) EXPECT_EQ(functions[0].value(x.col(i)), values[0][i]);
}

// The listener's thread is the one that asked, the fraction never falls, and the digits do not depend on it.
TEST(Fit, SaysHowFarItIsAndStopsWhereToldTo) {
  Random random(16);
  const ScatteredData<2> data(1000, random);
  const std::thread::id here = std::this_thread::get_id();
  std::vector<double> fractions;
  const auto watched = fit_values<2>(data.points, data.values, {}, [&](double fraction) {
    EXPECT_EQ(std::this_thread::get_id(), here);
    fractions.push_back(fraction);
    return true;
  });
  EXPECT_TRUE(std::ranges::is_sorted(fractions));
  EXPECT_GE(fractions.front(), 0.0);
  EXPECT_EQ(fractions.back(), 1.0);
  EXPECT_EQ(watched.function.weights(), fit_values<2>(data.points, data.values).function.weights());
  for (const double last : {0.0, 0.1, 0.5, 0.8, 0.95, 1.0}) {
    bool stopped = false;
    const auto until_last = [&](double fraction) {
      EXPECT_FALSE(stopped) << "asked again after it had said stop";
      return !(stopped = fraction >= last);
    };
    EXPECT_THROW(fit_values<2>(data.points, data.values, {}, until_last), Cancelled);
  }
}

}  // namespace
}  // namespace seesaw
