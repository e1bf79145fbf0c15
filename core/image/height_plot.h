// A function of the plane as a landscape: z = f(x, y), the sheet z = 0 that cuts it, and the curve where
// they meet.
//
// This is the picture that explains an implicit curve. Where the land stands above the sheet the function
// is positive, inside (orange); where it lies below, outside (blue); the shore is the curve. Constraints
// are poles from the sheet to the height they ask for, and the surface touches every head.
//
// How near things hide far ones, without a depth buffer, so that the picture stays vector graphics: seen
// from above, everything under the sheet lies behind the sheet, and everything over it in front. So each
// facet is cut at z = 0, and is painted in this order: what is below, from the back to the front; the
// sheet; what is above, likewise. For a grid, back to front is simply the order of its rows and columns.
// Curves and poles ask instead whether a ray from them to the camera meets the land (height_projection.h):
// hidden parts of poles are drawn faint and dashed.
//
// Before it: a matrix of heights, e.g. a Field evaluated on a grid. After it: lecture figures.
#pragma once

#include <optional>
#include <vector>

#include "core/image/canvas.h"
#include "core/image/height_projection.h"
#include "core/image/symbols.h"

namespace seesaw {

/// A constraint: a pole from (x, y, 0) to (x, y, z), with a symbol at its top.
struct Pole {
  Point<3> top = {0, 0, 0};
  Symbol head = Symbol::circle;
  Color color = theme::constraint;
  double size = 8;  ///< of the head, points
};

struct HeightPlot {
  /// What to show. Facets beside heights that are not numbers are left out.
  HeightField field;
  double azimuth = -62;   ///< of the camera, degrees counterclockwise from +x; -90 looks along +y
  double elevation = 32;  ///< of the camera above the ground, degrees, kept within 2 .. 90
  double relief = 0.34;   ///< the z range is drawn as high as this fraction of the longer ground side ...
  std::optional<double> exaggeration = {};  ///< ... unless this says by what to multiply z
  std::optional<double> color_range = {};   ///< |z| of the full colors; by default the largest |z|
  bool zero_plane = true;
  /// Curves f = 0 as polylines on the ground, 2 x N, scene units.
  std::vector<Points<2>> zero_curves = {};
  std::vector<Pole> poles = {};
  Index mesh_every = 0;      ///< cells between two mesh lines; 0 for none
  double curve_width = 2.4;  ///< points
};

/// How `plot` is projected into `region` (points). Throws Error when the grid has fewer than 2 x 2 points,
/// the ground is empty, or there is no height that is a number.
HeightProjection project(const HeightPlot& plot, const Rect& region);

/// Draws it and returns the same projection, for labels at scene points.
HeightProjection draw_height_plot(Canvas& canvas, const Rect& region, const HeightPlot& plot);

}  // namespace seesaw
