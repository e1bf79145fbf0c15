// bench_extract: T&O 2002's Fig. 6 from constraints to triangles: the bunny of 800 boundary and 800 normal
// constraints, 100 cubes across (section 8.2 has the paper's own times: 103 s and 463 s).
//
// Two comparisons, each benchmark one of them (bench/turns.h):
//   extract/bunny   seconds of the fit, of the extraction and its steps, and "bare": as many values and as
//                   many gradients as the extraction asked for, in one batch each
//   threads/bunny   seconds of the extraction with 1, 2, 4, ... threads, and "<n>_work", processor seconds of
//                   all threads together
// Without the bunny's file (Debian's glmark2-data) there are no benchmarks.
#include <tbb/global_control.h>
#include <tbb/info.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "bench/bunny.h"
#include "bench/data.h"
#include "bench/turns.h"
#include "core/polygonize/polygonize.h"
#include "core/rbf/fit.h"
#include "core/rbf/kernel_sums.h"

namespace seesaw::bench {
namespace {

struct Bunny {
  Constraints<3> constraints = constraints_of_bunny();
  Points<3> seeds = boundary_points(constraints);
  Fit<3> fitted = fit(constraints);
};

const Bunny& bunny() {
  static const Bunny made;
  return made;
}

void extract_round(benchmark::State& state) {
  const Bunny& it = bunny();
  Turns turns(state);
  turns.take("fit", [&] { benchmark::DoNotOptimize(fit(it.constraints)); });
  Polygonization result;
  turns.take("extraction", [&] { result = polygonize(it.fitted.function, it.seeds); });
  const Points<3> values_at = spread_points<3>(result.evaluations - result.gradient_evaluations);
  const Points<3> gradients_at = spread_points<3>(result.gradient_evaluations);
  Values values(values_at.cols()), others(gradients_at.cols());
  Points<3> gradients(3, gradients_at.cols());
  turns.take("bare", [&] {
    it.fitted.function.evaluate(values_at, values);
    it.fitted.function.evaluate(gradients_at, others, gradients);
  });
  turns.note("lattice", result.times.lattice);
  turns.note("assemble", result.times.assemble);
  turns.note("seeds", result.times.seeds);
  turns.note("improve", result.times.improve);
  turns.note("polish", result.times.polish);
  turns.note("faces", static_cast<double>(result.mesh.faces.cols()));
  turns.note("smallest_angle", result.smallest_angle);
}

void threads_round(benchmark::State& state) {
  const Bunny& it = bunny();
  Turns turns(state);
  const int most = tbb::info::default_concurrency();
  for (int count = 1; count <= most; count = count < most ? std::min(2 * count, most) : most + 1) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(count));
    const std::string name = std::to_string(count);
    const double start = processor_seconds();
    turns.take(name, [&] { benchmark::DoNotOptimize(polygonize(it.fitted.function, it.seeds)); });
    turns.note(name + "_work", processor_seconds() - start);
  }
}

}  // namespace
}  // namespace seesaw::bench

int main(int argc, char** argv) {
  using namespace seesaw;
  if (std::filesystem::exists(bench::bunny_file)) {
    bench::add_comparison("extract/bunny", bench::extract_round);
    bench::add_comparison("threads/bunny", bench::threads_round);
  }
  benchmark::AddCustomContext("loops", kernel_sums().name);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
