#include "core/scene/plan_view.h"

#include <algorithm>

#include "core/scene/picture.h"

namespace seesaw {

PlanView plan_view(const Box<2>& scene, const Rect& page) {
  // A scene of no width or height still has a scale.
  const Point<2> size = scene.sizes().cwiseMax(1e-300);
  const double scale = std::min(page.width / size.x(), page.height / size.y());
  const Point<2> half = Point<2>(page.width, page.height) / (2 * scale);
  return {page, Box<2>(scene.center() - half, scene.center() + half), scale};
}

Box<2> view_box(const Document<2>& document, const Field<2>& field) {
  if (document.display.view) return *document.display.view;
  // First the constraints, then as much of the curve as lies near them: a curve may well run off to infinity.
  Box<2> box;
  for (const auto& each : document.constraints) box.extend(each.constraint.at);
  // Hundreds of constraints say themselves where the curve is; following it at each would keep a window
  // waiting.
  constexpr std::size_t many = 300;
  const Contour curve = document.constraints.size() <= many
                            ? contour(document, field, field.bounding_box(), {.cells = 64})
                            : contour(field, field.bounding_box(), {.cells = 64, .find_hidden = false});
  for (const Polyline& polyline : curve.polylines)
    if (polyline.closed) box.extend(bounding_box(polyline));
  return grown(box, 0.12);
}

}  // namespace seesaw
