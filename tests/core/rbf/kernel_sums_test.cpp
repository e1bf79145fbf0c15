// The hot loop, for every instruction set this processor has, against the definition in long double.
#include "core/rbf/kernel_sums.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/base/random.h"

namespace seesaw {
namespace {

// phi(r) by its definition, and the factors of its gradient and Hessian.
struct Reference {
  long double value, slope, bend;
};
Reference reference(Kernel kernel, long double r) {
  if (r == 0) return {0, 0, 0};
  switch (kernel) {
    case Kernel::thin_plate_spline:
      return {r * r * std::log(r), 2 * std::log(r) + 1, 2 / (r * r)};
    case Kernel::cubic:
      return {r * r * r, 3 * r, 3 / r};
    case Kernel::linear:
      return {r, 1 / r, -1 / (r * r * r)};
  }
  return {};
}

struct Arrays {
  std::vector<std::vector<double>> rows;
  std::vector<double*> pointers;
  Arrays(int count, std::int64_t size, double fill = 0)
      : rows(static_cast<std::size_t>(count), std::vector<double>(static_cast<std::size_t>(size), fill)) {
    for (auto& row : rows) pointers.push_back(row.data());
  }
  double& at(int row, std::int64_t i) {
    return rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(i)];
  }
};

class KernelSumsTest : public testing::TestWithParam<std::tuple<const char*, Kernel, int>> {
 protected:
  void SetUp() override {
    sums = kernel_sums_named(std::get<0>(GetParam()));
    if (!sums) GTEST_SKIP() << "this processor has no " << std::get<0>(GetParam());
  }
  const KernelSums* sums = nullptr;
  Kernel kernel = std::get<1>(GetParam());
  int dim = std::get<2>(GetParam());
  Random random{7};
};

TEST_P(KernelSumsTest, AgreeWithTheDefinitionToRounding) {
  for (const std::int64_t n : {1, 2, 3, 63, 64, 65, 1001}) {
    const std::int64_t count = 53, padded = 56;
    Arrays centers(dim, n), points(dim, padded), gradients(dim, padded),
        hessians(dim * (dim + 1) / 2, padded);
    std::vector<double> weights, values(padded);
    for (std::int64_t j = 0; j < n; ++j) {
      weights.push_back(random.uniform(-1, 1) * std::pow(10.0, random.uniform(0, 6)));
      for (int d = 0; d < dim; ++d) centers.at(d, j) = random.uniform(-1, 1);
    }
    for (std::int64_t i = 0; i < count; ++i)
      for (int d = 0; d < dim; ++d)  // the first points stand on centers
        points.at(d, i) = i < std::min<std::int64_t>(n, 5) ? centers.at(d, i) : random.uniform(-3, 3);
    const CenterArrays c{centers.pointers.data(), weights.data(), n};
    const PointArrays p{points.pointers.data(), count};
    std::vector<double> alone(padded);
    sums->values(kernel, dim, c, p, alone.data());
    sums->gradients(kernel, dim, c, p, values.data(), gradients.pointers.data());
    sums->hessians(kernel, dim, c, p, hessians.pointers.data());
    for (std::int64_t i = 0; i < count; ++i) {
      long double value = 0, size = 0, g[4] = {}, h[10] = {}, g_size = 0, h_size = 0;
      for (std::int64_t j = 0; j < n; ++j) {
        long double d[4], s = 0;
        for (int a = 0; a < dim; ++a) {
          // The loops subtract in double; so does the definition, to judge the rest.
          d[a] = points.at(a, i) - centers.at(a, j);
          s += d[a] * d[a];
        }
        const Reference k = reference(kernel, std::sqrt(s));
        const long double w = weights[static_cast<std::size_t>(j)];
        value += w * k.value;
        size += std::abs(w * k.value);
        for (int b = 0, q = 0; b < dim; ++b) {
          g[b] += w * k.slope * d[b];
          for (int a = 0; a <= b; ++a, ++q) h[q] += w * (k.bend * d[a] * d[b] + (a == b ? k.slope : 0));
        }
        g_size += std::abs(w * k.slope) * std::sqrt(s);
        h_size += std::abs(w) * (std::abs(k.slope) + std::abs(k.bend) * s);
      }
      // A kernel's own value is good to some 5e-16; over many centers those errors cancel and the sum's own
      // error, kept near 1e-16, is what remains. r^2 log r near r = 1 is small beside its parts, hence the
      // sum of |w| r^2 in its allowance. A center on the point counts not 0 but at most 4e-19 of its weight.
      const double share = n > 500 ? 2e-16 : 6e-16;
      const double allowance =
          4e-19 * 1e6 + (kernel == Kernel::thin_plate_spline ? 4e-16 * static_cast<double>(g_size) : 0.0);
      EXPECT_NEAR(static_cast<double>(value), alone[static_cast<std::size_t>(i)],
                  share * static_cast<double>(size) + allowance);
      EXPECT_NEAR(static_cast<double>(value), values[static_cast<std::size_t>(i)],
                  share * static_cast<double>(size) + allowance);
      for (int b = 0; b < dim; ++b)
        EXPECT_NEAR(static_cast<double>(g[b]), gradients.at(b, i), 4e-15 * static_cast<double>(g_size));
      for (int q = 0; q < dim * (dim + 1) / 2; ++q)
        EXPECT_NEAR(static_cast<double>(h[q]), hessians.at(q, i), 2e-14 * static_cast<double>(h_size));
    }
  }
}

TEST_P(KernelSumsTest, APointsValueDoesNotDependOnItsBatch) {
  const std::int64_t n = 77, count = 64;
  Arrays centers(dim, n), points(dim, count), single(dim, 8);
  std::vector<double> weights, together(count), one(8);
  for (std::int64_t j = 0; j < n; ++j) {
    weights.push_back(random.uniform(-1, 1));
    for (int d = 0; d < dim; ++d) centers.at(d, j) = random.uniform(-1, 1);
  }
  for (std::int64_t i = 0; i < count; ++i)
    for (int d = 0; d < dim; ++d) points.at(d, i) = random.uniform(-1, 1);
  const CenterArrays c{centers.pointers.data(), weights.data(), n};
  sums->values(kernel, dim, c, {points.pointers.data(), count}, together.data());
  for (std::int64_t i = 0; i < count; ++i) {
    for (int d = 0; d < dim; ++d) single.at(d, 0) = points.at(d, i);
    sums->values(kernel, dim, c, {single.pointers.data(), 1}, one.data());
    EXPECT_EQ(one[0], together[static_cast<std::size_t>(i)]);
  }
}

TEST_P(KernelSumsTest, MatrixRowsAreTheKernel) {
  for (const std::int64_t n : {1, 5, 8, 100}) {
    Arrays centers(dim, n);
    std::vector<double> values(static_cast<std::size_t>(n));
    double point[4];
    for (int d = 0; d < dim; ++d) point[d] = random.uniform(-1, 1);
    for (std::int64_t j = 0; j < n; ++j)
      for (int d = 0; d < dim; ++d) centers.at(d, j) = j == 3 ? point[d] : random.uniform(-1, 1);
    sums->kernel_values(kernel, dim, {centers.pointers.data(), nullptr, n}, point, values.data());
    for (std::int64_t j = 0; j < n; ++j) {
      long double s = 0;
      for (int d = 0; d < dim; ++d) s += std::pow(static_cast<long double>(point[d] - centers.at(d, j)), 2);
      const double exact = static_cast<double>(reference(kernel, std::sqrt(s)).value);
      EXPECT_NEAR(exact, values[static_cast<std::size_t>(j)],
                  4e-19 + 1e-15 * std::max(std::abs(exact), static_cast<double>(s)));
    }
  }
}

std::string name_of_case(const testing::TestParamInfo<KernelSumsTest::ParamType>& info) {
  return std::string(std::get<0>(info.param)) + "_" + std::string(name_of(std::get<1>(info.param))) + "_" +
         std::to_string(std::get<2>(info.param)) + "d";
}
INSTANTIATE_TEST_SUITE_P(Every, KernelSumsTest,
                         testing::Combine(testing::Values("portable", "avx2", "avx512"),
                                          testing::ValuesIn(all_kernels), testing::Values(2, 3, 4)),
                         name_of_case);

TEST(KernelSums, SomeLoopsAlwaysRun) {
  EXPECT_NE(kernel_sums_named("portable"), nullptr);
  EXPECT_EQ(kernel_sums_named("of another world"), nullptr);
  EXPECT_EQ(kernel_sums_named(kernel_sums().name), &kernel_sums());
}

}  // namespace
}  // namespace seesaw
