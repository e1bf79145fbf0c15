// The photographer's studio of the 3D figures: one light, one floor, one look for all of them.
//
// Before it: a Scene of meshes, markers and traced fields (core/raytrace/scene.h).  After it: a panel of a
// figure.
#pragma once

#include "core/raytrace/render.h"
#include "core/scene/document.h"
#include "figures/figure.h"

namespace seesaw {

/// How a panel's picture is taken.
struct Shot {
  PinholeCamera camera = {};
  double width = 380, height = 380;  ///< of the picture, points
  int samples = 9;                   ///< camera rays a pixel
  double fineness = 1;               ///< pixels, over those that the context asks for: less for costly scenes
  int ambient_rays = 2;
  int max_depth = 4;
};

/// The camera that the document asks for, or else one that frames `scene`.
PinholeCamera camera_for(const Document<3>& document, const Scene& scene, const Framing& framing = {});

/// Takes the picture now, `context.pixels_per_point` pixels a point; the panel keeps it. The camera's flags
/// are among its facts, so that anybody can take the picture again.
Panel studio_panel(const FigureContext& context, const std::string& name, const std::string& title,
                   const Scene& scene, const Shot& shot);

/// A panel that shows `image`.
Panel image_panel(const std::string& name, const std::string& title, const Image& image, double width,
                  double height);

// What figures put into a Scene.

/// A smooth surface.
MeshObject smooth_surface(TriangleMesh mesh, const Color& color);
/// A polygon model: facets as they are, their edges drawn.
MeshObject polygon_model(TriangleMesh mesh, const Color& color);
/// Constraint markers: small spheres of one color, `radius` in scene units.
SpheresObject markers(const Points<3>& at, double radius, const Color& color = surface::marker);

}  // namespace seesaw
