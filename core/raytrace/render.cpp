#include "core/raytrace/render.h"

#include <cmath>
#include <numbers>

#include "core/raytrace/sampling.h"
#include "core/raytrace/shade.h"
#include "core/raytrace/tiles.h"

namespace seesaw {

namespace {

void render_tile(const Shader& shader, const PinholeCamera& camera, const RenderOptions& options,
                 const Tile& place, Image& image) {
  const std::size_t samples = static_cast<std::size_t>(options.samples);
  const double aspect = static_cast<double>(options.width) / options.height;
  std::vector<Ray> rays;
  std::vector<SampleId> ids;
  rays.reserve(samples * tile_side * tile_side);
  ids.reserve(samples * tile_side * tile_side);
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
  for_tiles(options.width, options.height, progress,
            [&](const Tile& tile) { render_tile(shader, camera, options, tile, image); });
  return image;
}

}  // namespace seesaw
