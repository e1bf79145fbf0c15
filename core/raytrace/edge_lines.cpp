#include "core/raytrace/edge_lines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace seesaw {

namespace {

Point<3> normal_of(const TriangleMesh& mesh, Index face) {
  const Point<3> a = mesh.vertices.col(mesh.faces(0, face)), b = mesh.vertices.col(mesh.faces(1, face)),
                 c = mesh.vertices.col(mesh.faces(2, face));
  return (b - a).cross(c - a).stableNormalized();
}

}  // namespace

std::vector<std::uint8_t> edges_to_draw(const TriangleMesh& mesh, double least_angle) {
  const Index faces = mesh.faces.cols();
  std::vector<std::uint8_t> drawn(static_cast<std::size_t>(faces), 7);
  if (!(least_angle > 0)) return drawn;
  const double cosine = std::cos(least_angle * std::numbers::pi / 180);
  std::map<std::pair<int, int>, std::pair<Index, int>> first;  // an edge's face and place in it
  for (Index face = 0; face < faces; ++face)
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.faces(k, face), b = mesh.faces((k + 1) % 3, face);
      const auto [other, is_new] = first.try_emplace({std::min(a, b), std::max(a, b)}, face, k);
      if (is_new || normal_of(mesh, face).dot(normal_of(mesh, other->second.first)) <= cosine) continue;
      drawn[static_cast<std::size_t>(face)] &= static_cast<std::uint8_t>(~(1u << k));
      drawn[static_cast<std::size_t>(other->second.first)] &=
          static_cast<std::uint8_t>(~(1u << other->second.second));
    }
  return drawn;
}

bool on_drawn_edge(const Ray& ray, const Point<3>& place, const Point<3>& a, const Point<3>& b,
                   const Point<3>& c, std::uint8_t drawn, double reach) {
  const auto flat = [&](const Point<3>& p) {
    const Point<3> d = p - place;
    return Point<3>(d - d.dot(ray.direction) * ray.direction);
  };
  const Point<3> corners[3] = {flat(a), flat(b), flat(c)};
  for (int k = 0; k < 3; ++k) {
    if (!(drawn & (1u << k))) continue;
    const Point<3>& p = corners[k];
    const Point<3> along = corners[(k + 1) % 3] - p;
    const double length = along.squaredNorm();
    const double s = length > 0 ? std::clamp(-p.dot(along) / length, 0.0, 1.0) : 0.0;
    if ((p + s * along).squaredNorm() <= reach * reach) return true;
  }
  return false;
}

}  // namespace seesaw
