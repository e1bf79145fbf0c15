// bench_memory: the peak of memory that one fit, or one bare Cholesky, adds to its process.
//
//     bench_memory cubic_3d | thin_plate_spline_2d | cholesky   N        prints bytes
//
// One measurement, one process: a peak is never forgotten. Linux's VmHWM is the process's own; getrusage's
// ru_maxrss is not, it starts from the peak of the program that started this one.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>

#include "bench/bare_cholesky.h"
#include "bench/data.h"
#include "core/rbf/fit.h"

namespace seesaw::bench {
namespace {

// A line of /proc/self/status, in bytes.
long status_bytes(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind(key + ":", 0) == 0) return std::atol(line.c_str() + key.size() + 1) * 1024;
  std::fprintf(stderr, "bench_memory: /proc/self/status has no %s\n", key.c_str());
  std::exit(2);
}

template <int Dim>
void fit_once(Kernel kernel, Index n) {
  FitOptions options;
  options.kernel = kernel;
  const Points<Dim> points = spread_points<Dim>(n);
  const auto fitted = fit_values<Dim>(points, smooth_values<Dim>(points), options);
  if (!(fitted.report.max_residual < 1e-6))
    std::fprintf(stderr, "bench_memory: the fit failed\n"), std::exit(1);
}

}  // namespace
}  // namespace seesaw::bench

int main(int argc, char** argv) {
  using namespace seesaw;
  const std::string what = argc > 1 ? argv[1] : "";
  const Index n = argc > 2 ? std::atol(argv[2]) : 0;
  if (n < 1) return std::fprintf(stderr, "usage: bench_memory cubic_3d|thin_plate_spline_2d|cholesky N\n"), 2;
  const long before = bench::status_bytes("VmRSS");
  if (what == "cubic_3d") {
    bench::fit_once<3>(Kernel::cubic, n);
  } else if (what == "thin_plate_spline_2d") {
    bench::fit_once<2>(Kernel::thin_plate_spline, n);
  } else if (what == "cholesky") {
    Eigen::MatrixXd matrix(n, n);
    bench::fill_definite(matrix);
    bench::bare_cholesky(matrix);
  } else {
    return std::fprintf(stderr, "bench_memory: unknown: %s\n", what.c_str()), 2;
  }
  std::printf("%ld\n", bench::status_bytes("VmHWM") - before);
}
