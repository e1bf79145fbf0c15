#include "core/raytrace/scene.h"

#include <algorithm>

#include "core/base/check.h"

namespace seesaw {

namespace {

// Calls `take` with points whose convex hull holds all objects.
template <class Take>
void for_outer_points(const Scene& scene, const Take& take) {
  for (const MeshObject& each : scene.meshes)
    // Vertices that no face uses are not seen.
    for (Index i = 0; i < each.mesh.faces.size(); ++i)
      take(Point<3>(each.mesh.vertices.col(each.mesh.faces.data()[i])));
  const auto take_rounded = [&](const Points<3>& centers, const Values& radii) {
    SEESAW_CHECK_EQ(centers.cols(), radii.size());
    for (Index i = 0; i < centers.cols(); ++i)
      for (int k = 0; k < 8; ++k)
        take(Point<3>(centers.col(i) + radii[i] * Point<3>(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1)));
  };
  for (const DiscsObject& each : scene.discs) take_rounded(each.centers, each.radii);
  for (const SpheresObject& each : scene.spheres) take_rounded(each.centers, each.radii);
  for (const Solid& each : scene.solids) {
    const Points<3> points = each.surface_points();
    for (Index i = 0; i < points.cols(); ++i) take(Point<3>(points.col(i)));
    if (points.cols() == 0 && !each.box().isEmpty())
      for (int k = 0; k < 8; ++k) take(Point<3>(each.box().corner(static_cast<Box<3>::CornerType>(k))));
  }
}

}  // namespace

Box<3> bounding_box(const Scene& scene) {
  Box<3> box;
  for_outer_points(scene, [&](const Point<3>& p) { box.extend(p); });
  return box;
}

PinholeCamera frame(const Scene& scene, const Framing& framing) {
  std::vector<double> coordinates;
  for_outer_points(scene,
                   [&](const Point<3>& p) { coordinates.insert(coordinates.end(), p.begin(), p.end()); });
  return frame(Eigen::Map<const Points<3>>(coordinates.data(), 3, static_cast<Index>(coordinates.size() / 3)),
               framing);
}

Floor floor_under(const Box<3>& subject, const Point<3>& up, Floor::Look look, double gap) {
  SEESAW_CHECK_LT(0.0, up.norm());
  Floor floor;
  floor.look = look;
  floor.up = up.normalized();
  if (subject.isEmpty()) return floor;
  const Point<3> middle = subject.center();
  const double size = std::max(0.5 * subject.sizes().norm(), 1e-300);
  double lowest = 0;
  for (int i = 0; i < 8; ++i)
    lowest = std::min(lowest, (subject.corner(static_cast<Box<3>::CornerType>(i)) - middle).dot(floor.up));
  floor.point = middle + (lowest - gap * size) * floor.up;
  floor.tile = 0.45 * size;
  floor.fade_begin = 2.5 * size;
  floor.fade_end = 9 * size;
  return floor;
}

}  // namespace seesaw
