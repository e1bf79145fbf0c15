#include "core/raytrace/surface_tracer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace seesaw {

Ray within(const Ray& ray, const Box<3>& box) {
  Ray part = ray;
  if (box.isEmpty()) {
    part.end = part.begin - 1;
    return part;
  }
  for (int d = 0; d < 3; ++d) {
    const double slope = ray.direction[d];
    if (slope == 0) {
      if (ray.origin[d] < box.min()[d] || ray.origin[d] > box.max()[d]) part.end = part.begin - 1;
      continue;
    }
    const double a = (box.min()[d] - ray.origin[d]) / slope, b = (box.max()[d] - ray.origin[d]) / slope;
    part.begin = std::max(part.begin, std::min(a, b));
    part.end = std::min(part.end, std::max(a, b));
  }
  return part;
}

SurfaceTracer::SurfaceTracer(std::shared_ptr<const Field<3>> field)
    : field_(std::move(field)), box_(field_->bounding_box()) {}

void SurfaceTracer::trace(std::span<const Ray> rays, HowMany how_many, std::span<RayCrossings> result) const {
  SEESAW_CHECK_EQ(rays.size(), result.size());
  std::vector<Task> tasks;
  tasks.reserve(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    result[i] = {};
    const Ray part = within(rays[i], box_);
    if (part.begin < part.end) tasks.push_back({part, how_many == HowMany::first, &result[i]});
  }
  trace_in_box(tasks);
  std::size_t next = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (next == tasks.size() || tasks[next].found != &result[i]) continue;
    const Ray& part = tasks[next++].ray;
    RayCrossings& found = result[i];
    const bool inside_at_end = found.inside_at_begin != (found.crossings.size() % 2 == 1);
    const bool stopped_early = how_many == HowMany::first && !found.crossings.empty();
    if (inside_at_end && !stopped_early && part.end < rays[i].end)
      found.crossings.push_back({part.end, true});
    if (found.inside_at_begin && part.begin > rays[i].begin) {
      found.inside_at_begin = false;
      found.crossings.insert(found.crossings.begin(), {part.begin, true});
    }
    if (how_many == HowMany::first && found.crossings.size() > 1) found.crossings.resize(1);
  }
}

}  // namespace seesaw
