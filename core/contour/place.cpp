#include "core/contour/place.h"

#include <algorithm>

namespace seesaw {
namespace {

double distance_to_segment(const Point<2>& p, const Point<2>& a, const Point<2>& b) {
  const Point<2> along = b - a;
  const double squared = along.squaredNorm();
  const double t = squared > 0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (a + t * along - p).norm();
}

// Rounding in a seed's lattice coordinates.
double uv_grain(const Lattice& lattice) {
  return 4e-16 * std::max(lattice.nx, lattice.ny) +
         4 * lattice.grain / lattice.extent * std::max(lattice.nx, lattice.ny);
}

}  // namespace

double size_of(const Triangulation& mesh, int t) {
  const auto [a, b] = mesh.edge(t, 0);
  return (mesh.position(a) - mesh.position(b)).norm();
}

Place place_of(Triangulation& mesh, const Seed& seed) {
  Place place;
  const double grain = uv_grain(mesh.lattice());
  mesh.make_around(seed.uv, grain);
  mesh.leaves_near(seed.uv, grain, place.leaves);
  for (const int t : place.leaves) place.size = std::min(place.size, size_of(mesh, t));
  return place;
}

int nearest_passage(const Crossings& curve, const Seed& seed, double reach) {
  std::vector<int> leaves;
  curve.mesh().leaves_near(seed.uv, reach / curve.mesh().lattice().cell, leaves);
  int nearest = -1;
  double least = reach;
  for (const int t : leaves) {
    if (!curve.mesh().is_mixed(t)) continue;
    const Passage passage = curve.passage(t);
    if (curve.is_point(passage)) continue;
    const Point<2>&a = curve[passage.from].position, &b = curve[passage.to].position;
    const double distance = distance_to_segment(seed.at, a, b);
    if (distance > least || (distance == least && nearest >= 0)) continue;
    if (!seed.gradient.isZero(0) && left_of(b - a).dot(seed.gradient) <= 0) continue;
    least = distance;
    nearest = t;
  }
  return nearest;
}

}  // namespace seesaw
