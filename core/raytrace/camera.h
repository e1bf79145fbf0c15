// Where a picture is taken from: a pinhole camera in scene coordinates.
//
// It frames its subject by itself. Seen from a fixed direction the picture's four borders are planes whose
// slopes are known; pushing each against the subject gives four linear inequalities for the eye, and the
// nearest eye that meets them all touches the subject on both sides of the tighter axis and is centered on
// the other (`frame`). So a subject fills its picture whatever its shape, and no number has to be tuned.
//
// Before it: what is to be seen. After it: render.h; the command line, which reads and prints its flags.
#pragma once

#include <string>

#include "core/base/types.h"
#include "core/raytrace/ray.h"

namespace seesaw {

/// Scene units and directions; neither y nor z is up unless `up` says so.
struct PinholeCamera {
  Point<3> eye = {0, 0, 3};
  Point<3> target = {0, 0, 0};
  Point<3> up = Point<3>::UnitY();  ///< any length; need not be at right angles to the view
  double field_of_view = 30;        ///< degrees from the picture's bottom to its top, 0 < .. < 180
};

/// Unit vectors of the picture in the scene: right-handed, `forward` from the eye to the target.
struct CameraAxes {
  Point<3> right, up, forward;
};

/// Any `up` gives axes, one along the view too; eye == target looks along -z.
CameraAxes axes_of(const PinholeCamera& camera);

/// The ray through (x, y) of the picture, which is `aspect` wide and 1 high: x from 0 at the left to
/// `aspect`, y from 0 at the top to 1.
Ray ray_through(const PinholeCamera& camera, double x, double y, double aspect);

/// Where the point stands in the picture, as `ray_through` has x and y; nothing is known for points behind
/// the eye (NaN).
Point<2> picture_place(const PinholeCamera& camera, const Point<3>& point, double aspect);

/// How a subject is framed.
struct Framing {
  /// From the subject to the eye; any length but zero.
  Point<3> direction = {0.6, 0.45, 1};
  Point<3> up = Point<3>::UnitY();
  double field_of_view = 28;  ///< degrees, vertical
  double aspect = 1;          ///< width over height of the picture
  double margin = 0.06;       ///< left free on each side, as a fraction of the picture's side, 0 .. 0.45
};

/// The nearest camera that sees all of `subject`'s points (3 x N, N > 0), centered.
PinholeCamera frame(const PointsRef<3>& subject, const Framing& framing = {});
/// As above for the eight corners of a box, which must not be empty.
PinholeCamera frame(const Box<3>& subject, const Framing& framing = {});

/// "--eye 1,2,3 --target 0,0,0 --up 0,1,0 --fov 28", with digits enough to give the same picture again.
std::string to_flags(const PinholeCamera& camera);

}  // namespace seesaw
