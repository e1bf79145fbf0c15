// Turk & O'Brien 2002, Figure 5: moving one normal constraint bends the curve there, and hardly elsewhere.
#include <cmath>

#include "figures/signs.h"

namespace seesaw {

namespace {

// The angle between the asked outward normal and the curve's, -grad f / |grad f|, in degrees.
double degrees_off(const Interpolant<2>& f, const Constraint<2>& constraint) {
  const Point<2> asked = constraint.normal->direction, found = -f.gradient(constraint.at);
  return std::abs(std::atan2(asked.x() * found.y() - asked.y() * found.x(), asked.dot(found))) * 180 / M_PI;
}

}  // namespace

Figure turk2002_fig05(const FigureContext& context) {
  Figure figure{
      .id = "turk2002-fig05",
      .paper = "Turk & O\u2019Brien 2002, Figure 5 (Figure 4 of the 1999 report)",
      .title = "One normal constraint bends a curve",
      .shows =
          "Two curves defined using nearly identical boundary and normal constraints. By moving just a "
          "single normal constraint (the north-west one, shown in red), the curve on the left is changed "
          "to that shown on the right."};
  const ScenePointer scenes[] = {fit_scene_file(context, "turk2002-fig05-left"),
                                 fit_scene_file(context, "turk2002-fig05-right")};
  const char* const names[] = {"left", "right"};
  const char* const titles[] = {"six boundary and six normal constraints",
                                "the north-west normal constraint moved"};
  double left_worst = 0;
  for (int side = 0; side < 2; ++side) {
    const FittedScene& scene = *scenes[side];
    const std::string name = names[side];
    PictureOptions options;
    if (side == 1) options.ghosts = scenes[0]->curve.polylines;
    Panel panel = scene_panel(scenes[side], name, titles[side], options);
    Facts degrees = Facts::array();
    double most = 0;  // of those that did not move
    for (const auto& each : scene.document.constraints) {
      degrees.push_back(degrees_off(scene.function(), each.constraint));
      if (!each.highlight_normal) most = std::max(most, degrees.back().get<double>());
    }
    if (side == 0) left_worst = most;
    panel.facts["normal_degrees_off"] = degrees;
    figure.checks.push_back(residual_check(name, scene.fitted.report));
    figure.checks.push_back(equal(name + ": closed curves", static_cast<double>(scene.curve.closed), 1));
    figure.checks.push_back(equal(name + ": curves", static_cast<double>(scene.curve.components), 1));
    figure.checks.push_back(
        at_most(name + ": unmoved normals off by degrees, at most", most, side == 0 ? 1 : 3));
    add_signs(measure_signs(scene), panel, figure);
    figure.panels.push_back(std::move(panel));
  }

  // Where the curve moved: near the constraint whose normal was moved, hardly elsewhere.
  std::size_t moved = 0;
  double others = 0;
  for (std::size_t i = 0; i < scenes[0]->document.constraints.size(); ++i) {
    const auto &a = scenes[0]->document.constraints[i].constraint,
               &b = scenes[1]->document.constraints[i].constraint;
    if (scenes[1]->document.constraints[i].highlight_normal)
      moved = i;
    else
      others += (a.normal->direction - b.normal->direction).norm();
    others += (a.at - b.at).norm();
  }
  figure.checks.push_back(equal("right: how far everything else moved", others, 0));
  const auto &asked_before = scenes[0]->document.constraints[moved].constraint.normal->direction,
             &asked_after = scenes[1]->document.constraints[moved].constraint.normal->direction;
  const double turned = std::acos(asked_before.normalized().dot(asked_after.normalized())) * 180 / M_PI;
  const double lag = degrees_off(scenes[1]->function(), scenes[1]->document.constraints[moved].constraint);
  figure.panels[1].facts["moved_normal_turned_degrees"] = turned;
  figure.checks.push_back(at_most("right: moved normal\u2019s lag over its turn", lag / turned, 0.5));
  const Point<2> place = scenes[0]->document.constraints[moved].constraint.at;
  figure.checks.push_back(
      at_least("right: the moved normal is in the north-west", std::min(-place.x(), place.y()), 0.1));
  const Polyline &before = scenes[0]->curve.polylines[0], &after = scenes[1]->curve.polylines[0];
  const double size = bounding_box(before).sizes().maxCoeff();
  double near = 0, elsewhere = 0;
  for (Index i = 0; i < after.vertices.cols(); ++i) {
    const Point<2> p = after.vertices.col(i);
    const double change = distance(before, p);
    ((p - place).norm() < 0.5 * size ? near : elsewhere) =
        std::max((p - place).norm() < 0.5 * size ? near : elsewhere, change);
  }
  figure.panels[1].facts["greatest_change_near"] = near;
  figure.panels[1].facts["greatest_change_elsewhere"] = elsewhere;
  figure.checks.push_back(at_least("right: greatest change near, over the curve's size", near / size, 0.02));
  figure.checks.push_back(at_most("right: greatest change elsewhere over that near", elsewhere / near, 0.2));
  figure.caption =
      "Each boundary constraint has a normal constraint 0.01 inside it, drawn as a spike along the outward "
      "normal. Left, "
      "the curve\u2019s own normals agree with the spikes to " +
      in_words(left_worst, 2) + "\u00b0. Right, the red spike was turned by " + in_words(turned, 2) +
      "\u00b0 and the curve follows to within " + in_words(lag, 2) +
      "\u00b0 (one value beside the curve fixes the slope along the spike, not across it; the lag shrinks "
      "only slowly with "
      "the offset). The old curve is dashed: farther than half the shape away it moved by " +
      in_words(100 * elsewhere / size, 2) + " % of the shape\u2019s size.";
  return figure;
}

}  // namespace seesaw
