#include "core/raytrace/light.h"

namespace seesaw {

std::vector<Light> studio_lights(const PinholeCamera& camera) {
  const CameraAxes axes = axes_of(camera);
  const Point<3> up = camera.up.norm() > 0 ? Point<3>(camera.up.normalized()) : axes.up;
  Light key, fill;
  // Heights are measured along the scene's up, so that a floor is lit however far the camera looks down.
  key.at = -0.55 * axes.right + 1.15 * up - 0.5 * axes.forward;
  key.intensity = 0.74;
  key.softness = 7;
  fill.at = 0.9 * axes.right + 0.35 * up - 0.7 * axes.forward;
  fill.intensity = 0.16;
  fill.color = hex("#F2F6FF");
  fill.shadows = false;
  return {key, fill};
}

}  // namespace seesaw
