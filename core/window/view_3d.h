// A picture of things in space, drawn by OpenGL into a texture: the see-saw's plate in a panel, a surface.
//
//     view.begin(width, height, camera, ui::colors().background);
//     view.draw(plate);
//     view.draw(poles, {.color = ui::colors().ink, .size = 3});
//     view.draw(zero_plane, {.color = ..., .opacity = 0.3});     translucent things last
//     ui::PictureUse use = ui::picture("Plate", view.end(), width, height);
//     if (use.held) camera.orbit(use.dx, use.dy, height);
//
// The light stands left above the viewer and goes with him, so that what he turns to him is lit. Both sides
// of a triangle are. Lines and points have a size in pixels, whatever their distance, and smooth edges;
// triangles have smooth edges only with `samples`.
//
// Before it: orbit_camera.h, drawable.h. After it: a Texture, an Image.
#pragma once

#include <memory>

#include "core/image/image.h"
#include "core/window/drawable.h"
#include "core/window/framebuffer.h"
#include "core/window/orbit_camera.h"

namespace seesaw {

struct DrawLook {
  Color color = hex("#7A8491");  ///< of what has no colors of its own
  double opacity = 1;            ///< 0 .. 1; below 1 it hides nothing behind it
  double size = 2;               ///< width of lines, diameter of points, pixels
  /// Triangles are shaded, points are balls; otherwise everything has just its color.
  bool lit = true;
  /// Lines and points are drawn nearer to the eye than they are, by this part of their distance, in their
  /// place in the picture: what lies on a surface is seen. More lets it shine through thin things, up to 10:
  /// through all of them.
  double lift = 0.006;
};

class View3D {
 public:
  /// A Window must exist, now and when it goes. `samples` as in Framebuffer.
  explicit View3D(int samples = 0);
  ~View3D();
  View3D(const View3D&) = delete;
  View3D& operator=(const View3D&) = delete;

  /// Begins a picture of width x height real pixels, >= 1.
  void begin(int width, int height, const OrbitCamera& camera, const Color& background);
  void draw(const Drawable& what, const DrawLook& look = {});
  /// The picture, until the next begin.
  const Texture& end();
  /// The same, as an Image.
  Image image() const { return target_.image(); }

 private:
  struct Programs;
  Framebuffer target_;
  std::unique_ptr<Programs> programs_;
  Eigen::Matrix4d camera_from_scene_ = Eigen::Matrix4d::Identity(), clip_from_camera_ = camera_from_scene_;
};

}  // namespace seesaw
