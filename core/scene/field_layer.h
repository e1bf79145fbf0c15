// The function behind the curve: its value as color, and curves of equal value with their labels.
//
// Before it: a field and a view.  After it: core/scene/picture.h draws curve and constraints over it.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/image/canvas.h"
#include "core/implicit/field.h"
#include "core/mesh/polyline.h"
#include "core/scene/plan_view.h"

namespace seesaw {

/// f on a regular grid of the view, row 0 at the bottom: values(row, column).
struct SampledField {
  Eigen::MatrixXd values;
  double lowest = 0, highest = 0;  ///< of the finite ones
  double largest() const { return std::max(std::abs(lowest), std::abs(highest)); }
};

/// `columns` samples across the view, at the centers of as many cells; as many rows as make them square.
SampledField sample(const Field<2>& field, const PlanView& view, int columns);

/// How deep a color is for f = value: the square root of |value| / range with value's sign. Inside a shape
/// |f| is often a tenth of what it is outside; a linear scale would leave the inside white.
double color_depth(double value, double range);

/// Fills the view with diverging_color(color_depth(f, range)).
void draw_field_colors(Canvas& canvas, const PlanView& view, const SampledField& sampled, double range);

/// Levels of 1, 2, 5 times a power of ten and their negatives, without zero, that fit between `lowest` and
/// `highest`: at most four inside and five outside, the largest ones, none below a twentieth of the largest.
/// Ascending.
std::vector<double> isoline_levels(double lowest, double highest);

struct IsolineStyle {
  double range = 1.0;                  ///< of the colors beneath
  bool on_colors = false;              ///< whether there are any
  double text_size = 8.5;              ///< points
  std::vector<Point<2>> symbols = {};  ///< page points that a label keeps well away from
  std::vector<Polyline> curves = {};   ///< scene curves that a label does not touch
  int cells = 96;                      ///< as in ContourOptions
  bool find_hidden = true;             ///< likewise
  Index most_vertices = 1'000'000;     ///< ContourOptions::max_refined_vertices
};

/// Draws and labels them.
void draw_isolines(Canvas& canvas, const PlanView& view, const Field<2>& field, const SampledField& sampled,
                   const IsolineStyle& style);

}  // namespace seesaw
