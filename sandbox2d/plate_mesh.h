// The function as a plate in space: z = f(x, y) over the part of the scene that is seen, cut along f = 0.
//
// Turk and O'Brien explain an interpolating function by it (2002, section 4.1): a thin plate that is bent
// through the heights which the constraints ask for, and "each boundary constraint acts much like a see-saw".
// What makes that visible is the zero plane, and what makes the zero plane visible is that land above it is
// orange, land below it blue, and that the two meet in the curve itself and not in the teeth of a grid.
//
// So each triangle of a grid is cut where f passes a *level*: 0, and +-limit, beyond which the plate is cut
// flat (far outside, f grows without end, and what is to be seen would be a thin line at the foot of a
// tower). Vertices on a cut lie on f = level by core/contour/roots.h, not by the grid's straight lines.
// Values of exactly zero at corners of the grid are the normal case, since constraints love round numbers:
// such a corner is a vertex of both sides, and no triangle has both signs.
//
//     const double height = typical_height(field, document, seen);
//     const PlateMesh plate = make_plate(field, seen, {.cells = 64, .height = height});
//
// The vertical scale follows from `height` alone, not from the values of this f: a lecturer who pulls a
// constraint from 1 to 2 wants to see the plate rise. Whoever keeps `height` keeps the scale; plate.h says
// for how long.
//
// Before it: a Field and a box of the scene.  After it: plate_parts.h (poles and profile), plate.h draws.
#pragma once

#include <vector>

#include "core/image/color.h"
#include "core/implicit/field.h"
#include "core/mesh/triangle_mesh.h"
#include "core/scene/document.h"

namespace seesaw {

/// From the scene and a value to view units: the box's longest side is 2 long, its middle is the origin, the
/// zero plane is z = 0.
struct PlateSpace {
  Point<2> center = Point<2>::Zero();  ///< of the box, scene units
  double scale = 1;                    ///< view units a scene unit
  double z_scale = 1;                  ///< view units a unit of f
  double limit = infinity;             ///< of |f|; beyond it the plate is cut flat

  Point<3> at(const Point<2>& p, double f) const {
    const double cut = f > limit ? limit : f < -limit ? -limit : f;
    return {scale * (p.x() - center.x()), scale * (p.y() - center.y()), z_scale * cut};
  }
};

struct PlateOptions {
  int cells = 64;        ///< along the longest side of the box, at least 1; as square as the box allows
  int lines_every = 8;   ///< cells from one line of the grid drawn on the plate to the next; 0 for none
  double height = 1;     ///< > 0; a value of f that is drawn ...
  double relief = 0.29;  ///< ... so many view units high
  double headroom = 3;   ///< the plate is cut flat at so many `height`s
};

struct PlateMesh {
  PlateSpace space;
  /// With normals of length 1 that point up. Each side of a cut has vertices of its own.
  TriangleMesh mesh;
  std::vector<Color> colors;  ///< one a vertex: orange above zero, blue below
  Points<3> grid;             ///< 3 x 2N, ends of segments, on edges of the mesh
  std::vector<Color> grid_colors;
  Points<3> zero;                  ///< 3 x 2N: the curve f = 0 as segments, z = 0, on edges of the mesh
  double lowest = 0, highest = 0;  ///< z of the mesh, view units
  Index nonfinite = 0;             ///< corners where f is no number; the plate has holes there
};

/// A height that shows what f does among the constraints that are seen: the largest value that an interior or
/// exterior constraint asks for, or that is exceeded on only a tenth of the box around the constraints,
/// whichever is more. Always > 0.
double typical_height(const Field<2>& field, const Document<2>& document, const Box<2>& seen);

/// The plate over `box`, which has width and height. Throws Error where it has not, or options make no sense.
PlateMesh make_plate(const Field<2>& field, const Box<2>& box, const PlateOptions& options = {});

/// The color of land of that value, above zero for `side` > 0. It shows its side right from the shore on, and
/// is full a little before the plate is cut.
Color plate_color(double value, double limit, int side);

}  // namespace seesaw
