#include "core/raytrace/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/check.h"
#include "core/base/text.h"

namespace seesaw {

namespace {

double half_height_of(const PinholeCamera& camera) {
  return std::tan(camera.field_of_view * std::numbers::pi / 360);
}

// Digits that give back the same pixels: a part in 1e9 is far less than a pixel in any picture.
constexpr int flag_digits = 9;

std::string triple(const Point<3>& p) {
  return to_text(p.x(), flag_digits) + "," + to_text(p.y(), flag_digits) + "," + to_text(p.z(), flag_digits);
}

}  // namespace

CameraAxes axes_of(const PinholeCamera& camera) {
  CameraAxes axes;
  axes.forward = camera.target - camera.eye;
  const double distance = axes.forward.norm();
  axes.forward = distance > 0 ? Point<3>(axes.forward / distance) : Point<3>(-Point<3>::UnitZ());
  Point<3> right = axes.forward.cross(camera.up);
  if (!(right.norm() > 1e-9 * camera.up.norm())) {
    // Looking along `up`: any direction across the view will do, and this choice is always the same.
    Index least = 0;
    axes.forward.cwiseAbs().minCoeff(&least);
    right = axes.forward.cross(Point<3>::Unit(least));
  }
  axes.right = right.normalized();
  axes.up = axes.right.cross(axes.forward);
  return axes;
}

Ray ray_through(const PinholeCamera& camera, double x, double y, double aspect) {
  const CameraAxes axes = axes_of(camera);
  const double height = 2 * half_height_of(camera);
  Ray ray;
  ray.origin = camera.eye;
  ray.direction =
      (axes.forward + (x - aspect / 2) * height * axes.right + (0.5 - y) * height * axes.up).normalized();
  return ray;
}

Point<2> picture_place(const PinholeCamera& camera, const Point<3>& point, double aspect) {
  const CameraAxes axes = axes_of(camera);
  const Point<3> seen = point - camera.eye;
  const double depth = seen.dot(axes.forward);
  if (!(depth > 0)) return Point<2>::Constant(std::numeric_limits<double>::quiet_NaN());
  const double height = 2 * half_height_of(camera);
  return {aspect / 2 + seen.dot(axes.right) / (depth * height), 0.5 - seen.dot(axes.up) / (depth * height)};
}

PinholeCamera frame(const PointsRef<3>& subject, const Framing& framing) {
  SEESAW_CHECK_LT(0, subject.cols());
  PinholeCamera camera;
  camera.up = framing.up;
  camera.field_of_view = framing.field_of_view;
  const Point<3> middle = 0.5 * (subject.rowwise().minCoeff() + subject.rowwise().maxCoeff());
  camera.target = middle;
  camera.eye = middle + framing.direction;
  const CameraAxes axes = axes_of(camera);

  // In coordinates (x, y, z) along right, up and forward about the middle, the border on the right is
  // x - e_x = s (z - e_z) for an eye e and slope s, and the points must not be beyond it:
  //     e_x - s e_z >= a = max(x - s z)      and on the left     -e_x - s e_z >= b = max(-x - s z).
  // So e_z <= -(a + b) / 2s, with equality for e_x = (a - b) / 2; likewise for y.
  const double inner = 1 - 2 * std::clamp(framing.margin, 0.0, 0.45);
  const double slope_y = inner * half_height_of(camera), slope_x = slope_y * framing.aspect;
  constexpr double none = -infinity;
  double right = none, left = none, top = none, bottom = none, nearest = -none, size = 0;
  for (Index i = 0; i < subject.cols(); ++i) {
    const Point<3> p = subject.col(i) - middle;
    const double x = p.dot(axes.right), y = p.dot(axes.up), z = p.dot(axes.forward);
    right = std::max(right, x - slope_x * z);
    left = std::max(left, -x - slope_x * z);
    top = std::max(top, y - slope_y * z);
    bottom = std::max(bottom, -y - slope_y * z);
    nearest = std::min(nearest, z);
    size = std::max(size, p.norm());
  }
  // A single point is seen from a unit's distance; no subject touches the eye.
  const double least_distance = size > 0 ? 1e-3 * size : 1.0;
  const double z =
      std::min({-(right + left) / (2 * slope_x), -(top + bottom) / (2 * slope_y), nearest - least_distance});
  camera.eye = middle + (right - left) / 2 * axes.right + (top - bottom) / 2 * axes.up + z * axes.forward;
  camera.target = camera.eye - z * axes.forward;
  return camera;
}

PinholeCamera frame(const Box<3>& subject, const Framing& framing) {
  SEESAW_CHECK_EQ(subject.isEmpty(), false);
  Points<3> corners(3, 8);
  for (int i = 0; i < 8; ++i) corners.col(i) = subject.corner(static_cast<Box<3>::CornerType>(i));
  return frame(corners, framing);
}

std::string to_flags(const PinholeCamera& camera) {
  return "--eye " + triple(camera.eye) + " --target " + triple(camera.target) + " --up " + triple(camera.up) +
         " --fov " + to_text(camera.field_of_view, flag_digits);
}

}  // namespace seesaw
