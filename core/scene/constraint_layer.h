// The constraints of a document as the papers draw them: open circles, plus and minus signs, spikes.
//
// Before it: a document and a view.  After it: nothing; it is the topmost layer of core/scene/picture.h.
#pragma once

#include "core/image/canvas.h"
#include "core/image/symbols.h"
#include "core/scene/document.h"
#include "core/scene/plan_view.h"

namespace seesaw {

struct PictureOptions;

/// The papers': an open circle for boundary, plus for interior, minus for exterior constraints.
Symbol symbol_of(ConstraintKind kind);

/// Draws what the display's `constraints` and `normals` ask for, red where highlighted, with labels.
void draw_constraints(Canvas& canvas, const PlanView& view, const Document<2>& document,
                      const PictureOptions& options);

/// Where the symbols stand on the page; of hundreds that crowd together some stand for the others.
std::vector<Point<2>> symbol_places(const PlanView& view, const Document<2>& document);

}  // namespace seesaw
