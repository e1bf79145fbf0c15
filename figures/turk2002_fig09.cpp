// Turk & O'Brien 2002, Figure 9: three polygonal tori that overlap, and their soft union by the paper's rule.
#include <cmath>

#include "core/implicit/booleans.h"
#include "core/modelling/blend.h"
#include "core/modelling/model_constraints.h"
#include "core/modelling/polygonal_torus.h"
#include "figures/bulge.h"
#include "figures/studio.h"
#include "figures/surface.h"

namespace seesaw {

namespace {

constexpr double major = 1.0, minor = 0.34;

// Three tori around one axis, each leaning out, so that each meets both others.
std::vector<TorusShape> tori() {
  std::vector<TorusShape> shapes;
  for (int i = 0; i < 3; ++i) {
    const double angle = 2 * M_PI * i / 3 + M_PI / 2;
    const Point<3> out(std::cos(angle), std::sin(angle), 0);
    shapes.push_back({.center = 0.95 * out,
                      .axis = Point<3>(0.42 * out.y(), -0.42 * out.x(), 1),
                      .major = major,
                      .minor = minor});
  }
  return shapes;
}

Points<3> core_circle(const TorusShape& shape, int count) {
  const Point<3> u = shape.axis.unitOrthogonal(), v = shape.axis.normalized().cross(u);
  Points<3> circle(3, count);
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * M_PI * i / count;
    circle.col(i) = shape.center + shape.major * (std::cos(angle) * u + std::sin(angle) * v);
  }
  return circle;
}

}  // namespace

Figure turk2002_fig09(const FigureContext& context) {
  Figure figure{.id = "turk2002-fig09",
                .paper = "Turk & O\u2019Brien 2002, Figure 9",
                .title = "The soft union of three tori",
                .shows =
                    "Three polygonal tori (left), and the soft union created with interpolating implicits "
                    "(right). Constraints of each object are kept if they are outside of all others."};
  Scene scenes[2];
  std::vector<SurfacePointer> surfaces;
  std::vector<BlendObject<3>> objects;
  std::vector<FieldPointer<3>> fields;
  int i = 0;
  for (const TorusShape& shape : tori()) {
    const TriangleMesh mesh = polygonal_torus(shape, 28, 12);
    scenes[0].meshes.push_back(polygon_model(mesh, surface::of_object(i++)));
    surfaces.push_back(fit_surface(constraints_from(mesh).constraints));
    objects.push_back({surfaces.back()->constraints, &surfaces.back()->function()});
    fields.push_back(borrow<3>(surfaces.back()->function()));
  }
  const Union<3> hard(fields);
  const Blend<3> kept = blend(objects);
  const SurfacePointer soft = fit_surface(kept.constraints, {.cells = 140});
  const Polygonization hard_mesh = polygonize(hard, boundary_points(kept.constraints), {.cells = 140});
  const MeshReport hard_report = check_mesh(hard_mesh.mesh);
  scenes[1].meshes.push_back(smooth_surface(soft->polygons.mesh, surface::blue));

  const Point<3> up = Point<3>::UnitZ();
  const PinholeCamera camera = frame(scenes[0], {.direction = {0.25, -1, 1.1}, .up = up});
  const char* const names[] = {"left", "right"};
  const char* const titles[] = {"three polygonal tori", "their soft union"};
  for (int side = 0; side < 2; ++side) {
    scenes[side].floor = floor_under(bounding_box(scenes[0]), up);
    figure.panels.push_back(
        studio_panel(context, names[side], titles[side], scenes[side], {.camera = camera}));
  }

  Facts& left = figure.panels[0].facts;
  Index vertices = 0;
  for (const SurfacePointer& each : surfaces) vertices += static_cast<Index>(each->constraints.size());
  left["constraints_before"] = 2 * vertices;
  left["hard_union_genus"] = hard_report.genus;
  Facts& right = figure.panels[1].facts;
  right.update(surface_facts(*soft));
  right["kept"] = kept.kept;
  right["dropped"] = kept.dropped;
  const double size = bounding_box(scenes[0]).sizes().maxCoeff();
  const double bulge = farthest_outside(soft->polygons.mesh, hard_mesh.mesh, hard) / size;
  right["greatest_distance_outside_hard_union"] = bulge;
  // The same tori as rings of blobby spheres, simply summed.
  std::vector<BlobbyChain> rings;
  for (const TorusShape& shape : tori()) rings.push_back(blobby_chain(core_circle(shape, 40), minor));
  const SummedBlobbies summed = sum_of(rings, chain_threshold(rings[0], minor));
  right["same_for_summed_blobbies"] = summed.farthest_outside / size;

  figure.checks.push_back(residual_check("right", soft->fitted.report));
  check_topology(figure, "right", soft->report, 1, hard_report.genus);
  figure.checks.push_back(equal("hard union: components", static_cast<double>(hard_report.components), 1));
  figure.checks.push_back(
      at_most("right: greatest distance outside the hard union, over the size", bulge, 0.02));
  figure.checks.push_back(at_least("summed blobbies stand out farther, by a factor of",
                                   summed.farthest_outside / size / bulge, 2));
  Index kept_all = 0, dropped_all = 0;
  for (const Index count : kept.kept) kept_all += count;
  for (const Index count : kept.dropped) dropped_all += count;
  figure.caption = "Each torus has a boundary and a normal constraint a vertex. Of all constraints, " +
                   std::to_string(dropped_all) + " lie inside another torus and are dropped; the " +
                   std::to_string(kept_all) + " that are left make one smooth surface of genus " +
                   std::to_string(soft->report.genus) +
                   ", as the union has. It stands out of the union nowhere by more than " +
                   in_words(100 * bulge, 2) +
                   " % of the size; blobby rings of the same measures, summed, by " +
                   in_words(100 * summed.farthest_outside / size, 2) + " %.";
  return figure;
}

}  // namespace seesaw
