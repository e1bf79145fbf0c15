#include "core/scene/document_picture.h"

#include <algorithm>

namespace seesaw {

Canvas sheet_for(const Box<2>& box, double size) {
  const double longest = std::max(box.sizes().maxCoeff(), 1e-300);
  const auto side = [&](double length) { return size * std::max(length / longest, 0.2); };
  return {side(box.sizes().x()), side(box.sizes().y())};
}

Canvas picture_of(Document<2> document, const Field<2>& function, double size,
                  const PictureOptions& options) {
  // Found once, for the sheet and for the drawing: it takes a contour.
  document.display.view = view_box(document, function);
  Canvas canvas = sheet_for(*document.display.view, size);
  draw_document(canvas, canvas.bounds(), document, function, options);
  return canvas;
}

}  // namespace seesaw
