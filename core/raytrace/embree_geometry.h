// Inside core/raytrace: triangles, discs and spheres, found by Embree.
//
// Embree computes in single precision, about 7 digits. So everything is moved to the origin and scaled to
// unit size before it gets there (a model at 4.5e6 loses nothing), a triangle's hit is then computed again in
// double precision from its vertices, and rays that leave a surface start beside it by more than single
// precision can blur.
//
// Before it: scene.h. After it: traced_scene.h.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/raytrace/hit.h"
#include "core/raytrace/scene.h"

namespace seesaw {

class EmbreeGeometry {
 public:
  /// Reads `scene` while it lives. `box` holds its objects. `pixel_angle` is a pixel's size seen from the
  /// eye, in radians: for edge lines.
  EmbreeGeometry(const Scene& scene, const Box<3>& box, double pixel_angle);
  ~EmbreeGeometry();
  EmbreeGeometry(const EmbreeGeometry&) = delete;
  EmbreeGeometry& operator=(const EmbreeGeometry&) = delete;

  bool empty() const;
  /// Replaces hits[i] where something lies on rays[i] before hits[i].t. Edge lines are as wide as they are
  /// seen from the ray's origin. Called from many threads.
  void nearest(std::span<const Ray> rays, std::span<Hit> hits) const;
  /// Sets blocked[i] to 1 where something lies on rays[i] from begin to end.
  void occlude(std::span<const Ray> rays, std::span<char> blocked) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace seesaw
