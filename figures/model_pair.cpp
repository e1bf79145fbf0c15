#include "figures/model_pair.h"

#include "core/modelling/model_constraints.h"

namespace seesaw {

ModelPair add_model_pair(Figure& figure, const FigureContext& context, TriangleMesh model, const Color& color,
                         const Framing& framing) {
  const ModelConstraints made = constraints_from(model, {.to_unit_cube = true});
  const SurfacePointer surface = fit_surface(made.constraints);
  model.vertices = made.report.cube.apply(model.vertices);
  const MeshReport polygons = check_mesh(model);

  Scene scenes[2];
  scenes[0].meshes.push_back(polygon_model(model, color));
  scenes[1].meshes.push_back(smooth_surface(surface->polygons.mesh, color));
  // One camera, so that the two can be compared.
  Points<3> both(3, model.vertices.cols() + surface->polygons.mesh.vertices.cols());
  both << model.vertices, surface->polygons.mesh.vertices;
  const PinholeCamera camera = frame(both, framing);
  for (Scene& scene : scenes) scene.floor = floor_under(bounding_box(scene), framing.up);
  figure.panels.push_back(studio_panel(context, "left", "polygons", scenes[0], {.camera = camera}));
  figure.panels.push_back(
      studio_panel(context, "right", "interpolating surface", scenes[1], {.camera = camera}));
  add_mesh_facts(figure.panels[0].facts, polygons);
  Facts& facts = figure.panels[1].facts;
  facts.update(surface_facts(*surface));
  facts["offsets_shrunk"] = made.report.shrunk;

  // Every vertex on the surface: |f| / |grad f| there, in unit cubes.
  const Interpolant<3>& f = surface->function();
  Values values(model.vertices.cols());
  Points<3> gradients(3, model.vertices.cols());
  f.evaluate(model.vertices, values, gradients);
  const double farthest =
      (values.cwiseAbs().array() / gradients.colwise().norm().transpose().array()).maxCoeff();
  facts["farthest_vertex"] = farthest;
  facts["volume_over_polygons"] = surface->report.volume / polygons.volume;

  figure.checks.push_back(residual_check("right", surface->fitted.report));
  figure.checks.push_back(equal("right: a boundary and a normal constraint for each vertex",
                                static_cast<double>(surface->fitted.report.constraints()),
                                static_cast<double>(2 * polygons.vertices)));
  check_topology(figure, "left", polygons, 1, 0);
  check_topology(figure, "right", surface->report, 1, 0);
  figure.checks.push_back(at_most("right: distance of a vertex from the surface, at most", farthest, 1e-9));
  figure.checks.push_back(at_most("right: seeds missed by the polygonizer",
                                  static_cast<double>(surface->polygons.seeds_missed), 0));
  return {std::move(model), surface};
}

}  // namespace seesaw
