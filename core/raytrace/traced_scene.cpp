#include "core/raytrace/traced_scene.h"

#include <algorithm>

namespace seesaw {

namespace {

double size_of(const Box<3>& box) {
  const double half = box.isEmpty() ? 0.0 : 0.5 * box.sizes().norm();
  return half > 0 ? half : 1.0;
}

}  // namespace

TracedScene::TracedScene(const Scene& scene, double pixel_angle)
    : size_(size_of(bounding_box(scene))), embree_(scene, pixel_angle) {}

void TracedScene::nearest(std::span<const Ray> rays, std::span<Hit> hits) const {
  std::fill(hits.begin(), hits.end(), Hit{});
  embree_.nearest(rays, hits);
}

void TracedScene::occlude(std::span<const Ray> rays, std::span<char> blocked) const {
  std::fill(blocked.begin(), blocked.end(), char{0});
  embree_.occlude(rays, blocked);
}

}  // namespace seesaw
