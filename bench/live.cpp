// bench_live: what editing a large document costs the thread that a window waits for.
//
//   live/<N>    N rows in 2D (bench/wavy.h), edited every 16 ms for three seconds in each of these ways:
//     one       a boundary constraint and its normal are dragged
//     each      another constraint is moved every time, so that fresh fits are due all the while
//     sixty     sixty of them are dragged together
//     kernel    the kernel is another every half second, while one is dragged
//   Counters "<way>_longest": seconds that the longest of these steps took (poll, edit, ask for the shape);
//   "<way>_answers": how many times a second there was another function to show; "quit": seconds to let go of
//   a solver in the middle of a full fit.
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <thread>

#include "bench/turns.h"
#include "bench/wavy.h"
#include "core/editing/background_solver.h"
#include "core/editing/editor.h"

namespace seesaw::bench {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

Document<2> document_of_rows(Index rows) {
  Document<2> document;
  for (const Constraint<2>& each : wavy<2>(rows)) document.constraints.push_back({.constraint = each});
  return document;
}

void live_round(benchmark::State& state, Index n) {
  Turns turns(state);
  BackgroundSolver<2> solver;
  std::optional<Editor<2>> editor(std::in_place, document_of_rows(n), EditorOptions<2>{.solver = solver});
  const auto settle = [&] {
    while (solver.wait()) editor->solve_again();
    editor->shape();
  };
  const auto edited = [&](const std::string& way, const std::function<void(int)>& edit) {
    constexpr int frames = 180;
    settle();
    double longest = 0;
    int answers = 0;
    auto shown = editor->shape().function;
    const auto begin = Clock::now();
    editor->begin_gesture();
    for (int k = 0; k < frames; ++k) {
      std::this_thread::sleep_until(begin + k * std::chrono::milliseconds(16));
      const auto start = Clock::now();
      if (solver.poll()) editor->solve_again();
      edit(k);
      answers += editor->shape().function != shown;
      shown = editor->shape().function;
      longest = std::max(longest, seconds_since(start));
    }
    turns.note(way + "_answers", answers / seconds_since(begin));
    editor->end_gesture();
    turns.note(way + "_longest", longest);
  };
  const auto moved = [&](std::vector<Index> which, int k) {
    editor->apply(Move<2>{std::move(which), {1e-4 * std::cos(0.7 * k), 1e-4 * std::sin(0.7 * k)}});
  };
  edited("one", [&](int k) { moved({inside + 3}, k); });
  edited("each", [&](int k) { moved({inside + 5 * k % 470}, k); });
  std::vector<Index> sixty;
  for (Index i = 0; i < 60; ++i) sixty.push_back(inside + 7 * i);
  edited("sixty", [&](int k) { moved(sixty, k); });
  edited("kernel", [&](int k) {
    if (k % 30 == 10) editor->apply(SetKernel{k % 60 == 10 ? Kernel::cubic : Kernel::thin_plate_spline});
    moved({inside + 3}, k);
  });

  settle();
  editor->apply(SetKernel{Kernel::linear});
  editor->shape();
  while (solver.busy() && solver.fraction() == 0.0) std::this_thread::yield();
  turns.take("quit", [&] {
    editor.reset();
    solver = BackgroundSolver<2>();
  });
}

}  // namespace
}  // namespace seesaw::bench

int main(int argc, char** argv) {
  using namespace seesaw;
  for (const Index n : {1000, 3000, 5000})
    bench::add_comparison("live/" + std::to_string(n),
                          [n](benchmark::State& state) { bench::live_round(state, n); });
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
