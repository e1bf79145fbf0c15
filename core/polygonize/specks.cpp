#include "core/polygonize/specks.h"

#include <algorithm>

namespace seesaw {

void drop_specks(LatticeMesh& mesh, const Lattice& lattice, Sampler& sampler) {
  const Index n = mesh.vertices();
  if (n == 0 || (mesh.inside_values.array() != 0).all()) return;
  std::vector<int> component;
  const Index count = components_of(mesh.faces, n, component);
  std::vector<bool> real(static_cast<std::size_t>(count), false);
  for (Index v = 0; v < n; ++v)
    if (!mesh.is_exact_zero(v)) real[static_cast<std::size_t>(component[static_cast<std::size_t>(v)])] = true;

  // The six lattice neighbors of each zero in question, but those beyond the range.
  const Box<3> box(lattice.position(lattice.range.low), lattice.position(lattice.range.high));
  std::vector<Point<3>> neighbors;
  std::vector<int> of;
  for (Index v = 0; v < n; ++v) {
    const int its = component[static_cast<std::size_t>(v)];
    if (real[static_cast<std::size_t>(its)]) continue;
    for (int d = 0; d < 3; ++d)
      for (const double side : {-1.0, 1.0}) {
        Point<3> p = mesh.inside.col(v);
        p[d] += side * lattice.step[d];
        if (p[d] < box.min()[d] - 0.5 * lattice.step[d] || p[d] > box.max()[d] + 0.5 * lattice.step[d])
          continue;
        neighbors.push_back(p);
        of.push_back(its);
      }
  }
  if (of.empty() && std::find(real.begin(), real.end(), false) == real.end()) return;
  Points<3> points(3, static_cast<Index>(neighbors.size()));
  for (std::size_t i = 0; i < neighbors.size(); ++i) points.col(static_cast<Index>(i)) = neighbors[i];
  const Values values = sampler.values(points);
  for (std::size_t i = 0; i < of.size(); ++i)
    if (values[static_cast<Index>(i)] > 0) real[static_cast<std::size_t>(of[i])] = true;

  std::vector<bool> keep(static_cast<std::size_t>(mesh.faces.cols()));
  for (Index f = 0; f < mesh.faces.cols(); ++f)
    keep[static_cast<std::size_t>(f)] =
        real[static_cast<std::size_t>(component[static_cast<std::size_t>(mesh.faces(0, f))])];
  keep_faces(mesh, keep);
}

}  // namespace seesaw
