// Lights: from far away or from a place, sharp or soft.
//
// A light with a size throws soft shadows: each sample of a pixel looks at another place of the light, by a
// fixed pattern, so that a picture is the same each time.
//
// Before it: nothing. After it: scene.h; render.h.
#pragma once

#include <vector>

#include "core/base/types.h"
#include "core/image/color.h"
#include "core/raytrace/camera.h"

namespace seesaw {

struct Light {
  enum class Kind {
    directional,  ///< far away: the same direction everywhere
    point,        ///< at a place; its light does not fall off with distance, so that intensities stay simple
  };
  Kind kind = Kind::directional;
  /// Toward the light (directional, any length but zero) or its place in scene units (point).
  Point<3> at = {0.4, 1, 0.6};
  Color color = hex("#FFFFFF");
  double intensity = 0.7;  ///< a white surface that faces it reflects this much of what a white pixel shows
  /// The light's radius: in degrees as seen from the scene (directional), in scene units (point). 0 gives
  /// sharp shadows.
  double softness = 0;
  bool shadows = true;
};

/// A key light from the upper left of the camera, soft, and a fill light without shadows from the right: what
/// a scene that names no lights gets. They turn with the camera, so a subject looks alike from all sides.
std::vector<Light> studio_lights(const PinholeCamera& camera);

}  // namespace seesaw
