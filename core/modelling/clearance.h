// How far apart are two solids that do not overlap, and where do they come nearest?
//
// Before it: interference.h, which says that they do not overlap.  After it: a designer, or a figure.
//
// The clearance is the smallest distance between a point where f_A = 0 and one where f_B = 0. Two halves:
//
//   from below   boxes proven free of a surface (|f(m)| > R sup |grad f|) are thrown away, the others halved
//                in each direction. The smallest distance between a box of A's and one of B's is a proven
//                lower bound of the clearance. Boxes that are farther from all of the other's than a pair of
//                points already found is, are thrown away too: soon only those around the nearest points are
//                left.
//   from above   from the nearest pairs of boxes two points are walked onto the surfaces, and then slide
//                along them toward each other until the segment between them is normal to both. Every such
//                pair is an upper bound, and after the slide usually the clearance to rounding.
//
// So [low, distance] holds the true clearance; how wide that is, is up to `width` and the work allowed.
#pragma once

#include "core/base/progress.h"
#include "core/implicit/field.h"

namespace seesaw {

struct ClearanceOptions {
  /// Stop when distance - low is at most this fraction of the longest side of the box around both.
  double width = 0.01;
  /// Stop at this many boxes of one generation, of both surfaces together.
  Index boxes = 200'000;
};

struct Clearance {
  /// Between `on_a` and `on_b`, scene units; infinite where one of them has no surface in its bounding box.
  double distance = 0;
  /// The true clearance, within the bounding boxes, is proven not to be smaller.
  double low = 0;
  Point<3> on_a = Point<3>::Zero();  ///< f_A = 0
  Point<3> on_b = Point<3>::Zero();  ///< f_B = 0
};

/// The clearance of the two surfaces; of solids that overlap, or where one is within the other, it is the
/// distance between the surfaces all the same (0 where they cross). Throws Cancelled. The same result for any
/// number of threads.
Clearance clearance(const Field<3>& a, const Field<3>& b, const ClearanceOptions& options = {},
                    const Progress& progress = {});

}  // namespace seesaw
