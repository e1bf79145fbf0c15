// Inside core/raytrace: a Scene made ready for rays.
//
// Before it: scene.h. After it: shade.cpp.
#pragma once

#include <span>

#include "core/raytrace/embree_geometry.h"
#include "core/raytrace/hit.h"
#include "core/raytrace/scene.h"

namespace seesaw {

class TracedScene {
 public:
  /// Reads `scene` while it lives. `pixel_angle` in radians.
  TracedScene(const Scene& scene, double pixel_angle);

  /// The nearest hit of every ray; the floor is not part of it. evaluations[i], if asked for, is how often
  /// the fields of solids were evaluated for rays[i].
  void nearest(std::span<const Ray> rays, std::span<Hit> hits, std::span<Index> evaluations = {}) const;
  /// blocked[i] = 1 where an object lies on rays[i] from begin to end, else 0.
  void occlude(std::span<const Ray> rays, std::span<char> blocked) const;

  /// Half the diagonal of the box around all objects; 1 for none.
  double size() const { return size_; }

 private:
  TracedScene(const Scene& scene, const Box<3>& box, double pixel_angle);

  const Scene& scene_;
  double size_;
  EmbreeGeometry embree_;
};

}  // namespace seesaw
