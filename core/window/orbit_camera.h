// The eye that goes around an object: where it stands, what it sees, and what lies under a pixel.
//
// It looks at `target` from `distance`, turned by `azimuth` about the vertical (z, up) and raised by
// `elevation`. Pixels count from the top left of a picture of width x height, x right, y down.
//
//     eye = target + distance (cos e cos a, cos e sin a, sin e)
//
// Before it: the mouse (ui::PictureUse). After it: view_3d.h draws what it sees; ray_through asks a surface.
#pragma once

#include <Eigen/Core>

#include "core/base/types.h"

namespace seesaw {

struct OrbitCamera {
  Point<3> target = Point<3>::Zero();
  double distance = 4;     ///< scene units, > 0
  double azimuth = -1.0;   ///< radians from the x axis, counterclockwise seen from above
  double elevation = 0.5;  ///< radians above the horizon, within (-pi / 2, pi / 2)
  double field = 0.6;      ///< vertical angle of view, radians, within (0, pi)

  Point<3> eye() const;
  /// Unit vectors of the picture: right, up, and from the eye to the target.
  Point<3> right() const;
  Point<3> up() const;
  Point<3> forward() const;

  /// Scene to the camera's coordinates: x right, y up, z toward the viewer, the eye at 0.
  Eigen::Matrix4d camera_from_scene() const;
  /// OpenGL's clip coordinates of those; near and far are a hundredth and a hundred distances.
  Eigen::Matrix4d clip_from_camera(int width, int height) const;

  /// The pixel where a point of the scene is seen, and its distance in front of the eye, which is not
  /// positive where it is not seen.
  Point<3> pixel_of(const Point<3>& point, int width, int height) const;
  /// The unit direction from the eye through a pixel's coordinates.
  Point<3> ray_through(const Point<2>& pixel, int width, int height) const;

  /// A drag by so many pixels turns the object with the hand: half a turn across a picture of that height.
  void orbit(double dx, double dy, int height);
  /// A drag by so many pixels takes the target along with the hand.
  void pan(double dx, double dy, int height);
  /// So many notches of the wheel, nearer for positive ones.
  void zoom(double notches);
  /// Stands back, in the same direction, so that a ball of that size is seen as a whole.
  void frame(const Point<3>& center, double radius, int width, int height);
};

}  // namespace seesaw
