// Turk & O'Brien 2002, Figure 1: four zeros and one interior constraint make a curve; three more zeros refine
// it.
#include <cmath>

#include "figures/signs.h"

namespace seesaw {

Figure turk2002_fig01(const FigureContext& context) {
  Figure figure{
      .id = "turk2002-fig01",
      .paper = "Turk & O\u2019Brien 2002, Figure 1",
      .title = "Curves from boundary constraints and one interior constraint",
      .shows =
          "The curve on the left is defined by four zero-valued and one positive constraint. This curve "
          "is refined by adding three new zero-valued constraints, shown in red at right."};
  const ScenePointer scenes[] = {fit_scene_file(context, "turk2002-fig01-left"),
                                 fit_scene_file(context, "turk2002-fig01-right")};
  const char* const names[] = {"left", "right"};
  std::string far_away;
  for (int side = 0; side < 2; ++side) {
    const FittedScene& scene = *scenes[side];
    const std::string name = names[side];
    PictureOptions options;
    if (side == 1) options.ghosts = scenes[0]->curve.polylines;
    Panel panel = scene_panel(
        scenes[side], name,
        side == 0 ? "four boundary constraints, one interior" : "three new boundary constraints", options);
    const Signs signs = measure_signs(scene);
    add_signs(signs, panel, figure);
    figure.checks.push_back(residual_check(name, scene.fitted.report));
    figure.checks.push_back(equal(name + ": closed curves", static_cast<double>(scene.curve.closed), 1));
    figure.checks.push_back(equal(name + ": curves", static_cast<double>(scene.curve.components), 1));
    figure.checks.push_back(equal(name + ": boundary constraints on the curve",
                                  static_cast<double>(scene.curve.seeds_on_curve), side == 0 ? 4 : 7));
    figure.checks.push_back(
        at_most(name + ": |f(plus) - 1|", std::abs(scene.function().value({0, 0}) - 1), 1e-12));
    figure.panels.push_back(std::move(panel));
    far_away += (side ? " and " : "") + in_words(signs.returns_at_sizes, 3);
  }
  // The right side only adds to the left: its first five constraints are the same.
  double moved = 0;
  for (std::size_t i = 0; i < 5; ++i)
    moved +=
        (scenes[0]->document.constraints[i].constraint.at - scenes[1]->document.constraints[i].constraint.at)
            .norm();
  figure.checks.push_back(equal("right: how far the first five constraints moved", moved, 0));
  double change = 0;
  for (Index i = 0; i < scenes[0]->curve.polylines[0].vertices.cols(); ++i)
    change = std::max(change,
                      distance(scenes[1]->curve.polylines[0], scenes[0]->curve.polylines[0].vertices.col(i)));
  figure.panels[1].facts["greatest_distance_from_left_curve"] = change;
  figure.checks.push_back(at_least("right: greatest distance between the two curves", change, 0.1));
  figure.caption =
      "Circles: boundary constraints, f = 0. Plus sign: interior constraint, f = 1. The thin-plate function "
      "(r\u00b2 log r) "
      "is positive inside (orange) and negative outside (blue); its zero set is the curve. New constraints "
      "are red, the "
      "old curve dashed. Far away the linear term wins over the logarithm: the sign returns at " +
      far_away + " times the size of the shape (left and right).";
  return figure;
}

}  // namespace seesaw
