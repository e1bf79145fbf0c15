// A scene to an image.
//
// Light is added up as amounts of light and converted to sRGB once, at the end. A surface gets
//     color * (ambient * openness + sum over lights of intensity * cosine * visibility) + highlights,
// where openness is the part of the sky above the point that near surfaces leave free, and visibility the
// part of a light that is seen; both by rays that follow a fixed pattern. What is brighter than white bends
// softly toward it. A mirror mixes in what the reflected ray sees.
//
// Rays of a tile go together, wave by wave: all its camera rays, then all their shadow rays, then all
// reflections; so that a Field is asked for many points at once. The picture does not depend on the number of
// threads.
//
// Before it: scene.h, camera.h. After it: core/image, a PNG.
#pragma once

#include "core/base/progress.h"
#include "core/image/image.h"
#include "core/raytrace/camera.h"
#include "core/raytrace/scene.h"

namespace seesaw {

struct RenderOptions {
  int width = 800, height = 600;  ///< pixels, 1 .. 16384
  /// Camera rays a pixel, 1 .. 1024. Soft shadows and ambient light are sampled by these too: 16 for a page,
  /// 4 to look.
  int samples = 16;
  /// Rays a sample that look for openness, 0 for none (all open).
  int ambient_rays = 2;
  /// How far those rays look, in lengths of the subject's half diagonal.
  double ambient_reach = 0.6;
  int max_depth = 4;  ///< reflections of reflections, 0 .. 16
};

/// Opaque unless the background is not. Throws Error for sizes beyond the limits above or an image of
/// more than 2^27 pixels, Cancelled.
Image render(const Scene& scene, const PinholeCamera& camera, const RenderOptions& options = {},
             const Progress& progress = {});

}  // namespace seesaw
