#include "core/polygonize/small.h"

#include <cmath>

#include "core/polygonize/specks.h"

namespace seesaw {

namespace {

constexpr int finest = 14;          // a 16384th of the cube
constexpr double room = 2;          // cubes of the large lattice around the seed
constexpr double least_across = 8;  // cubes of the fine lattice that a component must span
constexpr std::size_t most_cubes = 8000;

// How often the closed mesh winds around p, by solid angles (van Oosterom & Strackee 1983).
double winding_number(const LatticeMesh& mesh, const Point<3>& p) {
  double sum = 0;
  for (Index f = 0; f < mesh.faces.cols(); ++f) {
    const Point<3> a = mesh.positions.col(mesh.faces(0, f)) - p, b = mesh.positions.col(mesh.faces(1, f)) - p,
                   c = mesh.positions.col(mesh.faces(2, f)) - p;
    const double x = a.norm(), y = b.norm(), z = c.norm();
    sum += 2 * std::atan2(a.dot(b.cross(c)), x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y);
  }
  return sum / (4 * 3.14159265358979323846);
}

Lattice around(const Point<3>& seed, double cell, int n) {
  Lattice lattice;
  // Off the middle, so that the seed is no corner.
  const Point<3> low = seed - Point<3>::Constant((n / 2 + 0.4) * cell);
  lattice.n = {n, n, n};
  lattice.step = Point<3>::Constant(cell);
  lattice.box = Box<3>(low, low + Point<3>::Constant(n * cell));
  lattice.range = {{0, 0, 0}, lattice.n};
  return lattice;
}

bool holds_a_corner(const LatticeMesh& mesh, const Box<3>& bounds, const Lattice& lattice) {
  const Corner first = lattice.cube_at(bounds.min()), last = lattice.cube_at(bounds.max());
  for (int z = first[2]; z <= last[2] + 1; ++z)
    for (int y = first[1]; y <= last[1] + 1; ++y)
      for (int x = first[0]; x <= last[0] + 1; ++x) {
        const Point<3> p = lattice.position({x, y, z});
        if (bounds.contains(p) && std::abs(winding_number(mesh, p)) > 0.5) return true;
      }
  return false;
}

}  // namespace

SmallSearch find_small(const Seed& seed, const Lattice& lattice, Sampler& sampler, const MemoryBound& memory,
                       double tolerance) {
  const Box<3> range(lattice.position(lattice.range.low), lattice.position(lattice.range.high));
  SmallSearch search;
  int too_large = 0;  // levels in a row on which the component did not close
  for (int level = 1; level <= finest && too_large < 2; ++level) {
    const int n = static_cast<int>(2 * room) << level;
    const Lattice fine = around(seed.at, lattice.cell() / (1 << level), n);
    Continuation continuation(fine, sampler, memory);
    continuation.look_at(fine.cube_at(seed.at));
    const bool ended = continuation.run(most_cubes);
    CrossedCubes& found = continuation.found();
    if (found.cubes.empty()) {
      too_large = 0;
      continue;
    }
    search.answer = SmallSearch::Answer::large;
    if (!ended || continuation.clipped()) {
      ++too_large;
      continue;
    }
    too_large = 0;
    found.sort();
    LatticeMesh mesh = assemble(fine, found, sampler, tolerance * fine.cell());
    drop_specks(mesh, fine, sampler);
    if (mesh.faces.cols() == 0) {
      search.answer = SmallSearch::Answer::nothing;
      continue;
    }
    std::vector<Seed> alone = {seed};
    find_on_mesh(alone, mesh, fine.cell(), sampler);
    const Box<3> bounds = bounding_box_of<3>(mesh.positions);
    if (!alone[0].on_surface || bounds.sizes().maxCoeff() < least_across * fine.cell()) continue;
    if (!range.contains(bounds)) return search;
    search.answer = SmallSearch::Answer::found;
    search.holds_corner = holds_a_corner(mesh, bounds, lattice);
    search.mesh = std::move(mesh);
    search.cell = fine.cell();
    return search;
  }
  return search;
}

bool remove_crude(LatticeMesh& large, const SmallSearch& small) {
  Box<3> bounds = bounding_box_of<3>(small.mesh.positions);
  const Point<3> slack = Point<3>::Constant(small.cell);
  bounds = Box<3>(bounds.min() - slack, bounds.max() + slack);
  std::vector<int> component;
  const Index count = components_of(large.faces, large.vertices(), component);
  std::vector<bool> keep(static_cast<std::size_t>(count), false);
  for (Index v = 0; v < large.vertices(); ++v)
    if (!bounds.contains(Point<3>(large.positions.col(v))))
      keep[static_cast<std::size_t>(component[static_cast<std::size_t>(v)])] = true;
  for (Index v = 0; v < large.vertices(); ++v) {
    const std::size_t its = static_cast<std::size_t>(component[static_cast<std::size_t>(v)]);
    if (!keep[its] && distance_to(small.mesh, large.positions.col(v)) > 0.5 * small.cell) keep[its] = true;
  }
  std::vector<bool> keep_face(static_cast<std::size_t>(large.faces.cols()));
  for (Index f = 0; f < large.faces.cols(); ++f)
    keep_face[static_cast<std::size_t>(f)] =
        keep[static_cast<std::size_t>(component[static_cast<std::size_t>(large.faces(0, f))])];
  const Index before = large.faces.cols();
  keep_faces(large, keep_face);
  return large.faces.cols() < before;
}

}  // namespace seesaw
