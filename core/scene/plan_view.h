// Which part of a 2D scene a picture shows, and where on the page each scene point lies.
//
// Before it: a document and the region of the page that its picture has.  After it: core/scene/picture.h.
#pragma once

#include "core/image/rect.h"
#include "core/implicit/field.h"
#include "core/scene/document.h"

namespace seesaw {

/// A map between scene and page: equal scales along x and y, y up in the scene and down on the page.
struct PlanView {
  Rect page;           ///< points; where the picture is drawn
  Box<2> scene;        ///< what it shows, scene units: as wide and high as `page` allows
  double scale = 1.0;  ///< points per scene unit

  Point<2> page_from_scene(const Point<2>& p) const {
    return {page.left() + (p.x() - scene.min().x()) * scale,
            page.bottom() - (p.y() - scene.min().y()) * scale};
  }
  Point<2> scene_from_page(const Point<2>& p) const {
    return {scene.min().x() + (p.x() - page.left()) / scale,
            scene.min().y() + (page.bottom() - p.y()) / scale};
  }
  Points<2> page_from_scene(const Points<2>& points) const {
    Points<2> result(2, points.cols());
    for (Index i = 0; i < points.cols(); ++i) result.col(i) = page_from_scene(Point<2>(points.col(i)));
    return result;
  }
};

/// The view that shows all of `scene` (not empty), centered in `page`, and as much around it as fits.
PlanView plan_view(const Box<2>& scene, const Rect& page);

/// What to show of the document: its own display.view, or else the constraints and the curve through them
/// with some room around.
Box<2> view_box(const Document<2>& document, const Field<2>& field);

}  // namespace seesaw
