// bench_trace: the bunny of 800 boundary and 800 normal constraints as a ray-traced picture with shadows, its
// rays led by proven bounds and by the paper's 2,000 samples.
//
//   trace/bunny/<pixels>   seconds of a square picture, one ray a pixel and one shadow ray a hit, "rigorous"
//   (a fresh
//                          tracer: finding its boxes counts) and "heuristic"; for each, field evaluations a
//                          camera ray ("rigorous_evaluations", ...), and "bounds": how many boxes asked for a
//                          bound
// Without the bunny's file (Debian's glmark2-data) there are no benchmarks.
#include <filesystem>
#include <memory>

#include "bench/bunny.h"
#include "bench/turns.h"
#include "core/raytrace/evaluation_counts.h"
#include "core/raytrace/heuristic_tracer.h"
#include "core/raytrace/render.h"
#include "core/raytrace/rigorous_tracer.h"
#include "core/rbf/fit.h"

namespace seesaw::bench {
namespace {

std::shared_ptr<const Interpolant<3>> fitted_bunny() {
  return std::make_shared<Interpolant<3>>(fit(constraints_of_bunny(), {.condition = false}).function);
}

void trace_round(benchmark::State& state, int pixels) {
  static const std::shared_ptr<const Interpolant<3>> bunny = fitted_bunny();
  const RenderOptions options = {.width = pixels, .height = pixels, .samples = 1, .ambient_rays = 0};
  const auto heuristic = std::make_shared<HeuristicTracer>(bunny);
  auto rigorous = std::make_shared<RigorousTracer>(bunny);
  const auto scene_of = [](std::shared_ptr<const SurfaceTracer> tracer) {
    Scene scene;
    scene.solids.push_back(Solid(std::move(tracer)));
    return scene;
  };
  const PinholeCamera camera = frame(scene_of(heuristic));
  const double rays = static_cast<double>(pixels) * pixels;
  Turns turns(state);
  turns.take("heuristic", [&] { benchmark::DoNotOptimize(render(scene_of(heuristic), camera, options)); });
  turns.take("rigorous", [&] { benchmark::DoNotOptimize(render(scene_of(rigorous), camera, options)); });
  turns.note("bounds", static_cast<double>(rigorous->tree()->bounds()));
  const auto count = [&](std::shared_ptr<const SurfaceTracer> tracer) {
    return static_cast<double>(count_evaluations(scene_of(std::move(tracer)), camera, options).total()) /
           rays;
  };
  turns.note("heuristic_evaluations", count(heuristic));
  turns.note("rigorous_evaluations", count(rigorous));
}

}  // namespace
}  // namespace seesaw::bench

int main(int argc, char** argv) {
  using namespace seesaw;
  if (std::filesystem::exists(bench::bunny_file))
    for (const int pixels : {16, 512})
      bench::add_comparison("trace/bunny/" + std::to_string(pixels),
                            [pixels](benchmark::State& state) { bench::trace_round(state, pixels); });
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
