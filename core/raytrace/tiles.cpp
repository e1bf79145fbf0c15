#include "core/raytrace/tiles.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <string>
#include <thread>

#include "core/base/error.h"
#include "core/base/parallel.h"

namespace seesaw {

void check(const RenderOptions& options) {
  const auto in = [](const char* name, int value, int low, int high) {
    if (value < low || value > high)
      throw Error(std::string(name) + " must be " + std::to_string(low) + " to " + std::to_string(high) +
                  ", not " + std::to_string(value));
  };
  in("the picture's width", options.width, 1, 16384);
  in("the picture's height", options.height, 1, 16384);
  in("samples a pixel", options.samples, 1, 1024);
  in("ambient rays", options.ambient_rays, 0, 1024);
  in("the depth of reflections", options.max_depth, 0, 16);
  if (std::int64_t{options.width} * options.height > (std::int64_t{1} << 27))
    throw Error("a picture may have 2^27 pixels, not " + std::to_string(options.width) + " x " +
                std::to_string(options.height));
}

void for_tiles(int width, int height, const Progress& progress,
               const std::function<void(const Tile&)>& work) {
  const int across = (width + tile_side - 1) / tile_side, down = (height + tile_side - 1) / tile_side;
  const Index tiles = Index{across} * down;
  std::atomic<Index> done = 0;
  std::atomic<bool> stopped = false;
  const std::thread::id caller = std::this_thread::get_id();
  parallel_blocks(tiles, 1, [&](Index begin, Index end) {
    for (Index number = begin; number < end && !stopped; ++number) {
      const int x = static_cast<int>(number % across) * tile_side;
      const int y = static_cast<int>(number / across) * tile_side;
      work({x, y, std::min(tile_side, width - x), std::min(tile_side, height - y)});
      const double fraction = static_cast<double>(++done) / static_cast<double>(tiles);
      // Listeners are called from the thread that asked for the picture, which works on tiles like all
      // others.
      if (progress && std::this_thread::get_id() == caller && !progress(fraction)) stopped = true;
    }
  });
  if (stopped) throw Cancelled();
  report(progress, 1);
}

}  // namespace seesaw
