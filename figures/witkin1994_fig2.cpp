// W&H 1994, Fig. 2: a shape of blobby cylinders, made by dragging control points; a recorded list of drags.
#include "core/editing/sculpture.h"
#include "core/mesh/mesh_check.h"
#include "core/polygonize/polygonize.h"
#include "figures/facts.h"
#include "figures/floater_scene.h"
#include "figures/studio.h"
#include "figures/surface.h"

namespace seesaw {

Figure witkin1994_fig2(const FigureContext& context) {
  Figure figure{
      .id = "witkin1994-fig2",
      .paper = "Witkin & Heckbert 1994, Figure 2",
      .title = "Blobby cylinders, shaped by control points",
      .shows =
          "This sequence illustrates the construction of a shape composed of blobby cylinders. The shape was "
          "created by direct manipulation of control points using the mouse. In the topmost image, all three "
          "cylinder primitives are superimposed. Each subsequent image represents the result of a single "
          "mouse motion."};
  const Sculpture sculpture = read_sculpture(context.sessions / "witkin1994-fig2.json");
  Sculptor sculptor(sculpture);
  const PinholeCamera camera = frame(Box<3>(Point<3>(-1.5, -1.25, -0.8), Point<3>(1.5, 1.15, 0.9)),
                                     {.direction = {0.25, 0.3, 1}, .aspect = 1.25});
  double most_off = 0, most_miss = 0, most_variation = 0, widest_gap = 0;
  const auto take = [&](const std::string& name, const std::string& title) {
    sculptor.rest();
    Scene scene;
    scene.discs.push_back(facing(floater_discs(sculptor.floaters()), camera.eye));
    scene.spheres.push_back(markers(sculptor.points().positions, 0.06));
    figure.panels.push_back(
        studio_panel(context, name, title, scene, {.camera = camera, .width = 300, .height = 240}));
    const TriangleMesh mesh =
        polygonize(sculptor.surface(), sculptor.floaters().positions(), {.cells = 60}).mesh;
    Facts& facts = figure.panels.back().facts;
    const MeshReport report = check_mesh(mesh);
    facts["components"] = report.components;
    facts["genus"] = report.genus;
    add_floater_facts(facts, sculptor.floaters(), sculptor.surface(), mesh.vertices);
    facts["control_points"] = sculptor.points().size();
    const Spacing spacing = spacing_of(sculptor.floaters().positions(), sculptor.floaters().normals());
    most_variation = std::max(most_variation, spacing.variation);
    widest_gap = std::max(widest_gap, largest_gap(sculptor.floaters().positions(), mesh.vertices) /
                                          sculptor.floaters().radii().mean());
  };
  take("start", "three cylinders, superimposed");
  for (std::size_t i = 0; i < sculpture.drags.size(); ++i) {
    report(context.progress, static_cast<double>(i) / static_cast<double>(sculpture.drags.size()));
    const DragReport done = sculptor.drag(sculpture.drags[i]);
    take("drag" + std::to_string(i + 1), "mouse motion " + std::to_string(i + 1));
    Facts& facts = figure.panels.back().facts;
    facts["steps"] = done.steps;
    facts["point_ends_from_the_cursor"] = done.miss;
    facts["control_points_off_the_surface"] = done.most_off;
    facts["steps_by_least_squares"] = done.least_squares;
    facts["steps_waited"] = done.waited;
    most_off = std::max(most_off, done.most_off);
    most_miss = std::max(most_miss, done.miss);
  }
  figure.columns = 3;
  const double radius = sculpture.desired_radius;
  figure.checks.push_back(
      at_most("control points: farthest off the surface on the way, desired radii", most_off / radius, 0.05));
  figure.checks.push_back(
      at_most("dragged points: farthest from the cursor, desired radii", most_miss / radius, 1e-3));
  figure.checks.push_back(at_most("floaters: variation of neighbor distances", most_variation, 0.12));
  figure.checks.push_back(at_most("floaters: largest gap, mean radii", widest_gap, 3));
  figure.caption =
      "Control points are red: each mouse motion takes hold of a new one, and those of before stay where "
      "they are. None "
      "was ever more than " +
      in_words(most_off / radius, 2) +
      " desired radii off the surface. (Cylinders that are quite alike would move "
      "alike; these are turned against each other by a few degrees.)";
  return figure;
}

}  // namespace seesaw
