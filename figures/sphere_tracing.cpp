// T&O 2002, section 7.2: sphere tracing by the steepest of 2,000 samples, as the paper has it, beside sphere
// tracing by proven bounds. What each costs, and what the samples miss.
#include <algorithm>

#include "core/base/parallel.h"
#include "core/implicit/boxed.h"
#include "core/raytrace/evaluation_counts.h"
#include "core/raytrace/heuristic_tracer.h"
#include "core/raytrace/rigorous_tracer.h"
#include "figures/studio.h"
#include "figures/surface.h"

namespace seesaw {

namespace {

using TracerPointer = std::shared_ptr<const SurfaceTracer>;

// One tracer of each kind for each field.
std::vector<TracerPointer> tracers_of(const std::vector<FieldPointer<3>>& fields, bool rigorous) {
  std::vector<TracerPointer> tracers;
  for (const FieldPointer<3>& field : fields)
    if (rigorous)
      tracers.push_back(std::make_shared<RigorousTracer>(field));
    else
      tracers.push_back(std::make_shared<HeuristicTracer>(field));
  return tracers;
}

Scene scene_of(const std::vector<TracerPointer>& tracers) {
  Scene scene;
  for (std::size_t i = 0; i < tracers.size(); ++i)
    scene.solids.push_back(Solid(tracers[i], Material{.color = surface::of_object(static_cast<int>(i))}));
  return scene;
}

// The solid's function in a box close around its surface; nothing else of it lies in its own box.
FieldPointer<3> boxed(const Fit<3>& fitted) {
  const auto function = std::make_shared<const Interpolant<3>>(fitted.function);
  const TriangleMesh mesh = polygonize(*function, Points<3>(3, 0), {.cells = 80, .exhaustive = true}).mesh;
  return share(Boxed<3>(function, grown(bounding_box_of<3>(mesh.vertices), 0.02)));
}

struct Hits {
  std::vector<bool> hit;  // n rows of n rays
  double unproven = 0;    // no two crossings farther apart than this were passed over
};
Hits hits(const Scene& scene, const PinholeCamera& camera, int n) {
  std::vector<Ray> rays;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) rays.push_back(ray_through(camera, (x + 0.5) / n, (y + 0.5) / n, 1));
  std::vector<SolidCrossings> found(rays.size());
  parallel_blocks(n, 1, [&](Index begin, Index end) {  // rows
    const auto first = static_cast<std::size_t>(begin * n),
               count = static_cast<std::size_t>((end - begin) * n);
    scene.solids[0].trace(std::span(rays).subspan(first, count), HowMany::first,
                          std::span(found).subspan(first, count));
  });
  Hits result{std::vector<bool>(rays.size())};
  for (std::size_t i = 0; i < rays.size(); ++i) {
    result.hit[i] = !found[i].crossings.empty();
    result.unproven = std::max(result.unproven, found[i].unproven);
  }
  return result;
}

}  // namespace

Figure sphere_tracing(const FigureContext& context) {
  Figure figure{
      .id = "sphere-tracing",
      .paper = "Companion to Turk & O\u2019Brien 2002, section 7.2",
      .title = "Sphere tracing, by samples and by proof",
      .shows =
          "We sample the space in and around our implicit surface at 2000 positions, and we use the "
          "maximum gradient magnitude over all of these locations as the Lipschitz constant for sphere "
          "tracing. For extremely pathological surfaces, this heuristic may fail."};
  constexpr double size = 300;
  const int pixels = static_cast<int>(size);

  // What it costs: evaluations of the functions for each pixel's camera ray.
  Constraints<3> bone = constraints_of(scene_named(context, "turk2002-fig10-bone"));
  for (Constraint<3>& each : bone) each.at += Point<3>(1.9, 0.1, -0.45);
  const std::vector<FieldPointer<3>> fields = {
      boxed(fit(constraints_of(scene_named(context, "turk2002-fig10-cushion")))), boxed(fit(bone))};
  std::optional<PinholeCamera> camera;
  EvaluationCounts counts[2];
  for (int way = 0; way < 2; ++way) {
    const Scene scene = scene_of(tracers_of(fields, way == 0));
    if (!camera) camera = frame(scene, {.direction = {0.25, 0.5, 1}});
    counts[way] = count_evaluations(scene, *camera, {.width = pixels, .height = pixels}, context.progress);
  }
  const Index darkest = 150;
  const char* const names[] = {"bounds", "samples"};
  const char* const titles[] = {"evaluations, by proven bounds", "evaluations, by 2,000 samples"};
  for (int way = 0; way < 2; ++way) {
    Panel panel = image_panel(names[way], titles[way], heat_image(counts[way], darkest), size, size);
    panel.facts["evaluations_per_ray"] =
        static_cast<double>(counts[way].total()) / static_cast<double>(counts[way].counts.size());
    panel.facts["most_evaluations_of_a_ray"] = counts[way].largest();
    panel.facts["darkest_at"] = darkest;
    figure.panels.push_back(std::move(panel));
  }

  // What samples can miss: a blade that is steep only where hardly any sample falls.
  const Document<3> document = scene_named(context, "sphere-tracing-blade");
  const Fit<3> fitted = fit(constraints_of(document), {.kernel = document.kernel});
  const FieldPointer<3> blade = borrow<3>(fitted.function);
  const Box<3> near = bounding_box_of<3>(boundary_points(document));
  const Scene by_bounds = scene_of(tracers_of({blade}, true));
  const Scene by_samples = scene_of(tracers_of({blade}, false));
  const PinholeCamera close = frame(near, {.direction = {0.5, -0.35, 0.8}, .margin = 0.15});
  RenderOptions options{.width = pixels, .height = pixels, .samples = 1, .ambient_rays = 0};
  Image picture = render(by_bounds, close, options, context.progress);
  // Nine rays a pixel: those that slip through are few.
  constexpr int fine = 3;
  const int rays = fine * pixels;
  const Hits proof = hits(by_bounds, close, rays);
  const std::vector<bool>& truth = proof.hit;
  const std::vector<bool> sampled = hits(by_samples, close, rays).hit;
  const double unproven = proof.unproven / blade->bounding_box().sizes().norm();
  Index seen = 0, missed = 0, invented = 0;
  for (int y = 0; y < rays; ++y)
    for (int x = 0; x < rays; ++x) {
      const auto i = static_cast<std::size_t>(y * rays + x);
      seen += truth[i];
      invented += sampled[i] && !truth[i];
      if (!truth[i] || sampled[i]) continue;
      ++missed;
      // One pixel is easily overlooked.
      for (int v = std::max(0, y / fine - 2); v <= std::min(pixels - 1, y / fine + 2); ++v)
        for (int u = std::max(0, x / fine - 2); u <= std::min(pixels - 1, x / fine + 2); ++u)
          picture.set(u, v, theme::moved);
    }
  Panel panel = image_panel("missed", "a blade; red marks: missed by samples", picture, size, size);
  panel.facts.update(fit_facts(fitted.report));
  panel.facts["rays_that_meet_the_blade"] = seen;
  panel.facts["of_them_missed_by_samples"] = missed;
  panel.facts["longest_unproven_chord"] = unproven;
  panel.facts["camera"] = to_flags(close);
  figure.panels.push_back(std::move(panel));

  figure.checks.push_back(residual_check("blade", fitted.report));
  figure.checks.push_back(at_least("blade: rays that meet it by proof", static_cast<double>(seen), 1000));
  figure.checks.push_back(at_least("blade: of them, missed by samples", static_cast<double>(missed), 1));
  figure.checks.push_back(
      equal("blade: rays that meet it by samples and not by proof", static_cast<double>(invented), 0));
  figure.checks.push_back(at_most("blade: longest chord that a ray may have passed over, of the diagonal",
                                  unproven, 1.000001 * RigorousOptions().resolution));
  const auto per_ray = [&](std::size_t i) {
    return figure.panels[i].facts["evaluations_per_ray"].get<double>();
  };
  figure.caption =
      "Dark is " + std::to_string(darkest) +
      " evaluations of a function and more. (a) Bounds that are proven in boxes that shrink along the ray "
      "need " +
      in_words(per_ray(0), 2) + " evaluations a ray, (b) one bound from 2,000 samples " +
      in_words(per_ray(1), 2) +
      ". (c) A blade of cones within a wide cage is steep only right beside itself, where hardly a sample "
      "falls: of " +
      std::to_string(seen) + " rays that meet it by proven bounds, samples let " + std::to_string(missed) +
      " through without a word; " + std::to_string(invented) +
      " meet it by samples alone. The framing was chosen to show it: with a little more room around the "
      "blade no ray slipped through.";
  return figure;
}

}  // namespace seesaw
