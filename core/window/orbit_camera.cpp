#include "core/window/orbit_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace seesaw {

namespace {
constexpr double steepest = 0.499 * std::numbers::pi;
constexpr double zoom_of_a_notch = 1.15;
}  // namespace

Point<3> OrbitCamera::forward() const {
  return {-std::cos(elevation) * std::cos(azimuth), -std::cos(elevation) * std::sin(azimuth),
          -std::sin(elevation)};
}
Point<3> OrbitCamera::right() const { return {-std::sin(azimuth), std::cos(azimuth), 0}; }
Point<3> OrbitCamera::up() const { return right().cross(forward()); }
Point<3> OrbitCamera::eye() const { return target - distance * forward(); }

Eigen::Matrix4d OrbitCamera::camera_from_scene() const {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.block<1, 3>(0, 0) = right().transpose();
  m.block<1, 3>(1, 0) = up().transpose();
  m.block<1, 3>(2, 0) = -forward().transpose();
  for (int i = 0; i < 3; ++i) m(i, 3) = -m.block<1, 3>(i, 0).dot(eye());
  return m;
}

Eigen::Matrix4d OrbitCamera::clip_from_camera(int width, int height) const {
  const double near_plane = distance / 100, far_plane = distance * 100, f = 1 / std::tan(field / 2);
  Eigen::Matrix4d m = Eigen::Matrix4d::Zero();
  m(0, 0) = f * height / width;
  m(1, 1) = f;
  m(2, 2) = (far_plane + near_plane) / (near_plane - far_plane);
  m(2, 3) = 2 * far_plane * near_plane / (near_plane - far_plane);
  m(3, 2) = -1;
  return m;
}

Point<3> OrbitCamera::pixel_of(const Point<3>& point, int width, int height) const {
  const Point<3> from_eye = point - eye();
  const double depth = from_eye.dot(forward()), scale = height / (2 * std::tan(field / 2)) / depth;
  return {width / 2.0 + scale * from_eye.dot(right()), height / 2.0 - scale * from_eye.dot(up()), depth};
}

Point<3> OrbitCamera::ray_through(const Point<2>& pixel, int width, int height) const {
  const double scale = 2 * std::tan(field / 2) / height;
  return (forward() + scale * (pixel.x() - width / 2.0) * right() - scale * (pixel.y() - height / 2.0) * up())
      .normalized();
}

void OrbitCamera::orbit(double dx, double dy, int height) {
  const double angle = std::numbers::pi / std::max(1, height);
  azimuth = std::remainder(azimuth - angle * dx, 2 * std::numbers::pi);
  elevation = std::clamp(elevation + angle * dy, -steepest, steepest);
}

void OrbitCamera::pan(double dx, double dy, int height) {
  const double scale = 2 * std::tan(field / 2) * distance / std::max(1, height);
  target += scale * (dy * up() - dx * right());
}

void OrbitCamera::zoom(double notches) { distance *= std::pow(zoom_of_a_notch, -notches); }

void OrbitCamera::frame(const Point<3>& center, double radius, int width, int height) {
  target = center;
  const double narrower = std::atan(std::tan(field / 2) * std::min(1.0, static_cast<double>(width) / height));
  distance = std::max(radius, 1e-300) / std::sin(narrower);
}

}  // namespace seesaw
