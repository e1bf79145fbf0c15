// T&O 2002, section 5: a new boundary constraint on the curve changes the function nowhere; moving it then
// does.
#include "figures/scene_panel.h"

namespace seesaw {

namespace {

constexpr int added = 6;

// `document` with `added` highlighted boundary constraints, evenly spread along its curve.
Document<2> with_knots(const FittedScene& scene) {
  Document<2> document = scene.document;
  const Polyline& curve = scene.curve.polylines.front();
  const double spacing = length(curve) / added;
  double way = 0, next = 0.62 * spacing;
  for (Index i = 0; i < curve.vertices.cols(); ++i) {
    const Point<2> a = curve.vertices.col(i), b = curve.vertices.col((i + 1) % curve.vertices.cols());
    way += (b - a).norm();
    if (way < next) continue;
    next += spacing;
    document.constraints.push_back({.constraint = boundary<2>(b), .highlight = true});
  }
  return document;
}

double greatest_change(const Field<2>& f, const Field<2>& g, const Box<2>& box) {
  constexpr int n = 200;
  Points<2> points(2, n * n);
  for (int i = 0; i < n * n; ++i)
    points.col(i) = box.min() + box.sizes().cwiseProduct(Point<2>((i % n + 0.5) / n, (i / n + 0.5) / n));
  return (f.values(points) - g.values(points)).cwiseAbs().maxCoeff();
}

}  // namespace

Figure knot_insertion(const FigureContext& context) {
  Figure figure{
      .id = "knot-insertion",
      .paper = "Companion to Turk & O\u2019Brien 2002, section 5",
      .title = "New boundary constraints leave the curve unchanged",
      .shows =
          "Adding a new boundary constraint on the existing surface does not affect the surface shape at "
          "all. Only when such a new boundary constraint is moved, does it begin to affect the shape."};
  const ScenePointer before = fit_scene_file(context, "knot-insertion");
  const ScenePointer knots = fit_scene(with_knots(*before));
  Document<2> pulled = knots->document;
  std::size_t grabbed = before->document.constraints.size();
  for (std::size_t i = grabbed; i < pulled.constraints.size(); ++i) {
    pulled.constraints[i].highlight = false;
    // Grab the uppermost of the new ones.
    if (pulled.constraints[i].constraint.at.y() > pulled.constraints[grabbed].constraint.at.y()) grabbed = i;
  }
  pulled.constraints[grabbed].highlight = true;
  pulled.constraints[grabbed].constraint.at += Point<2>(0.1, 0.35);
  const ScenePointer moved = fit_scene(pulled);

  const double unchanged = greatest_change(before->function(), knots->function(), before->view);
  const double changed = greatest_change(before->function(), moved->function(), before->view);
  PictureOptions ghost;
  ghost.ghosts = before->curve.polylines;
  figure.panels.push_back(scene_panel(before, "before", "before"));
  figure.panels.push_back(scene_panel(knots, "added", "six boundary constraints added on the curve"));
  figure.panels.push_back(scene_panel(moved, "moved", "one of them moved", ghost));
  figure.panels[1].facts["greatest_change"] = unchanged;
  figure.panels[2].facts["greatest_change"] = changed;
  for (const auto& [name, scene] : {std::pair{"before", before}, {"added", knots}, {"moved", moved}}) {
    figure.checks.push_back(residual_check(name, scene->fitted.report));
    figure.checks.push_back(
        equal(std::string(name) + ": curves", static_cast<double>(scene->curve.components), 1));
    figure.checks.push_back(
        equal(std::string(name) + ": closed curves", static_cast<double>(scene->curve.closed), 1));
  }
  figure.checks.push_back(equal(
      "added: new constraints",
      static_cast<double>(knots->document.constraints.size() - before->document.constraints.size()), added));
  figure.checks.push_back(at_most("added: greatest change of f over the view", unchanged, 1e-9));
  figure.checks.push_back(at_least("moved: greatest change of f over the view", changed, 0.01));
  figure.caption =
      "Six constraints placed on the curve ask for f = 0 where f is zero already: f changes by less than "
      "10\u207b\u2079 "
      "anywhere in the picture. Moving one changes it by up to " +
      in_words(changed, 2) + ", and the others hold the curve (the old one is dashed).";
  return figure;
}

}  // namespace seesaw
