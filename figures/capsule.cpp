#include "figures/capsule.h"

#include <cmath>
#include <vector>

namespace seesaw {

TriangleMesh capsule_mesh(const Point<3>& from, const Point<3>& to, double radius, int around) {
  const Point<3> axis = (to - from).normalized(), u = axis.unitOrthogonal(), v = axis.cross(u);
  const double length = (to - from).norm(), step = 2 * M_PI / around;
  // Each ring: where along the axis its sphere is centered, and its latitude there.
  std::vector<std::pair<double, double>> rings;
  const int caps = std::max(2, around / 4);
  for (int k = 1; k <= caps; ++k) rings.emplace_back(0.0, -M_PI / 2 + k * (M_PI / 2) / caps);
  const int along = std::max(1, static_cast<int>(std::lround(length / (radius * step))));
  for (int k = 1; k < along; ++k) rings.emplace_back(length * k / along, 0.0);
  for (int k = 0; k < caps; ++k) rings.emplace_back(length, k * (M_PI / 2) / caps);

  const Index count = static_cast<Index>(rings.size());
  TriangleMesh mesh;
  mesh.vertices.resize(3, count * around + 2);
  mesh.normals.resize(3, count * around + 2);
  const auto place = [&](Index i, double along_axis, const Point<3>& normal) {
    mesh.vertices.col(i) = from + along_axis * axis + radius * normal;
    mesh.normals.col(i) = normal;
  };
  for (Index r = 0; r < count; ++r)
    for (int k = 0; k < around; ++k) {
      const auto& [center, latitude] = rings[static_cast<std::size_t>(r)];
      const double angle = step * (k + 0.5 * static_cast<double>(r % 2));
      const Point<3> out = std::cos(angle) * u + std::sin(angle) * v;
      place(r * around + k, center, std::cos(latitude) * out + std::sin(latitude) * axis);
    }
  const Index bottom = count * around, top = bottom + 1;
  place(bottom, 0, -axis);
  place(top, length, axis);

  std::vector<Eigen::Vector3i> faces;
  const auto vertex = [&](Index ring, int k) { return static_cast<int>(ring * around + k % around); };
  for (int k = 0; k < around; ++k)
    faces.emplace_back(static_cast<int>(bottom), vertex(0, k + 1), vertex(0, k));
  for (Index r = 0; r + 1 < count; ++r)
    for (int k = 0; k < around; ++k) {
      // Odd rings are turned by half a step, so each vertex stands between two of the next ring.
      const int a = vertex(r, k), b = vertex(r, k + 1);
      const int c = vertex(r + 1, r % 2 ? k + 1 : k), d = vertex(r + 1, r % 2 ? k + 2 : k + 1);
      faces.emplace_back(a, b, c);
      faces.emplace_back(b, d, c);
    }
  for (int k = 0; k < around; ++k)
    faces.emplace_back(static_cast<int>(top), vertex(count - 1, k), vertex(count - 1, k + 1));
  mesh.faces.resize(3, static_cast<Index>(faces.size()));
  for (std::size_t i = 0; i < faces.size(); ++i) mesh.faces.col(static_cast<Index>(i)) = faces[i];
  return mesh;
}

}  // namespace seesaw
