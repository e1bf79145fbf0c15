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

#include "bench/turns.h"
#include "core/mesh/mesh_file.h"
#include "core/mesh/simplify.h"
#include "core/mesh/vertex_normals.h"
#include "core/raytrace/evaluation_counts.h"
#include "core/raytrace/heuristic_tracer.h"
#include "core/raytrace/render.h"
#include "core/raytrace/rigorous_tracer.h"
#include "core/rbf/fit.h"

namespace seesaw::bench {
namespace {

constexpr const char* bunny_file = "/usr/share/glmark2/models/bunny.obj";

// The paper's conversion: the model in the unit cube, each normal constraint 0.01 inside.
std::shared_ptr<const Interpolant<3>> fitted_bunny() {
  TriangleMesh model = simplify(read_mesh(bunny_file).mesh, 800);
  const Box<3> box = bounding_box_of<3>(model.vertices);
  model.vertices = (model.vertices.colwise() - box.min()) / box.sizes().maxCoeff();
  const Points<3> normals = vertex_normals(model);
  Constraints<3> constraints;
  for (Index v = 0; v < model.vertices.cols(); ++v)
    constraints.push_back(boundary<3>(model.vertices.col(v), normals.col(v), 0.01));
  return std::make_shared<Interpolant<3>>(fit(constraints, {.condition = false}).function);
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
