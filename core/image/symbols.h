// The papers' marks for constraints: an open circle where the shape must pass, a plus sign inside it, a
// minus sign outside, a spike for a normal.
//
// Each has a thin rim of paper around it, so that it stays legible on any field color and across any curve.
//
// Before it: canvas.h, and a place on the page. After it: every picture of constraints.
#pragma once

#include "core/image/canvas.h"

namespace seesaw {

enum class Symbol {
  circle,  ///< boundary constraint: open, filled with paper
  plus,    ///< interior constraint, f > 0
  minus,   ///< exterior constraint, f < 0
};

/// Draws `symbol` centered at `at`; `size` is its width without the rim, points. Nothing for size <= 0.
void draw_symbol(Canvas& canvas, Symbol symbol, const Point<2>& at, double size = 8,
                 const Color& color = theme::constraint);

/// A line of `length` points from `from` in `direction` (page coordinates, y down, any length but zero)
/// with a small head: a normal constraint's spike. Nothing for a zero direction.
void draw_spike(Canvas& canvas, const Point<2>& from, const Point<2>& direction, double length = 16,
                const Color& color = theme::constraint);

}  // namespace seesaw
