// bench_evaluate: kernel evaluations per second, of every instruction set that this processor has.
//
// Three comparisons, each benchmark one of them (bench/turns.h):
//   evaluate/<kernel>_<Dim>d   seconds *per kernel evaluation* of the loops of core/rbf/kernel_sums.h (values
//   and
//                              gradients), of a plain loop, of the hand-written ceilings, and of a whole
//                              Interpolant
//   error/<kernel>_<Dim>d      largest |sum - exact sum| / sum |w phi|, exact sums in long double
//   threads/<kernel>_<Dim>d    seconds of one evaluation of an Interpolant with 1, 2, 4, ... threads, and
//   "<n>_work",
//                              processor seconds of all threads together
#include <tbb/global_control.h>
#include <tbb/info.h>

#include <algorithm>
#include <array>
#include <vector>

#include "bench/ceiling.h"
#include "bench/data.h"
#include "bench/plain_loop.h"
#include "bench/turns.h"
#include "core/rbf/interpolant.h"

namespace seesaw::bench {
namespace {

constexpr const char* instruction_sets[] = {"portable", "avx2", "avx512"};

// Centers and points as the loops want them, one array a coordinate.
template <int Dim>
struct Problem {
  Eigen::Matrix<double, Eigen::Dynamic, Dim> center_columns, point_columns;
  Values weights;
  std::array<const double*, Dim> center_starts, point_starts;

  Problem(Index centers, Index points)
      : center_columns(spread_points<Dim>(centers).transpose()),
        point_columns(spread_points<Dim>(points, centers).transpose()),  // none of them on a center
        weights(mixed_weights(centers)) {
    for (int d = 0; d < Dim; ++d) {
      center_starts[static_cast<std::size_t>(d)] = center_columns.col(d).data();
      point_starts[static_cast<std::size_t>(d)] = point_columns.col(d).data();
    }
  }
  CenterArrays centers() const { return {center_starts.data(), weights.data(), center_columns.rows()}; }
  PointArrays points() const { return points(point_columns.rows()); }
  PointArrays points(Index first_of_them) const { return {point_starts.data(), first_of_them}; }
  double evaluations() const { return static_cast<double>(center_columns.rows() * point_columns.rows()); }
};

template <int Dim>
Interpolant<Dim> interpolant_of(const Problem<Dim>& problem, Kernel kernel) {
  const Solution solution{problem.weights, Values::Zero(Dim + 1)};
  return Interpolant<Dim>(kernel, problem.center_columns.transpose(), Normalization<Dim>(), solution);
}

template <int Dim>
void evaluate_round(benchmark::State& state, Kernel kernel) {
  constexpr Index count = 48 * ceiling_points;
  const Problem<Dim> problem(2000, count);
  const auto interpolant = interpolant_of(problem, kernel);
  const Points<Dim> points = problem.point_columns.transpose();
  Values values(count);
  Points<Dim> gradients(Dim, count);
  std::array<Values, Dim> gradient_columns;
  std::array<double*, Dim> gradient_starts;
  for (std::size_t d = 0; d < Dim; ++d) {
    gradient_columns[d].resize(count);
    gradient_starts[d] = gradient_columns[d].data();
  }

  Turns turns(state);
  const auto rate = [&](const std::string& name, const auto& work) {
    turns.note(name, turns.take(name, work) / problem.evaluations());
  };
  for (const char* set : instruction_sets) {
    const KernelSums* sums = kernel_sums_named(set);
    if (sums == nullptr) continue;
    const std::string name = set;
    rate(name + "_values",
         [&] { sums->values(kernel, Dim, problem.centers(), problem.points(), values.data()); });
    if (const CeilingLoop ceiling = ceiling_loop(set, kernel, Dim))
      rate(name + "_ceiling", [&] { ceiling(problem.centers(), problem.points(), values.data()); });
    rate(name + "_gradients", [&] {
      sums->gradients(kernel, Dim, problem.centers(), problem.points(), values.data(),
                      gradient_starts.data());
    });
  }
  rate("interpolant_values", [&] { interpolant.evaluate(points, values); });
  rate("interpolant_gradients", [&] { interpolant.evaluate(points, values, gradients); });
  // The slow one gets fewer points.
  constexpr Index few = count / 8;
  const double seconds = turns.take(
      "plain", [&] { plain_loop(kernel, Dim, problem.centers(), problem.points(few), values.data()); });
  turns.note("plain", seconds / problem.evaluations() * (count / few));
}

template <int Dim>
void error_round(benchmark::State& state, Kernel kernel) {
  constexpr Index count = ceiling_points, centers = 20000;
  const Problem<Dim> problem(centers, count);
  using Exact = long double;
  std::vector<Exact> exact(count, 0.0L), size(count, 0.0L);
  for (Index i = 0; i < count; ++i)
    for (Index j = 0; j < centers; ++j) {
      Exact s = 0.0L;
      for (int d = 0; d < Dim; ++d) {
        const Exact difference = Exact(problem.point_columns(i, d)) - Exact(problem.center_columns(j, d));
        s += difference * difference;
      }
      const Exact phi = kernel == Kernel::cubic    ? s * std::sqrt(s)
                        : kernel == Kernel::linear ? std::sqrt(s)
                                                   : s * std::log(s) / 2;
      const auto k = static_cast<std::size_t>(i);
      exact[k] += problem.weights[j] * phi;
      size[k] += std::abs(problem.weights[j] * phi);
    }

  Turns turns(state);
  Values values(count);
  const auto note_error = [&](const std::string& name) {
    Exact largest = 0.0L;
    for (Index i = 0; i < count; ++i) {
      const auto k = static_cast<std::size_t>(i);
      largest = std::max(largest, std::abs(values[i] - exact[k]) / size[k]);
    }
    turns.note(name, static_cast<double>(largest));
  };
  for (const char* set : instruction_sets) {
    const KernelSums* sums = kernel_sums_named(set);
    if (sums == nullptr) continue;
    sums->values(kernel, Dim, problem.centers(), problem.points(), values.data());
    note_error(set);
    if (const CeilingLoop ceiling = ceiling_loop(set, kernel, Dim)) {
      ceiling(problem.centers(), problem.points(), values.data());
      note_error(std::string(set) + "_ceiling");
    }
  }
  plain_loop(kernel, Dim, problem.centers(), problem.points(), values.data());
  note_error("plain");
}

template <int Dim>
void threads_round(benchmark::State& state, Kernel kernel) {
  const Problem<Dim> problem(2000, 32768);
  const auto interpolant = interpolant_of(problem, kernel);
  const Points<Dim> points = problem.point_columns.transpose();
  Values values(points.cols());
  interpolant.evaluate(points, values);  // the threads are started here

  Turns turns(state);
  const int most = tbb::info::default_concurrency();
  for (int threads = 1;; threads = std::min(2 * threads, most)) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    const double work = processor_seconds();
    turns.take(std::to_string(threads), [&] { interpolant.evaluate(points, values); });
    turns.note(std::to_string(threads) + "_work", processor_seconds() - work);
    if (threads == most) break;
  }
}

template <int Dim>
void add_kernel(Kernel kernel) {
  const std::string name = std::string(name_of(kernel)) + "_" + std::to_string(Dim) + "d";
  add_comparison("evaluate/" + name,
                 [kernel](benchmark::State& state) { evaluate_round<Dim>(state, kernel); });
  add_comparison("error/" + name, [kernel](benchmark::State& state) { error_round<Dim>(state, kernel); });
  add_comparison("threads/" + name, [kernel](benchmark::State& state) { threads_round<Dim>(state, kernel); });
}

}  // namespace
}  // namespace seesaw::bench

int main(int argc, char** argv) {
  using namespace seesaw;
  for (const Kernel kernel : all_kernels) {
    bench::add_kernel<2>(kernel);
    bench::add_kernel<3>(kernel);
  }
  benchmark::AddCustomContext("loops", kernel_sums().name);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
