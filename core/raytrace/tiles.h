// Inside core/raytrace: a picture in tiles, on all cores, with progress.
//
// Before it: render.cpp, evaluation_counts.cpp. After it: core/base/parallel.h.
#pragma once

#include <functional>

#include "core/base/progress.h"
#include "core/raytrace/render.h"

namespace seesaw {

/// Throws Error for what render() refuses.
void check(const RenderOptions& options);

/// Pixels x .. x + width - 1 and y .. y + height - 1.
struct Tile {
  int x, y, width, height;
};

/// Tiles are this many pixels a side: large enough for batches, small enough for many cores.
inline constexpr int tile_side = 16;

/// Calls `work` for tiles that together cover the picture, in any order and from several threads. Reports
/// progress up to 1; throws Cancelled.
void for_tiles(int width, int height, const Progress& progress, const std::function<void(const Tile&)>& work);

}  // namespace seesaw
