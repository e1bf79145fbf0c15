// What a picture of fields costs, pixel by pixel: how often the camera's rays had fields evaluated.
//
// Silhouettes glow, where rays graze a surface and steps are short. The same picture by two tracers shows
// what one pays for what it promises (heuristic_tracer.h, rigorous_tracer.h).
//
// Before it: scene.h, camera.h. After it: core/image.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/image/image.h"
#include "core/raytrace/camera.h"
#include "core/raytrace/render.h"
#include "core/raytrace/scene.h"

namespace seesaw {

struct EvaluationCounts {
  int width = 0, height = 0;
  std::vector<Index> counts = {};  ///< of pixel (x, y) at y * width + x

  Index total() const;
  Index largest() const;
};

/// One ray through the middle of each pixel, without shadows and reflections; of `options`, only the size
/// counts. Boxes' bounds (BoundTree::boxes) are not in the counts. Throws as `render` does.
EvaluationCounts count_evaluations(const Scene& scene, const PinholeCamera& camera,
                                   const RenderOptions& options = {}, const Progress& progress = {});

/// The counts in core/image's sequential colors: 0 is pale, `darkest` evaluations and more are darkest; 0 for
/// the largest count there is.
Image heat_image(const EvaluationCounts& counts, Index darkest = 0);

}  // namespace seesaw
