// The same constraints under each kernel (T&O 2002, section 3): three functions, three curves, three
// energies.
#include "core/scene/document_rules.h"
#include "figures/scene_panel.h"
#include "figures/studio.h"
#include "figures/surface.h"

namespace seesaw {

namespace {

// The 3D half: one set of constraints under |x|^3 and |x|. Returns the sharpest Hessian beside a center, for
// each.
std::vector<double> add_surfaces(Figure& figure, const FigureContext& context) {
  const Document<3> document = scene_named(context, "kernels-3d");
  const Constraints<3> constraints = constraints_of(document);
  std::vector<double> sharpest;
  std::optional<PinholeCamera> camera;
  for (const Kernel kernel : all_kernels) {
    const std::string name = std::string(name_of(kernel)) + "-3d";
    const SurfacePointer surface = fit_surface(
        constraints,
        {.cells = 60, .halvings = 0},  // the cones of |x| have dimples that no lattice is fine enough for
        {.kernel = kernel});
    Scene scene;
    scene.meshes.push_back(smooth_surface(surface->polygons.mesh, surface::clay));
    scene.spheres.push_back(markers(boundary_points(constraints), 0.05));
    if (!camera) camera = camera_for(document, scene, {.margin = 0.1});
    scene.floor = floor_under(bounding_box(scene), camera->up);
    Panel panel = studio_panel(context, name, std::string(formula_of(kernel)) + ", in space", scene,
                               {.camera = *camera});
    panel.facts.update(surface_facts(*surface));
    const auto& f = surface->function();
    double bend = 0;  // the largest |Hessian| a thousandth from a boundary constraint
    for (Index i = 0; i < f.size(); ++i)
      bend = std::max(bend, f.hessian(f.centers().col(i) + Point<3>(1e-3, 0, 0)).norm());
    panel.facts["hessian_beside_a_center"] = bend;
    sharpest.push_back(bend);
    figure.checks.push_back(residual_check(name, surface->fitted.report));
    check_topology(figure, name, surface->report, 1, 0);
    figure.panels.push_back(std::move(panel));
  }
  figure.checks.push_back(at_least("in space: the cones of r are sharper than r\u00b3, beside a center",
                                   sharpest[2] / sharpest[1], 20));
  return sharpest;
}

}  // namespace

Figure kernels_figure(const FigureContext& context) {
  Figure figure{
      .id = "kernels",
      .paper = "Companion to Turk & O\u2019Brien 2002, section 3",
      .title = "The same constraints under three kernels",
      .shows =
          "The radial basis function decides what \u201csmooth\u201d means: r\u00b2 log r minimizes the "
          "bending energy of equation 3 in the plane; r\u00b3 is what the paper uses in space; Carr et al. "
          "use r."};
  const ScenePointer model = fit_scene_file(context, "kernels-2d");
  std::vector<ScenePointer> scenes;
  for (const Kernel kernel : all_kernels) {
    Document<2> document = model->document;
    document.kernel = kernel;
    scenes.push_back(fit_scene(document));
  }
  for (const ScenePointer& scene : scenes) {
    const std::string name(name_of(scene->document.kernel));
    PictureOptions options;
    options.color_range = 2.5;
    Panel panel = scene_panel(scene, name, formula_of(scene->document.kernel), options);
    // What each function costs by the others' measure is not comparable; by its own, no other function is
    // cheaper.
    const auto& f = scene->function();
    double sharpest =
        0;  // |Hessian| a thousandth from the first boundary constraint: a cone's grows without bound
    const Point<2> beside = f.centers().col(0) + Point<2>(1e-3, 0);
    sharpest = f.hessian(beside).norm();
    panel.facts["hessian_beside_a_center"] = sharpest;
    figure.checks.push_back(residual_check(name, scene->fitted.report));
    figure.checks.push_back(equal(name + ": curves", static_cast<double>(scene->curve.components), 1));
    figure.checks.push_back(equal(name + ": closed curves", static_cast<double>(scene->curve.closed), 1));
    figure.checks.push_back(equal(name + ": boundary constraints on the curve",
                                  static_cast<double>(scene->curve.seeds_on_curve), 7));
    double farthest = 0;  // of a boundary constraint from the curve
    for (Index i = 0; i < 7; ++i)
      farthest =
          std::max(farthest, distance(scene->curve.polylines[0], boundary_points(scene->document).col(i)));
    figure.checks.push_back(at_most(name + ": boundary constraints off the curve, at most", farthest, 1e-12));
    figure.panels.push_back(std::move(panel));
  }
  const auto bend = [&](std::size_t i) {
    return figure.panels[i].facts["hessian_beside_a_center"].get<double>();
  };
  figure.checks.push_back(
      at_least("the cone of r is sharper than the plate, beside a center", bend(2) / bend(0), 5));
  figure.checks.push_back(
      at_most("r\u00b3 is flatter than the plate, beside a center", bend(1) / bend(0), 1));
  const std::vector<double> in_space = add_surfaces(figure, context);
  figure.columns = 3;
  figure.caption =
      "(a) The thin plate: everywhere smooth, its curvature peaking mildly at the constraints. (b) r\u00b3: "
      "smoother still, and it swings wider. (c) r: least swing, but a cone stands at every constraint and "
      "the "
      "curve has a corner in each. Second derivatives at 0.001 from a boundary constraint: " +
      in_words(bend(0), 2) + ", " + in_words(bend(1), 2) + " and " + in_words(bend(2), 2) +
      ". (d\u2013f) The same in space: r\u00b2 log r is tighter than r\u00b3, and r is a film that comes to "
      "a "
      "point in every constraint (" +
      in_words(in_space[0], 2) + ", " + in_words(in_space[1], 2) + " and " + in_words(in_space[2], 2) + ").";
  return figure;
}

}  // namespace seesaw
