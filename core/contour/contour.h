// From a field to the curve f = 0: all of it that lies in a box, as polylines with inside on the left.
//
// Before it: any Field<2>, and the boundary constraints it was asked to pass through ("seeds").
// After it: core/mesh/polyline.h to measure with; core/image to draw.
//
// How it works, one file a step:
//   lattice.h        the box is a lattice of square cells; f is evaluated at all corners
//   triangulation.h  cells are two triangles each, which can be bisected without ever leaving a gap
//   roots.h          where an edge's ends differ in sign, f = 0 on it: found to rounding, all edges at once
//   crossings.h      a triangle has either no crossing, or exactly one way through
//   seeds.h          is the curve that is seen the curve through the constraints?
//   refine.h         bisects where the curve turns too much, and where a seed says that the curve is not the
//                    one seen: a tiny loop between the corners, two sheets closer than a cell
//   hidden.h         a corner higher than all its neighbors but still outside may stand beside a small
//                    component: climbs and looks
//   trace.h          walks from triangle to triangle
//
// The sign rule. T&O interpolants are exactly zero at their constraints, and constraints love lattice
// corners, so f == 0 at a corner is the normal case. One rule holds everywhere: f >= 0 is inside (-0.0 too),
// everything else is outside, also what is not a finite number. The triangles fit together without gaps, so
// whatever the values are, every polyline closes or ends on the box. A crossing whose inside end is exactly
// zero lies exactly at that end; pieces of curve with nothing inside them (f touches zero from below, in a
// point or along a line) are dropped.
//
// What is promised: every vertex lies on the zero set as well as doubles can say, |f| / |grad f| <= 1e-12 of
// the box; the curve passes exactly through every seed where it has one direction, at any resolution. What is
// not: a component through no seed, smaller than a cell, whose presence no lattice corner feels, stays unseen.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/implicit/field.h"
#include "core/mesh/polyline.h"

namespace seesaw {

struct ContourOptions {
  /// Cells of the lattice along the box's longest side, 1 to 8192; cells are as square as the box allows.
  int cells = 128;
  /// The curve f = level is drawn, with f >= level inside.
  double level = 0.0;
  /// The curve's normal turns by no more than this from one vertex to the next, in radians, unless that would
  /// take triangles smaller than the cells of a lattice of `finest_cells`. At a corner of the curve it always
  /// would. Loops that need smaller triangles to be seen at all are refined as far below their own size.
  double angle_tolerance = 0.175;
  int finest_cells = 2048;
  /// Climb from lattice corners to components that the lattice does not see.
  bool find_hidden = true;
  /// Refinement stops at this many vertices beyond the lattice's, with Contour::complete = false: the curve
  /// is then coarser than asked for, but still closed or ended on the box. For fields that vary wildly
  /// everywhere.
  Index max_refined_vertices = 1'000'000;
};

/// Where the time went, in seconds.
struct ContourTimes {
  double lattice = 0, hidden = 0, refine = 0, trace = 0;
};

struct Contour {
  /// Each closed, or open with both ends exactly on the box. Inside on the left.
  std::vector<Polyline> polylines;

  // Facts about them.
  Index components = 0;  ///< number of polylines
  Index closed = 0;      ///< how many of them are closed
  Index vertices = 0;    ///< of all polylines together
  double length = 0;     ///< of all polylines together, in scene units
  double area = 0;       ///< of the part of the box that is inside (holes subtracted), in squared scene units

  // What became of the seeds; on_curve + outside_box + off_curve + lost is their number.
  Index seeds_on_curve = 0;     ///< a vertex of some polyline, exactly
  Index seeds_outside_box = 0;  ///< not looked for
  Index seeds_off_curve = 0;    ///< no curve there to be on: f is not zero, or its zero there is a mere point
  Index seeds_lost = 0;         ///< a curve passes there and is not in `polylines`: 0 whenever `complete`

  // What it took.
  Index evaluations = 0;           ///< points at which the field was evaluated
  Index gradient_evaluations = 0;  ///< how many of them with their gradient
  Index nonfinite = 0;             ///< evaluations that gave no finite number; they count as outside
  bool complete = true;            ///< false when max_refined_vertices stopped the refinement
  ContourTimes times;
};

/// The curve f = options.level in `box`. `seeds` is 2 x N: points known to be on the curve, the boundary
/// constraints; a seed on which f is not quite `level` is moved along the gradient until it is, if that is
/// near. The result does not depend on the number of threads. An empty box, or one without width or height,
/// or without bounds, has no curve. Throws Cancelled.
Contour contour(const Field<2>& field, const Box<2>& box, const PointsRef<2>& seeds,
                const ContourOptions& options = {}, const Progress& progress = {});

/// Without seeds.
Contour contour(const Field<2>& field, const Box<2>& box, const ContourOptions& options = {},
                const Progress& progress = {});

/// One contour a level, in the order of `levels` (options.level is not looked at). The lattice is evaluated
/// once for all of them, which is nearly all of the cost.
std::vector<Contour> isolines(const Field<2>& field, const Box<2>& box, const std::vector<double>& levels,
                              const ContourOptions& options = {}, const Progress& progress = {});

}  // namespace seesaw
