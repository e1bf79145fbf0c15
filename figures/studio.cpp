#include "figures/studio.h"

#include <cmath>
#include <memory>

namespace seesaw {

PinholeCamera camera_for(const Document<3>& document, const Scene& scene, const Framing& framing) {
  if (!document.camera) return frame(scene, framing);
  const Camera& camera = *document.camera;
  return {camera.position, camera.target, camera.up, camera.field_of_view};
}

Panel studio_panel(const FigureContext& context, const std::string& name, const std::string& title,
                   const Scene& scene, const Shot& shot) {
  const auto pixels = [&](double points) {
    return std::max(1, static_cast<int>(std::lround(points * context.pixels_per_point * shot.fineness)));
  };
  RenderOptions options;
  options.width = pixels(shot.width);
  options.height = pixels(shot.height);
  options.samples = shot.samples;
  options.ambient_rays = shot.ambient_rays;
  options.max_depth = shot.max_depth;
  Panel panel = image_panel(name, title, render(scene, shot.camera, options, context.progress), shot.width,
                            shot.height);
  panel.facts["camera"] = to_flags(shot.camera);
  return panel;
}

Panel image_panel(const std::string& name, const std::string& title, const Image& image, double width,
                  double height) {
  Panel panel{.name = name, .title = title, .width = width, .height = height};
  panel.draw = [picture = std::make_shared<const Image>(image)](Canvas& canvas, const Rect& region) {
    canvas.picture(*picture, region);
    canvas.rectangle(region, {.color = theme::grid, .width = 0.8});
  };
  return panel;
}

MeshObject smooth_surface(TriangleMesh mesh, const Color& color) {
  return {.mesh = std::move(mesh), .material = {.color = color}};
}

MeshObject polygon_model(TriangleMesh mesh, const Color& color) {
  return {.mesh = std::move(mesh), .material = {.color = color}, .flat = true, .edges = {.width = 0.9}};
}

SpheresObject markers(const Points<3>& at, double radius, const Color& color) {
  return {.centers = at, .radii = Values::Constant(at.cols(), radius), .material = {.color = color}};
}

}  // namespace seesaw
