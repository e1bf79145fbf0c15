// T&O 2002, section 6: a trunk and two branches. Summed blobbies bulge where they join, the interpolating
// blend does not.
#include <cmath>

#include "core/implicit/booleans.h"
#include "core/modelling/blend.h"
#include "core/modelling/model_constraints.h"
#include "figures/bulge.h"
#include "figures/capsule.h"
#include "figures/studio.h"
#include "figures/surface.h"

namespace seesaw {

namespace {

constexpr double radius = 0.3;
const Point<3> fork(0, 0, 0);
const std::pair<Point<3>, Point<3>> limbs[] = {
    {{0, -1.7, 0}, fork}, {fork, {-0.95, 1.25, 0.15}}, {fork, {0.95, 1.25, -0.15}}};

}  // namespace

Figure blend_bulge(const FigureContext& context) {
  Figure figure{
      .id = "blend-bulge",
      .paper = "Companion to Turk & O\u2019Brien 2002, section 6",
      .title = "Where a trunk meets two branches",
      .shows =
          "It is difficult to get satisfactory results when summing together the implicit functions "
          "for two branches and a trunk of a tree: the surface will bulge where they join. Objects "
          "that are blended by keeping the constraints outside all others are free of bulges."};
  // The same three limbs twice: as chains of blobby spheres, and as polygon models.
  std::vector<BlobbyChain> chains;
  std::vector<SurfacePointer> surfaces;
  std::vector<BlendObject<3>> objects;
  std::vector<FieldPointer<3>> fields;
  Scene polygons;
  int i = 0;
  for (const auto& [from, to] : limbs) {
    Points<3> path(3, 24);
    for (int k = 0; k < 24; ++k) path.col(k) = from + (to - from) * (k / 23.0);
    chains.push_back(blobby_chain(path, radius));
    const TriangleMesh mesh = capsule_mesh(from, to, radius, 10);
    polygons.meshes.push_back(polygon_model(mesh, surface::of_object(i++)));
    surfaces.push_back(fit_surface(constraints_from(mesh).constraints));
    objects.push_back({surfaces.back()->constraints, &surfaces.back()->function()});
    fields.push_back(borrow<3>(surfaces.back()->function()));
  }
  const SummedBlobbies summed = sum_of(chains, chain_threshold(chains[0], radius));
  const Blend<3> kept = blend(objects);
  const SurfacePointer soft = fit_surface(kept.constraints, {.cells = 140});
  const Union<3> hard(fields);
  const Polygonization hard_mesh = polygonize(hard, boundary_points(kept.constraints), {.cells = 140});
  const double bulge = farthest_outside(soft->polygons.mesh, hard_mesh.mesh, hard);

  Scene scenes[3] = {polygons, {}, {}};
  scenes[1].meshes.push_back(smooth_surface(summed.mesh, surface::orange));
  scenes[2].meshes.push_back(smooth_surface(soft->polygons.mesh, surface::teal));
  const PinholeCamera camera = frame(scenes[0], {.direction = {0.15, 0.1, 1}, .aspect = 0.8});
  const char* const names[] = {"polygons", "blobbies", "blend"};
  const char* const titles[] = {"a trunk and two branches", "blobby limbs, summed",
                                "the interpolating blend"};
  for (int k = 0; k < 3; ++k)
    figure.panels.push_back(studio_panel(context, names[k], titles[k], scenes[k],
                                         {.camera = camera, .width = 300, .height = 375}));
  figure.panels[0].facts["limb_radius"] = radius;
  add_mesh_facts(figure.panels[1].facts, check_mesh(summed.mesh));
  figure.panels[1].facts["greatest_distance_outside_hard_union"] = summed.farthest_outside;
  figure.panels[2].facts.update(surface_facts(*soft));
  figure.panels[2].facts["greatest_distance_outside_hard_union"] = bulge;
  figure.panels[2].facts["kept"] = kept.kept;
  figure.panels[2].facts["dropped"] = kept.dropped;
  figure.checks.push_back(residual_check("blend", soft->fitted.report));
  check_topology(figure, "blobbies", check_mesh(summed.mesh), 1, 0);
  check_topology(figure, "blend", soft->report, 1, 0);
  figure.checks.push_back(
      at_least("blobbies: bulge over the limbs\u2019 radius", summed.farthest_outside / radius, 0.25));
  figure.checks.push_back(
      at_most("blend: bulge over that of the summed blobbies", bulge / summed.farthest_outside, 0.5));
  figure.caption =
      "The same three limbs. Summed, their values add up at the fork and push the surface out by " +
      in_words(100 * summed.farthest_outside / radius, 2) +
      " % of a limb\u2019s radius beyond the union of the limbs. The blend keeps each limb\u2019s "
      "constraints outside the others and lets the smoothest function bridge the fork: it stands out by " +
      in_words(100 * bulge / radius, 2) + " %.";
  return figure;
}

}  // namespace seesaw
