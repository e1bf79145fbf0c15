#include "figures/scene_panel.h"

#include "core/scene/document_json.h"

namespace seesaw {

ScenePointer fit_scene(Document<2> document) {
  Fit<2> fitted = fit(document);
  const Box<2> view = view_box(document, fitted.function);
  // The facts are measured on a finer curve than a picture needs.
  Contour curve = contour(document, fitted.function, view, {.cells = 256, .angle_tolerance = 0.03});
  return std::make_shared<FittedScene>(
      FittedScene{std::move(document), std::move(fitted), view, std::move(curve)});
}

ScenePointer fit_scene_file(const FigureContext& context, const std::string& name) {
  return fit_scene(read_document<2>(context.scenes / (name + ".json")));
}

Panel scene_panel(const ScenePointer& scene, const std::string& name, const std::string& title,
                  const PictureOptions& options) {
  Panel panel{.name = name, .title = title};
  const Point<2> size = scene->view.sizes();
  panel.height = panel.width * size.y() / size.x();
  panel.draw = [scene, options](Canvas& canvas, const Rect& region) {
    draw_document(canvas, region, scene->document, scene->function(), options);
    canvas.rectangle(region, {.color = theme::grid, .width = 0.8});
  };
  panel.facts = fit_facts(scene->fitted.report);
  add_curve_facts(panel.facts, scene->curve);
  return panel;
}

}  // namespace seesaw
