// Turk & O'Brien 2002, Figure 3: a fist of 750 vertices becomes a smooth surface.
#include "core/mesh/mesh_file.h"
#include "figures/model_pair.h"

namespace seesaw {

Figure turk2002_fig03(const FigureContext& context) {
  Figure figure{
      .id = "turk2002-fig03",
      .paper = "Turk & O\u2019Brien 2002, Figure 3",
      .title = "A polygonal fist and its interpolating surface",
      .shows =
          "A polygonal surface of a human fist with 750 vertices (left) and an interpolating implicit "
          "surface created from the polygons (right)."};
  const ModelPair pair = add_model_pair(figure, context, read_mesh(context.data / "fist_750.obj").mesh,
                                        surface::sand, {.direction = {0.5, 0.35, 1}, .margin = 0.07});
  figure.checks.push_back(equal("left: vertices", static_cast<double>(pair.model.vertices.cols()), 750));
  const Facts& facts = figure.panels[1].facts;
  figure.caption =
      "Left, 750 vertices and " + std::to_string(pair.model.faces.cols()) +
      " triangles. Right, the surface through all of them: one boundary and one normal constraint a "
      "vertex, 0.01 inside for a model in the unit cube. It passes within " +
      in_words(facts["farthest_vertex"].get<double>(), 2) + " of every vertex, has the same topology, and " +
      in_words(100 * (facts["volume_over_polygons"].get<double>() - 1), 2) +
      " % more volume. The fist is CGAL\u2019s hand.off (CC0), simplified.";
  return figure;
}

}  // namespace seesaw
