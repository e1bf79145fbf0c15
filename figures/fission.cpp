// W&H 1994, sections 4.1 to 4.4: how three kinds of repulsion spread over a torus from one place.
#include <cmath>

#include "core/image/chart.h"
#include "core/implicit/torus.h"
#include "core/polygonize/polygonize.h"
#include "figures/facts.h"
#include "figures/floater_scene.h"
#include "figures/studio.h"

namespace seesaw {

namespace {

struct Run {
  const char* name;
  const char* title;
  Floaters floaters;
  Series count, variation;
  double steps_to_even = 0;  // the first of all that follow with a spread below the bound; 0: never
};

constexpr double even = 0.1;

}  // namespace

Figure fission_figure(const FigureContext& context) {
  Figure figure{
      .id = "fission",
      .paper = "Witkin & Heckbert 1994, sections 4.1 to 4.4",
      .title = "From one place: repulsion, global fissioning, adaptive repulsion",
      .shows =
          "Simple repulsion is extremely slow to converge if the initial sampling is irregular at large "
          "scale. Fissioning gets to equilibrium in just a few iterations a generation, but the population "
          "is always a power of two. With adaptive repulsion, fission and death good sampling is reached "
          "very rapidly from a single seed."};
  const Torus torus({0, 0, 0}, {0.25, 1, 0.15}, 1.0, 0.42);
  const TriangleMesh mesh = polygonize(torus, Points<3>(3, 0), {.cells = 60, .exhaustive = true}).mesh;
  const Point<3> seed = mesh.vertices.col(0);
  const FloaterOptions options{.desired_radius = 0.032, .seed = 5};

  // Simple repulsion bears nobody: it gets as many as adaptive repulsion ends with, all around the seed.
  Floaters adaptive(torus, seed, options);
  adaptive.equilibrate(torus);
  const Index number = adaptive.size();
  const double radius = adaptive.radii().mean();
  Points<3> crowd(3, number);
  Random random(3);
  const Point<3> inward = torus.gradient(seed).normalized();
  for (Index i = 0; i < number; ++i) {
    const Point<3> direction = random.direction<3>();
    Point<3> at =
        seed + 0.35 * std::sqrt(random.uniform(0, 1)) * (direction - direction.dot(inward) * inward);
    for (int newton = 0; newton < 4; ++newton) {
      const Point<3> gradient = torus.gradient(at);
      at -= torus.value(at) / gradient.squaredNorm() * gradient;
    }
    crowd.col(i) = at;
  }
  FloaterOptions simple = options, global = options, dense = options;
  dense.desired_radius = 0.05 * options.desired_radius;  // seeds this near to each other are all kept
  simple.repulsion = Repulsion::simple;
  simple.simple_radius = radius / adaptive.diameter();
  global.repulsion = Repulsion::global_fissioning;
  std::vector<Run> runs = {{"simple", "simple repulsion", Floaters(torus, crowd, dense), {}, {}},
                           {"global", "global fissioning", Floaters(torus, seed, global), {}, {}},
                           {"adaptive", "adaptive repulsion", Floaters(torus, seed, options), {}, {}}};
  runs[0].floaters.set_options(simple);
  constexpr int steps = 600;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    Run& run = runs[k];
    for (int step = 1; step <= steps; ++step) {
      report(context.progress, (static_cast<double>(k) + step / double{steps}) / 3);
      run.floaters.step(torus);
      const Spacing spacing = spacing_of(run.floaters.positions());
      run.count.x.push_back(step);
      run.count.y.push_back(static_cast<double>(run.floaters.size()));
      if (run.floaters.size() < 8) continue;
      run.variation.x.push_back(step);
      run.variation.y.push_back(spacing.variation);
      if (spacing.variation >= even)
        run.steps_to_even = 0;
      else if (run.steps_to_even == 0)
        run.steps_to_even = step;
    }
  }

  std::optional<PinholeCamera> camera;
  for (Run& run : runs) {
    Scene scene;
    if (!camera) {
      Scene whole;
      whole.meshes.push_back(smooth_surface(mesh, surface::blue));
      camera = frame(whole, {.direction = {0.3, 0.8, 1}, .aspect = 1.25});
    }
    scene.discs.push_back(facing(floater_discs(run.floaters), camera->eye));
    figure.panels.push_back(
        studio_panel(context, run.name, run.title, scene, {.camera = *camera, .width = 300, .height = 240}));
    Facts& facts = figure.panels.back().facts;
    add_floater_facts(facts, run.floaters, torus, mesh.vertices);
    facts["steps"] = steps;
    facts["steps_to_variation_below_0.1"] = run.steps_to_even;
  }

  Chart population, uniformity;
  population.x = uniformity.x = {.label = "steps", .logarithmic = true};
  population.y = {.label = "floaters", .logarithmic = true};
  uniformity.y = {.label = "variation of the distance to the nearest", .low = 0.0};
  uniformity.horizontal = {{.value = even, .label = {}}};
  for (Run& run : runs) {
    run.count.name = run.variation.name = run.title;
    population.series.push_back(run.count);
    uniformity.series.push_back(run.variation);
  }
  uniformity.legend = Legend::none;
  for (const auto& [name, title, chart] : {std::tuple{"population", "how many", population},
                                           std::tuple{"uniformity", "how uneven", uniformity}}) {
    Panel panel{.name = name, .title = title, .width = 300, .height = 240};
    for (const Run& run : runs) {
      const Series& shown = std::string(name) == "population" ? run.count : run.variation;
      panel.facts[run.name] = {{"after_60_steps", *std::prev(shown.y.end(), steps - 60 + 1)},
                               {"at_the_end", shown.y.back()}};
    }
    panel.draw = [chart = chart](Canvas& canvas, const Rect& region) { draw_chart(canvas, region, chart); };
    figure.panels.push_back(std::move(panel));
  }
  figure.columns = 3;

  const auto spread = [&](std::size_t k) { return spacing_of(runs[k].floaters.positions()).variation; };
  const auto gap = [&](std::size_t k) {
    return largest_gap(runs[k].floaters.positions(), mesh.vertices) / radius;
  };
  figure.checks.push_back(at_most("adaptive: variation of neighbor distances", spread(2), 0.05));
  figure.checks.push_back(at_most("adaptive: largest gap, mean radii", gap(2), 3));
  figure.checks.push_back(at_most("global: largest gap, mean radii of the adaptive ones", gap(1), 4));
  figure.checks.push_back(at_least("simple: largest gap, mean radii", gap(0), 6));
  const double exponent = std::log2(static_cast<double>(runs[1].floaters.size()));
  figure.checks.push_back(at_most("global: the number\u2019s distance from a power of two, in the exponent",
                                  std::abs(exponent - std::round(exponent)), 1e-12));
  figure.checks.push_back(at_most("adaptive: steps to a variation below 0.1", runs[2].steps_to_even, 400));
  figure.checks.push_back(at_least("adaptive: it gets there", runs[2].steps_to_even, 1));
  figure.caption = "After " + std::to_string(steps) + " steps. Simple repulsion began with all its " +
                   std::to_string(runs[0].floaters.size()) +
                   " floaters around one place, the others with one floater. Adaptive "
                   "repulsion reaches a variation of " +
                   in_words(spread(2), 2) + ", global fissioning " + in_words(spread(1), 2) + " (with " +
                   std::to_string(runs[1].floaters.size()) +
                   " floaters); simple repulsion still leaves a hole of " + in_words(gap(0), 2) + " radii.";
  return figure;
}

}  // namespace seesaw
