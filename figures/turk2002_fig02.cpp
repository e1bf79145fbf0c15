// Turk & O'Brien 2002, Figure 2: interior constraints make a near-sphere from four zeros, and a branching
// surface from prisms upon prisms.
#include <cmath>

#include "core/modelling/branching_prisms.h"
#include "figures/studio.h"
#include "figures/surface.h"

namespace seesaw {

namespace {

// How round a mesh is: radii about its own center, and the rms distance from the sphere that fits best.
struct Roundness {
  double radius_ratio = 0;  // largest over smallest distance of a vertex from `about`
  double rms = 0;           // over the best sphere's radius
};

Roundness roundness_of(const TriangleMesh& mesh, const Point<3>& about) {
  const Values radii = (mesh.vertices.colwise() - about).colwise().norm().transpose();
  Roundness result;
  result.radius_ratio = radii.maxCoeff() / radii.minCoeff();
  // The sphere about the same center that fits best has the mean radius; by symmetry no other center does
  // better.
  result.rms = std::sqrt((radii.array() - radii.mean()).square().mean()) / radii.mean();
  return result;
}

Panel near_sphere(Figure& figure, const FigureContext& context) {
  const Document<3> document = scene_named(context, "turk2002-fig02-left");
  const SurfacePointer surface = fit_surface(constraints_of(document), {.cells = 50});
  Scene scene;
  scene.meshes.push_back(smooth_surface(surface->polygons.mesh, surface::clay));
  scene.spheres.push_back(markers(boundary_points(surface->constraints), 0.07));
  const Box<3> subject = bounding_box(scene);
  scene.floor = floor_under(subject, Point<3>::UnitY());
  Panel panel = studio_panel(context, "left", "four zeros, and one interior constraint at their center",
                             scene, {.camera = camera_for(document, scene, {.margin = 0.16})});
  panel.facts.update(surface_facts(*surface));
  const Roundness round = roundness_of(surface->polygons.mesh, Point<3>::Zero());
  panel.facts["max_over_min_radius"] = round.radius_ratio;
  panel.facts["rms_from_best_sphere"] = round.rms;
  figure.checks.push_back(residual_check("left", surface->fitted.report));
  figure.checks.push_back(equal("left: constraints", static_cast<double>(surface->constraints.size()), 5));
  check_topology(figure, "left", surface->report, 1, 0);
  figure.checks.push_back(at_most("left: largest over smallest radius", round.radius_ratio, 1.25));
  figure.checks.push_back(at_most("left: rms deviation from the best sphere, relative", round.rms, 0.06));
  return panel;
}

Panel branching(Figure& figure, const FigureContext& context) {
  const BranchingPrisms prisms = branching_prisms();
  const SurfacePointer surface = fit_surface(prisms.constraints, {.cells = 160});
  Scene scene;
  scene.meshes.push_back(smooth_surface(surface->polygons.mesh, surface::teal));
  const Point<3> up = Point<3>::UnitZ();
  const Framing framing{.direction = {1, -0.9, 0.55}, .up = up, .aspect = 480.0 / 480, .margin = 0.05};
  scene.floor = floor_under(bounding_box(scene), up);
  Shot shot{.camera = frame(scene, framing), .width = 480, .height = 480};
  Panel panel = studio_panel(context, "right", "prisms upon prisms: four generations", scene, shot);

  // The prisms themselves, as an inset from the same direction.
  Scene inset;
  inset.meshes.push_back(polygon_model(prisms.prisms, surface::clay));
  Framing small = framing;
  small.aspect = 1;
  const Panel polygons = studio_panel(context, "prisms", "", inset,
                                      {.camera = frame(inset, small), .width = 140, .height = 140});
  panel.draw = [whole = panel.draw, part = polygons.draw](Canvas& canvas, const Rect& region) {
    whole(canvas, region);
    const double size = 0.3 * region.width;
    const Rect corner{region.left() + 8, region.bottom() - 8 - size, size, size};
    canvas.fill_rectangle(corner, theme::paper);
    part(canvas, corner);
    canvas.text({corner.left() + 6, corner.bottom() - 8}, "the prisms",
                {.size = 8.5, .color = theme::soft_ink});
  };

  panel.facts.update(surface_facts(*surface));
  panel.facts["prisms"] = prisms.prisms.vertices.cols() / 6;
  figure.checks.push_back(residual_check("right", surface->fitted.report));
  figure.checks.push_back(
      at_least("right: prisms", static_cast<double>(prisms.prisms.vertices.cols() / 6), 40));
  check_topology(figure, "right", surface->report, 1, 0);
  // Branching, not a blob: a blob's area is near that of the sphere of its volume.
  const double sphere = std::cbrt(36 * M_PI * surface->report.volume * surface->report.volume);
  panel.facts["area_over_sphere_of_same_volume"] = surface->report.area / sphere;
  figure.checks.push_back(
      at_least("right: area over that of a sphere of the same volume", surface->report.area / sphere, 1.8));
  return panel;
}

}  // namespace

Figure turk2002_fig02(const FigureContext& context) {
  Figure figure{.id = "turk2002-fig02",
                .paper = "Turk & O\u2019Brien 2002, Figure 2 (Figure 2 of the 1999 report)",
                .title = "Surfaces from interior constraints",
                .shows =
                    "Surfaces defined by interior constraints. Left: four zeros at the corners of a regular "
                    "tetrahedron and one interior constraint make a nearly spherical surface. Right: a "
                    "recursive branching surface, from triangular prisms with six zeros and one interior "
                    "constraint each."};
  figure.panels.push_back(near_sphere(figure, context));
  figure.panels.push_back(branching(figure, context));
  const Facts &left = figure.panels[0].facts, &right = figure.panels[1].facts;
  figure.caption =
      "Left: radii about the center differ by a factor of " +
      in_words(left["max_over_min_radius"].get<double>(), 3) + "; the rms distance from the best sphere is " +
      in_words(100 * left["rms_from_best_sphere"].get<double>(), 2) +
      " % of its radius. Right: " + std::to_string(right["prisms"].get<Index>()) +
      " prisms, each smaller and tilted, with " + std::to_string(right["constraints"]["total"].get<Index>()) +
      " constraints; |x|\u00b3 joins them into one smooth surface of genus 0.";
  return figure;
}

}  // namespace seesaw
