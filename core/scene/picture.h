// A 2D document as a picture: field, isolines, curve, constraints, scale bar. The figures, the command line
// and the editor all draw with this, so they look alike.
//
// Before it: a document (core/scene/document.h) and the function fitted to it.  After it:
// core/image/canvas.h.
//
//     const Document<2> document = read_document<2>("figures/scenes/turk2002-fig01-left.json");
//     const Fit<2> fitted = fit(document);
//     Canvas canvas(400, 400);
//     draw_document(canvas, canvas.bounds(), document, fitted.function);
//     canvas.save("fig01.svg");
#pragma once

#include <string>
#include <vector>

#include "core/contour/contour.h"
#include "core/image/canvas.h"
#include "core/rbf/fit.h"
#include "core/scene/document.h"
#include "core/scene/plan_view.h"

namespace seesaw {

/// The function of a document: its constraints under its kernel and smoothing. Throws ConstraintError.
template <int Dim>
Fit<Dim> fit(const Document<Dim>& document) {
  return fit(constraints_of(document), {.kernel = document.kernel, .smoothing = document.smoothing});
}

/// The curve of a document in `box`, seeded at its boundary constraints.
Contour contour(const Document<2>& document, const Field<2>& field, const Box<2>& box,
                const ContourOptions& options = {});

/// How finely a picture is computed. The defaults are a printed page's; an editor that draws thirty pictures
/// a second makes do with less while something moves.
struct PictureDetail {
  int curve_cells = 128;        ///< ContourOptions::cells of the curve
  int isoline_cells = 96;       ///< of isolines
  double field_samples = 1.0;   ///< of the field's colors, along a point of the page
  Index most_vertices = 1'000'000;  ///< ContourOptions::max_refined_vertices: of a field that is noise
  bool every_component = true;  ///< looks for the curve at every boundary constraint, and for hidden pieces
};

struct PictureOptions {
  /// Curves drawn dashed beneath: a shape before it was changed.
  std::vector<Polyline> ghosts = {};
  /// Tints what is inside, where the field's colors are not shown.
  bool tint_inside = true;
  double symbol_size = 9.0;    ///< of constraints, points; below 7 circles are dots
  double curve_width = 2.2;    ///< points
  double spike_length = 26.0;  ///< of normals, points
  double text_size = 8.5;      ///< of isoline labels and scale bar, points
  /// Colors reach their full depth at this |f|; 0 for the largest |f| in view.
  double color_range = 0.0;
  PictureDetail detail = {};
};

/// What was drawn, for whoever adds to it or measures it.
struct DrawnPicture {
  PlanView view;
  Contour curve;  ///< in view.scene
};

/// Draws the document in `region`, as document.display says. `field` is its function.
DrawnPicture draw_document(Canvas& canvas, const Rect& region, const Document<2>& document,
                           const Field<2>& field, const PictureOptions& options = {});

/// The same where there is no function yet: grid, constraints, scale bar.
PlanView draw_plain_document(Canvas& canvas, const Rect& region, const Document<2>& document,
                             const PictureOptions& options = {});

}  // namespace seesaw
