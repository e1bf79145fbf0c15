// What is in hand, over the picture of the scene: selection, what would be grabbed, the rubber band, points
// about to be placed, the profile line, weights, and the culprits of an impossible set.
//
// It changes with every move of the pointer and costs a fraction of the scene beneath, so it is a canvas of
// its own, without a background.
//
// Before it: core/editing/desk.h, whose view is that of the scene's picture. After it: Raster::paint_over.
#pragma once

#include "core/editing/desk.h"
#include "core/image/canvas.h"

namespace seesaw {

struct OverlayOptions {
  bool weights = false;
  /// Symbols, lines and letters are this many times as large.
  double scale = 1;
  /// The pointer is over the scene, so what is under it is marked.
  bool pointer_here = true;
  /// Constraints that are pointed at (a tour, a list): marked with a pulsing ring's color. Indices.
  std::vector<Index> pointed = {};
};

/// Draws on a canvas of the view's size, one point a logical pixel. Solves where that is still to be done.
void draw_overlay(Canvas& canvas, Desk& desk, const OverlayOptions& options);

/// w_i of eq. 5 for each constraint of the document, in order: of its own row, and of its normal
/// constraint's, 0 for none. Rows that coincide were merged: the first of them has the weight, the others 0.
struct ConstraintWeights {
  std::vector<double> own, normal;
};
/// Empty where there is no function of the present document.
ConstraintWeights constraint_weights(Desk& desk);

}  // namespace seesaw
