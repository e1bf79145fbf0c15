// T&O 2002, abstract: implicit surfaces make it easy to find where two solids interfere. Two interpolating
// solids are moved together.
#include "core/modelling/interference.h"

#include <algorithm>

#include "core/image/chart.h"
#include "core/implicit/booleans.h"
#include "core/modelling/clearance.h"
#include "core/modelling/model_constraints.h"
#include "core/modelling/polygonal_torus.h"
#include "core/raytrace/rigorous_tracer.h"
#include "figures/studio.h"
#include "figures/surface.h"

namespace seesaw {

namespace {

// Interpolation is invariant under motion: moved constraints give the moved solid.
Constraints<3> moved(Constraints<3> constraints, const Point<3>& by) {
  for (Constraint<3>& each : constraints) each.at += by;
  return constraints;
}

// To be traced; `function` must live longer.
Solid solid_of(const Interpolant<3>& function, const Color& color) {
  return Solid(std::make_shared<RigorousTracer>(borrow<3>(function)), Material{.color = color});
}

}  // namespace

Figure interference_figure(const FigureContext& context) {
  Figure figure{
      .id = "interference",
      .paper = "Companion to Turk & O\u2019Brien 2002, abstract and section 1",
      .title = "Two interpolating solids, moved together",
      .shows =
          "Implicit surfaces simplify interference detection: a point lies in both solids when both "
          "functions are positive there. Bounds on the functions prove how large the common volume is, "
          "and that there is none."};
  const Constraints<3> bone = constraints_of(scene_named(context, "kernels-3d"));
  const TriangleMesh torus =
      polygonal_torus({.axis = Point<3>(0.35, 0, 1), .major = 1.05, .minor = 0.36}, 18, 10);
  const SurfacePointer ring = fit_surface(constraints_from(torus).constraints, {.cells = 60});
  const Point<3> way(-1, 0.25, 0.2);  // the bone moves along it

  const double places[] = {3.1, 2.2, 0.9};
  const char* const names[] = {"apart", "together", "through"};
  const char* const titles[] = {"apart", "together", "through the hole"};
  const Framing framing{.direction = {0.45, 0.5, 1}, .aspect = 300.0 / 240};
  const Solid ring_solid = solid_of(ring->function(), surface::marker);
  std::optional<PinholeCamera> camera;
  for (int i = 0; i < 3; ++i) {
    const std::string name = names[i];
    const SurfacePointer other = fit_surface(moved(bone, places[i] * way), {.cells = 60});
    const Interference found = interference(ring->function(), other->function(), {.width = 0.05});
    Scene scene;
    scene.meshes.push_back(smooth_surface(ring->polygons.mesh, surface::blue));
    scene.meshes.push_back(smooth_surface(other->polygons.mesh, surface::sand));
    if (!camera) camera = frame(scene, framing);
    scene.floor = floor_under(bounding_box(scene), Point<3>::UnitY());
    const Shot shot{.camera = *camera, .width = 300, .height = 240};
    figure.panels.push_back(studio_panel(context, name, titles[i], scene, shot));
    Facts& facts = figure.panels.back().facts;
    facts["moved_by"] = places[i];
    facts["overlap"] = found.overlap;
    facts["overlap_volume"] = found.volume;
    facts["overlap_volume_at_least"] = found.low;
    facts["overlap_volume_at_most"] = found.high;
    figure.checks.push_back(equal(name + ": the answer is proven", found.certain ? 1 : 0, 1));
    figure.checks.push_back(equal(name + ": they overlap", found.overlap ? 1 : 0, i == 0 ? 0 : 1));
    if (i == 0) {
      const Clearance gap = clearance(ring->function(), other->function());
      facts["clearance"] = gap.distance;
      facts["clearance_at_least"] = gap.low;
      figure.checks.push_back(at_least("apart: proven clearance", gap.low, 1e-3));
      continue;
    }
    // What they share, as a solid of its own: another road to the same volume.
    const Intersection<3> common({borrow<3>(ring->function()), borrow<3>(other->function())});
    const MeshReport shared =
        check_mesh(polygonize(common, Points<3>(3, 0), {.cells = 120, .exhaustive = true}).mesh);
    add_mesh_facts(facts, shared);
    figure.checks.push_back(equal(name + ": the common solid is closed", shared.closed ? 1 : 0, 1));
    figure.checks.push_back(at_least(name + ": its mesh\u2019s volume over the proven least",
                                     shared.volume / found.low, 0.99));  // the mesh cuts off sharp edges
    figure.checks.push_back(
        at_most(name + ": its mesh\u2019s volume over the proven most", shared.volume / found.high, 1));
    Scene alone;
    alone.solids.push_back(ring_solid & solid_of(other->function(), surface::orange));
    figure.panels.push_back(studio_panel(context, name + "-common", "what they share", alone, shot));
    figure.panels.back().facts["volume"] = shared.volume;
    figure.panels.back().facts["components"] = shared.components;
  }

  // The whole way.
  Series volume{.name = "common volume"};
  Series low{.name = "proven at least", .color = theme::soft_ink, .line_width = 1, .dash = {4, 3}};
  Series high{.name = "proven at most", .color = theme::soft_ink, .line_width = 1, .dash = {1.5, 2.5}};
  constexpr int steps = 20;
  Index unproven = 0;
  for (int i = 0; i <= steps; ++i) {
    report(context.progress, i / static_cast<double>(steps));
    const double at = 3.4 - 6.8 * i / steps;
    const Fit<3> other = fit(moved(bone, at * way));
    const Interference found =
        interference(ring->function(), other.function, {.width = 0.25, .evaluations = 3'000'000});
    unproven += !found.certain;
    for (Series* series : {&volume, &low, &high}) series->x.push_back(at);
    volume.y.push_back(found.volume);
    low.y.push_back(found.low);
    high.y.push_back(found.high);
  }
  Chart chart;
  chart.x = {.label = "place of the bone on its way"};
  chart.y = {.label = "common volume"};
  chart.series = {high, low, volume};
  chart.legend = Legend::top_left;
  Panel panel{.name = "volume", .title = "the common volume on the whole way", .width = 300, .height = 240};
  panel.draw = [chart](Canvas& canvas, const Rect& region) { draw_chart(canvas, region, chart); };
  panel.facts["greatest_common_volume"] = *std::max_element(volume.y.begin(), volume.y.end());
  panel.facts["places"] = steps + 1;
  figure.checks.push_back(equal("whole way: places without a proof", static_cast<double>(unproven), 0));
  figure.checks.push_back(
      at_most("whole way: common volume at its ends", volume.y.front() + volume.y.back(), 0));
  figure.panels.push_back(std::move(panel));
  figure.columns = 3;
  figure.caption =
      "A bone of 15 constraints and a ring of " + std::to_string(ring->constraints.size()) +
      ". Apart, their clearance is " + in_words(figure.panels[0].facts["clearance"].get<double>(), 3) +
      ", proven to be " + in_words(figure.panels[0].facts["clearance_at_least"].get<double>(), 2) +
      " at least. Together, boxes in which both functions are proven positive, and boxes in which one "
      "is proven negative, leave an interval for the common volume.";
  return figure;
}

}  // namespace seesaw
