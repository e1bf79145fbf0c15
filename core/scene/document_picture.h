// A 2D document as a whole sheet: its own proportions, nothing around it. What `figures render`, `seesaw
// contour` and the editor's export write, so that the three agree to the byte.
//
// Before it: a document and its function.  After it: a file by Canvas::save.
//
//     picture_of(document, fit(document).function).save("fig01.svg");
#pragma once

#include "core/scene/picture.h"

namespace seesaw {

/// The longer side of a sheet where nobody says otherwise, points.
inline constexpr double usual_picture_size = 480;

/// A sheet in the proportions of the box, its longer side `size` points. Where the box is a sliver the other
/// side is a fifth of that, and a picture shows more around it.
Canvas sheet_for(const Box<2>& box, double size = usual_picture_size);

/// The part of the scene that view_box(document, function) names, as document.display says.
Canvas picture_of(Document<2> document, const Field<2>& function, double size = usual_picture_size,
                  const PictureOptions& options = {});

}  // namespace seesaw
