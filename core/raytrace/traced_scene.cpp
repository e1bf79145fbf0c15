#include "core/raytrace/traced_scene.h"

#include <algorithm>

namespace seesaw {

namespace {

// Rays leave a traced surface this far from it, relative to the scene's size; places on it are known to
// rounding.
constexpr double field_clearance = 1e-6;

double size_of(const Box<3>& box) {
  const double half = box.isEmpty() ? 0.0 : 0.5 * box.sizes().norm();
  return half > 0 ? half : 1.0;
}

}  // namespace

TracedScene::TracedScene(const Scene& scene, double pixel_angle)
    : TracedScene(scene, bounding_box(scene), pixel_angle) {}

TracedScene::TracedScene(const Scene& scene, const Box<3>& box, double pixel_angle)
    : scene_(scene), size_(size_of(box)), embree_(scene, box, pixel_angle) {}

void TracedScene::nearest(std::span<const Ray> rays, std::span<Hit> hits,
                          std::span<Index> evaluations) const {
  std::fill(hits.begin(), hits.end(), Hit{});
  std::fill(evaluations.begin(), evaluations.end(), Index{0});
  embree_.nearest(rays, hits);
  if (scene_.solids.empty()) return;

  std::vector<Ray> shortened(rays.begin(), rays.end());
  std::vector<SolidCrossings> crossings(rays.size());
  std::vector<const Solid*> winner(rays.size(), nullptr);
  std::vector<SolidCrossing> first(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) shortened[i].end = std::min(rays[i].end, hits[i].t);
  for (const Solid& solid : scene_.solids) {
    solid.trace(shortened, HowMany::first, crossings);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (!evaluations.empty()) evaluations[i] += crossings[i].evaluations;
      if (crossings[i].crossings.empty()) continue;
      winner[i] = &solid;
      first[i] = crossings[i].crossings.front();
      shortened[i].end = first[i].t;
    }
  }
  // Normals are asked for leaf by leaf, in batches.
  std::vector<std::size_t> of_leaf;
  for (const Solid& solid : scene_.solids)
    for (std::size_t leaf = 0; leaf < solid.leaves().size(); ++leaf) {
      of_leaf.clear();
      for (std::size_t i = 0; i < rays.size(); ++i)
        if (winner[i] == &solid && first[i].leaf == static_cast<int>(leaf)) of_leaf.push_back(i);
      if (of_leaf.empty()) continue;
      Points<3> places(3, static_cast<Index>(of_leaf.size()));
      std::vector<char> caps(of_leaf.size());
      for (std::size_t k = 0; k < of_leaf.size(); ++k) {
        places.col(static_cast<Index>(k)) = rays[of_leaf[k]].at(first[of_leaf[k]].t);
        caps[k] = first[of_leaf[k]].cap;
      }
      const Points<3> normals = solid.normals(static_cast<int>(leaf), places, caps);
      for (std::size_t k = 0; k < of_leaf.size(); ++k) {
        const std::size_t i = of_leaf[k];
        Hit& hit = hits[i];
        hit = {};
        hit.t = first[i].t;
        hit.place = places.col(static_cast<Index>(k));
        Point<3> normal = normals.col(static_cast<Index>(k));
        // Toward the ray: that turns it around where this leaf was cut away, and where the ray comes from
        // inside.
        if (normal.dot(rays[i].direction) > 0) normal = -normal;
        if (normal.isZero()) normal = -rays[i].direction;
        hit.normal = hit.facet = normal;
        hit.start = hit.place + field_clearance * size_ * normal;
        hit.back = !first[i].entering;
        hit.material = &solid.leaves()[leaf].material;
      }
    }
}

void TracedScene::occlude(std::span<const Ray> rays, std::span<char> blocked) const {
  std::fill(blocked.begin(), blocked.end(), char{0});
  embree_.occlude(rays, blocked);
  std::vector<Ray> free;
  std::vector<std::size_t> whose;
  std::vector<SolidCrossings> crossings;
  for (const Solid& solid : scene_.solids) {
    free.clear();
    whose.clear();
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (blocked[i]) continue;
      free.push_back(rays[i]);
      whose.push_back(i);
    }
    crossings.resize(free.size());
    solid.trace(free, HowMany::first, crossings);
    for (std::size_t k = 0; k < free.size(); ++k)
      if (crossings[k].inside_at_begin || !crossings[k].crossings.empty()) blocked[whose[k]] = 1;
  }
}

}  // namespace seesaw
