#include "core/raytrace/evaluation_counts.h"

#include <algorithm>
#include <numeric>

#include "core/image/colormap.h"
#include "core/raytrace/tiles.h"
#include "core/raytrace/traced_scene.h"

namespace seesaw {

Index EvaluationCounts::total() const { return std::accumulate(counts.begin(), counts.end(), Index{0}); }

Index EvaluationCounts::largest() const {
  return counts.empty() ? 0 : *std::max_element(counts.begin(), counts.end());
}

EvaluationCounts count_evaluations(const Scene& scene, const PinholeCamera& camera,
                                   const RenderOptions& options, const Progress& progress) {
  check(options);
  report(progress, 0);
  const TracedScene traced(scene, 0);
  EvaluationCounts result{options.width, options.height, {}};
  result.counts.resize(static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height));
  const double aspect = static_cast<double>(options.width) / options.height;
  for_tiles(options.width, options.height, progress, [&](const Tile& tile) {
    std::vector<Ray> rays;
    for (int y = tile.y; y < tile.y + tile.height; ++y)
      for (int x = tile.x; x < tile.x + tile.width; ++x)
        rays.push_back(ray_through(camera, (x + 0.5) / options.height, (y + 0.5) / options.height, aspect));
    std::vector<Hit> hits(rays.size());
    std::vector<Index> counts(rays.size());
    traced.nearest(rays, hits, counts);
    for (int y = 0; y < tile.height; ++y)
      std::copy_n(counts.begin() + y * tile.width, tile.width,
                  result.counts.begin() + (Index{tile.y} + y) * options.width + tile.x);
  });
  return result;
}

Image heat_image(const EvaluationCounts& counts, Index darkest) {
  const Index full = std::max<Index>(1, darkest > 0 ? darkest : counts.largest());
  Image image(counts.width, counts.height);
  for (int y = 0; y < counts.height; ++y)
    for (int x = 0; x < counts.width; ++x) {
      const Index count = counts.counts[static_cast<std::size_t>(y) * static_cast<std::size_t>(counts.width) +
                                        static_cast<std::size_t>(x)];
      image.set(x, y, sequential_color(static_cast<double>(count) / static_cast<double>(full)));
    }
  return image;
}

}  // namespace seesaw
