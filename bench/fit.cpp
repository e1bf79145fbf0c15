// bench_fit: a fit beside the bare Cholesky of its size, and where the rest of its time goes.
//
// Benchmarks are named fit/<kernel>_<Dim>d/<N>; counters are seconds, but for the notes at the end of a
// round. bench/run.py runs this program, limits it to one core or gives it all, and knows what each counter
// is compared with.
#include <dlfcn.h>

#include "bench/bare_cholesky.h"
#include "bench/data.h"
#include "bench/turns.h"
#include "core/rbf/dense.h"
#include "core/rbf/fit.h"
#include "core/rbf/kernel_sums.h"

namespace seesaw::bench {
namespace {

// One round. Parts of the fit are measured by doing them again from outside, through the public headers.
template <int Dim>
void fit_round(benchmark::State& state, Kernel kernel, Index n) {
  static Eigen::MatrixXd definite, warm;  // from round to round: this memory must be warm
  if (definite.rows() != n) {
    definite = Eigen::MatrixXd(n, n);
    fill_definite(definite);
    warm = Eigen::MatrixXd(n, n);
  }
  const Points<Dim> points = spread_points<Dim>(n);
  const Values values = smooth_values<Dim>(points);
  FitOptions options;
  options.kernel = kernel;

  Turns turns(state);
  std::optional<Fit<Dim>> fitted;
  const auto fit_it = [&] { fitted.emplace(fit_values<Dim>(points, values, options)); };
  turns.take(
      "fit", [] { dense::matrix_memory(1 << 19); }, fit_it);  // in memory of its own: a first fit
  turns.take("fit_again", fit_it);
  turns.take(
      "cholesky_warm", [&] { copy_lower(definite, warm); }, [&] { bare_cholesky(warm); });
  turns.take("cholesky_fresh", [&] {
    Eigen::MatrixXd fresh(n, n);
    copy_lower(definite, fresh);
    bare_cholesky(fresh);
  });

  const auto normalization = Normalization<Dim>::of(points);
  const Points<Dim> centers = normalization.apply(points);
  std::optional<Factorization<Dim>> factorization;
  turns.take("factorization", [&] { factorization.emplace(centers, kernel, 0.0); });
  turns.take("condition", [&] { benchmark::DoNotOptimize(factorization->reciprocal_condition()); });
  turns.take("solve", [&] { benchmark::DoNotOptimize(factorization->solve(values)); });
  turns.take("residual", [&] { benchmark::DoNotOptimize(fitted->function.values(points)); });
  // The price of new memory alone: one number in every 4096 bytes.
  turns.take("pages", [&] {
    dense::Symmetric fresh(n);
    for (Index i = 0; i < fresh.stored(); i += 512) fresh.data()[i] = 0.0;
    benchmark::DoNotOptimize(fresh.data());
  });
  // The sums that the kernel matrix is made of, into memory that is warm.
  const Eigen::Matrix<double, Eigen::Dynamic, Dim> columns = centers.transpose();
  turns.take("kernel_matrix", [&] {
    for (Index j = 0; j < n; ++j) {
      const double* coordinates[Dim];
      for (int d = 0; d < Dim; ++d) coordinates[d] = columns.col(d).data() + j;
      kernel_sums().kernel_values(kernel, Dim, {coordinates, nullptr, n - j}, centers.col(j).data(),
                                  &warm(j, j));
    }
  });
  turns.note("max_residual", fitted->report.max_residual);
  turns.note("reciprocal_condition", fitted->report.reciprocal_condition);
}

// The first call of anything loads its pages and starts its threads.
void warm_up() {
  const Points<3> points = spread_points<3>(400);
  fit_values<3>(points, smooth_values<3>(points));
}

// OpenBLAS says which processor it took this one for; other libraries say nothing.
std::string blas() {
  using Words = char* (*)();
  std::string text = dense::name();
  for (const char* name : {"openblas_get_config", "openblas_get_corename"})
    if (const auto words = reinterpret_cast<Words>(dlsym(RTLD_DEFAULT, name)))
      text += std::string(", ") + words();
  return text;
}

}  // namespace
}  // namespace seesaw::bench

int main(int argc, char** argv) {
  using namespace seesaw;
  bench::allocate_afresh();
  for (const Index n : {200, 400, 1600, 3000, 6000}) {
    const std::string size = std::to_string(n);
    bench::add_comparison("fit/cubic_3d/" + size,
                          [n](benchmark::State& state) { bench::fit_round<3>(state, Kernel::cubic, n); });
    bench::add_comparison("fit/thin_plate_spline_2d/" + size, [n](benchmark::State& state) {
      bench::fit_round<2>(state, Kernel::thin_plate_spline, n);
    });
  }
  benchmark::AddCustomContext("blas", bench::blas());
  benchmark::AddCustomContext("loops", kernel_sums().name);
  benchmark::Initialize(&argc, argv);
  bench::warm_up();
  benchmark::RunSpecifiedBenchmarks();
}
