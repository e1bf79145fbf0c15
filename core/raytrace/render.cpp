#include "core/raytrace/render.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <string>
#include <thread>

#include "core/base/parallel.h"
#include "core/raytrace/sampling.h"
#include "core/raytrace/shade.h"

namespace seesaw {

namespace {

constexpr int tile = 16;  // pixels a side: large enough for batches, small enough for many cores

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

struct TilePlace {
  int x, y, width, height;
};

TilePlace tile_place(Index number, const RenderOptions& options) {
  const int across = (options.width + tile - 1) / tile;
  const int x = static_cast<int>(number % across) * tile, y = static_cast<int>(number / across) * tile;
  return {x, y, std::min(tile, options.width - x), std::min(tile, options.height - y)};
}

void render_tile(const Shader& shader, const PinholeCamera& camera, const RenderOptions& options,
                 const TilePlace& place, Image& image) {
  const std::size_t samples = static_cast<std::size_t>(options.samples);
  const double aspect = static_cast<double>(options.width) / options.height;
  std::vector<Ray> rays;
  std::vector<SampleId> ids;
  rays.reserve(samples * tile * tile);
  ids.reserve(samples * tile * tile);
  for (int y = place.y; y < place.y + place.height; ++y)
    for (int x = place.x; x < place.x + place.width; ++x) {
      const std::uint64_t pixel =
          mixed_bits((static_cast<std::uint64_t>(y) << 32) + static_cast<std::uint64_t>(x) + 1);
      for (std::size_t s = 0; s < samples; ++s) {
        // One sample stands in the middle.
        const Point<2> at = samples == 1 ? Point<2>(0.5, 0.5) : pattern_point(s);
        rays.push_back(
            ray_through(camera, (x + at.x()) / options.height, (y + at.y()) / options.height, aspect));
        ids.push_back({pixel, s});
      }
    }
  const std::vector<Sample> seen = shader.look(rays, ids);
  std::size_t next = 0;
  for (int y = place.y; y < place.y + place.height; ++y)
    for (int x = place.x; x < place.x + place.width; ++x) {
      Sample sum{Light3::Zero(), 0};
      for (std::size_t s = 0; s < samples; ++s, ++next) {
        sum.light += seen[next].light;
        sum.alpha += seen[next].alpha;
      }
      const Light3 light = sum.alpha > 0 ? Light3(sum.light / sum.alpha) : Light3::Zero();
      image.set(x, y, color_of_light(light, sum.alpha / static_cast<double>(samples)));
    }
}

}  // namespace

Image render(const Scene& scene, const PinholeCamera& camera, const RenderOptions& options,
             const Progress& progress) {
  check(options);
  report(progress, 0);
  const double pixel_angle =
      2 * std::tan(camera.field_of_view * std::numbers::pi / 360) / static_cast<double>(options.height);
  const TracedScene traced(scene, pixel_angle);
  const std::vector<Light> lights = scene.lights.empty() ? studio_lights(camera) : scene.lights;
  const Point<3> up = camera.up.norm() > 0 ? Point<3>(camera.up.normalized()) : axes_of(camera).up;
  const Shader shader(scene, traced, lights, up, options);

  Image image(options.width, options.height);
  const Index tiles = Index{(options.width + tile - 1) / tile} * ((options.height + tile - 1) / tile);
  std::atomic<Index> done = 0;
  std::atomic<bool> stopped = false;
  const std::thread::id caller = std::this_thread::get_id();
  parallel_blocks(tiles, 1, [&](Index begin, Index end) {
    for (Index number = begin; number < end && !stopped; ++number) {
      render_tile(shader, camera, options, tile_place(number, options), image);
      const double fraction = static_cast<double>(++done) / static_cast<double>(tiles);
      // Listeners are called from the thread that asked for the picture, which works on tiles like all
      // others.
      if (progress && std::this_thread::get_id() == caller && !progress(fraction)) stopped = true;
    }
  });
  if (stopped) throw Cancelled();
  report(progress, 1);
  return image;
}

}  // namespace seesaw
