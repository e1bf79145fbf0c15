// From a scene with height, (x, y, z), to the page, as seen from far away: an orthographic view.
//
// The camera stands in the direction (cos a cos e, sin a cos e, sin e), azimuth a counterclockwise from +x
// and elevation e above the ground, and looks at the middle. There is no perspective: parallel lines stay
// parallel, lengths along one axis can be measured with a ruler, and z is always straight up on the page.
//
// Before it: heights over a ground rectangle. After it: height_plot.h, and callers that add labels at (x,
// y, z).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/types.h"
#include "core/image/rect.h"

namespace seesaw {

/// Heights on a regular grid over a rectangle: heights(i, j) at x = min.x + i (max.x - min.x) / (rows - 1)
/// and y likewise by j and columns. Both counts are 2 or more.
struct HeightField {
  Eigen::MatrixXd heights;
  Box<2> ground;

  Index nx() const { return heights.rows(); }
  Index ny() const { return heights.cols(); }
  Point<2> ground_point(double i, double j) const;
  /// Bilinear between grid points; NaN outside the ground and beside heights that are not numbers.
  double height_at(const Point<2>& ground_point) const;
};

class HeightProjection {
 public:
  HeightProjection() = default;
  /// Fits all of `scene` (3 x N, at least two different points) into `region`, centered. Angles in degrees;
  /// elevation is kept within 2 .. 90. `exaggeration` multiplies z.
  HeightProjection(const Rect& region, const PointsRef<3>& scene, double azimuth, double elevation,
                   double exaggeration);

  /// The place on the page, points, of a scene point (x, y, z), z not yet exaggerated.
  Point<2> pixel_from_scene(const Point<3>& scene) const;
  /// Unit vectors in scene directions with z exaggerated: to the right on the page, up on the page, to the
  /// camera.
  const Point<3>& right() const { return right_; }
  const Point<3>& up() const { return up_; }
  const Point<3>& toward() const { return toward_; }
  /// Points on the page per unit of the scene.
  double scale() const { return scale_; }
  double exaggeration() const { return exaggeration_; }

  /// Whether the surface leaves the point in sight. A point up to `slack` scene units (z exaggerated) under
  /// the surface counts as on it.
  bool sees(const Point<3>& scene, const HeightField& field, double slack) const;

 private:
  Point<3> right_ = Point<3>::UnitX(), up_ = Point<3>::UnitY(), toward_ = Point<3>::UnitZ();
  Point<2> origin_ = Point<2>::Zero();
  double scale_ = 1, exaggeration_ = 1;
};

}  // namespace seesaw
