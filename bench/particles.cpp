// bench_particles: a step of floaters on an interpolating surface of 100 constraints (50 boundary, 50
// normal), against their number.
//
//   floaters/<about how many>   seconds of one whole "step", of its "repulsion" alone, of the same
//   "all_pairs"
//                               the paper's O(r^2) way (two threads or as many as there are, as ours), and of
//                               the "field": one evaluation a floater with gradients; "floaters": how many
//                               there are
//   drag/150                    the paper's interactive case: 150 floaters on blobby spheres that are dragged
#include <cmath>
#include <map>
#include <memory>
#include <string>

#include "bench/turns.h"
#include "core/implicit/blobby.h"
#include "core/particles/floaters.h"
#include "core/rbf/fit.h"

namespace seesaw::bench {
namespace {

// A wavy ball through 50 points.
const Interpolant<3>& surface() {
  static const Interpolant<3> made = [] {
    Constraints<3> constraints;
    for (int i = 0; i < 50; ++i) {
      const double z = 1 - (2 * i + 1) / 50.0, angle = 2.399963229728653 * i, rho = std::sqrt(1 - z * z);
      const Point<3> out(rho * std::cos(angle), rho * std::sin(angle), z);
      constraints.push_back(boundary<3>((1 + 0.1 * std::sin(7 * i)) * out, out, 0.02));
    }
    return fit(constraints, {.condition = false}).function;
  }();
  return made;
}

// About `count` floaters, nearly at rest. Made once.
const Floaters& population(Index count) {
  static std::map<Index, Floaters> made;
  const auto found = made.find(count);
  if (found != made.end()) return found->second;
  // On this ball, which is half of its box, 0.26 / radius^2 settle.
  const double radius = std::sqrt(0.26 / static_cast<double>(count));
  Floaters floaters(surface(), {.desired_radius = radius});
  floaters.equilibrate(surface(), 150);
  return made.emplace(count, std::move(floaters)).first->second;
}

void floaters_round(benchmark::State& state, Index count) {
  Floaters floaters = population(count);
  const Interpolant<3>& field = surface();
  const int steps = static_cast<int>(std::max<Index>(3, 3000 / count));
  Turns turns(state);
  const auto each = [&](const std::string& name, int times, const auto& work) {
    const double start = seconds_now();
    for (int k = 0; k < times; ++k) work();
    turns.note(name, (seconds_now() - start) / times);
  };
  each("step", steps, [&] { floaters.step(field); });
  each("repulsion", steps, [&] { benchmark::DoNotOptimize(repulsion(floaters.crowd())); });
  each("all_pairs", count > 5000 ? 1 : steps,
       [&] { benchmark::DoNotOptimize(repulsion_of_all_pairs(floaters.crowd())); });
  each("field", steps, [&] { benchmark::DoNotOptimize(touch(field, floaters.positions())); });
  turns.note("floaters", static_cast<double>(floaters.size()));
}

void drag_round(benchmark::State& state) {
  const auto blobs = [](double apart) {
    const double s = BlobbySpheres<3>::deviation_for(1, 0.3);
    return BlobbySpheres<3>(0.3, Points<3>{{-0.5 * apart, 0.5 * apart}, {0, 0}, {0, 0}}, Values{{s, s}});
  };
  static const Floaters start = [&] {
    Floaters floaters(blobs(1.5), {.desired_radius = 0.0545});
    floaters.equilibrate(blobs(1.5));
    return floaters;
  }();
  Floaters floaters = start;
  Turns turns(state);
  const int steps = 20;
  const double begin = seconds_now();
  for (int k = 0; k < steps; ++k) {
    const double apart = 1.5 + 0.01 * k, dt = floaters.options().time_step;
    const Values rates =
        (blobs(apart + 0.01).values(floaters.positions()) - blobs(apart).values(floaters.positions())) / dt;
    floaters.choose_velocities(blobs(apart), rates);
    floaters.move(blobs(apart + 0.01));
  }
  turns.note("step", (seconds_now() - begin) / steps);
  turns.note("floaters", static_cast<double>(floaters.size()));
}

}  // namespace
}  // namespace seesaw::bench

int main(int argc, char** argv) {
  using namespace seesaw;
  for (const Index count : {100, 300, 1000, 3000, 5000, 10000, 20000})
    bench::add_comparison("floaters/" + std::to_string(count),
                          [count](benchmark::State& state) { bench::floaters_round(state, count); });
  bench::add_comparison("drag/150", bench::drag_round);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
