// bench_edit: a step of a drag beside a full fit of the same constraints.
//
//   edit/<kernel>_<Dim>d/<N>   N rows (bench/wavy.h). Seconds, each from constraints to a function:
//     fit      of a full fit
//     row      of a step of a drag of one interior constraint (not the drag's first), bordered
//     pair     of a boundary constraint and its normal
//     value    of one more change of a value
//     twenty   of 20 interior constraints together
//     solve    of the one solve with the old matrix in a `row`
//   and two notes, relative to the largest value: "difference" of the functions, of the last step of `row`
//   and of its full fit, and the full fit's "residual".
#include <cmath>
#include <map>
#include <memory>
#include <string>

#include "bench/data.h"
#include "bench/turns.h"
#include "bench/wavy.h"
#include "core/rbf/edit_session.h"

namespace seesaw::bench {
namespace {

// The session of a program that has been open for a while: what is dragged has been dragged before. Made
// once.
template <int Dim>
struct Opened {
  Constraints<Dim> constraints;
  EditSession<Dim> session;

  Opened(Kernel kernel, Index n) : constraints(wavy<Dim>(n)), session(constraints, {.kernel = kernel}) {}
};

template <int Dim>
void edit_round(benchmark::State& state, Kernel kernel, Index n) {
  static std::map<std::pair<Kernel, Index>, Opened<Dim>> opened;
  auto& [constraints, session] = opened.try_emplace(std::pair(kernel, n), kernel, n).first->second;
  Turns turns(state);
  double turn = 0;
  // Seconds of one of `steps` steps, of which the first is not counted: it takes rows out.
  const auto steps = [&](const std::string& name, const auto& edit) {
    constexpr int count = 6;
    double start = 0;
    for (int k = 0; k <= count; ++k) {
      if (k == 1) start = seconds_now();
      turn += 0.7;
      edit();
      session.update(constraints);
      if (session.last().full != EditReport::Full::no)
        state.SkipWithError(std::string(name_of(session.last().full)).c_str());
    }
    turns.note(name, (seconds_now() - start) / count);
  };
  const auto shifted = [&](Index i) {
    Point<Dim> shift = Point<Dim>::Zero();
    shift[0] = 1e-3 * std::cos(turn + static_cast<double>(i));
    shift[1] = 1e-3 * std::sin(turn + static_cast<double>(i));
    constraints[slot(i)].at += shift;
  };
  steps("twenty", [&] {
    for (Index i = 0; i < (n < 500 ? 3 : 20); ++i) shifted(i);
  });
  session.adopt(EditSession<Dim>(constraints, {.kernel = kernel}));
  steps("pair", [&] { shifted(inside + 3); });
  steps("value", [&] { constraints[5].value = 1 + 0.1 * std::sin(turn); });
  steps("row", [&] { shifted(30); });

  turns.take("fit", [&] { benchmark::DoNotOptimize(fit(constraints, {.kernel = kernel})); });
  const auto full = full_fit(constraints, {.kernel = kernel});
  const Eigen::MatrixXd right_side = Eigen::MatrixXd::Ones(n + Dim + 1, 1);
  turns.take("solve", [&] { benchmark::DoNotOptimize(full.factorization.solve_all(right_side)); });

  const Points<Dim> x = 1.2 * spread_points<Dim>(500);
  const Values expected = full.fit.function.values(x);
  const double largest = expected.cwiseAbs().maxCoeff();
  turns.note("difference", (session.fit().function.values(x) - expected).cwiseAbs().maxCoeff() / largest);
  turns.note("residual", full.fit.report.max_residual / largest);
}

}  // namespace
}  // namespace seesaw::bench

int main(int argc, char** argv) {
  using namespace seesaw;
  bench::allocate_afresh();
  for (const Index n : {100, 1000, 3000}) {
    const std::string size = std::to_string(n);
    bench::add_comparison("edit/cubic_3d/" + size,
                          [n](benchmark::State& state) { bench::edit_round<3>(state, Kernel::cubic, n); });
    bench::add_comparison("edit/thin_plate_spline_2d/" + size, [n](benchmark::State& state) {
      bench::edit_round<2>(state, Kernel::thin_plate_spline, n);
    });
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
