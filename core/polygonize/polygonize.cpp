#include "core/polygonize/polygonize.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/polygonize/attempt.h"
#include "core/polygonize/edge_roots.h"
#include "core/polygonize/improve.h"
#include "core/polygonize/project.h"
#include "core/polygonize/stopwatch.h"
#include "core/polygonize/triangle_quality.h"

namespace seesaw {

namespace {

// How well roots on lattice edges are found, in cubes. Where vertices will slide and be polished anyway, a
// root need only be on the right sheet.
constexpr double rough = 1e-2, fine = 1e-13;
// How far polishing may move a vertex, in cubes.
constexpr double polish_leash = 0.25;
// Half the cube makes so many times the bytes and cubes; a little more than four.
constexpr std::size_t growth = 5;

// The vertices that Newton could not bring onto f = 0 go back to their lattice edges, where f changes its
// sign. Returns how many are not on a zero even then.
Index settle_on_edges(LatticeMesh& mesh, Projected& polished, Sampler& sampler, double tolerance) {
  std::vector<Index> failed;
  for (Index v = 0; v < mesh.vertices(); ++v)
    if (!polished.good[static_cast<std::size_t>(v)]) failed.push_back(v);
  if (failed.empty()) return 0;
  const EdgeRoots roots = find_edge_roots(sampler,
                                          {mesh.inside(Eigen::all, failed), mesh.outside(Eigen::all, failed),
                                           mesh.inside_values(failed), mesh.outside_values(failed)},
                                          tolerance);
  Points<3> gradients;
  const Values values = sampler.values(roots.positions, gradients);
  Index off = 0;
  for (std::size_t i = 0; i < failed.size(); ++i) {
    const Index k = static_cast<Index>(i);
    polished.positions.col(failed[i]) = roots.positions.col(k);
    polished.gradients.col(failed[i]) = gradients.col(k);
    if (!(std::abs(values[k]) <= 1e3 * tolerance * gradients.col(k).norm())) ++off;
  }
  return off;
}

// Fills in the normals that are zero.
void take_from_triangles(const LatticeMesh& mesh, Points<3>& normals) {
  Points<3> by_area = Points<3>::Zero(3, mesh.vertices());
  for (Index f = 0; f < mesh.faces.cols(); ++f) {
    const Point<3> normal =
        normal_of(mesh.positions.col(mesh.faces(0, f)), mesh.positions.col(mesh.faces(1, f)),
                  mesh.positions.col(mesh.faces(2, f)));
    for (int k = 0; k < 3; ++k) by_area.col(mesh.faces(k, f)) += normal;
  }
  for (Index v = 0; v < normals.cols(); ++v)
    if (normals.col(v).isZero(0)) normals.col(v) = by_area.col(v);
}

// Onto f = 0, with normals: outward is -grad f, and where there is none, what the triangles say.
Points<3> polish(LatticeMesh& mesh, Sampler& sampler, double cell, double tolerance, Polygonization& result) {
  Projected polished =
      project(sampler, mesh.positions, mesh.on_range, {.leash = polish_leash * cell, .tolerance = tolerance});
  result.unpolished += settle_on_edges(mesh, polished, sampler, tolerance);
  mesh.positions = polished.positions;
  Points<3> normals = -polished.gradients;
  if ((normals.array() == 0).colwise().all().any()) take_from_triangles(mesh, normals);
  parallel_blocks(normals.cols(), 4096, [&](Index begin, Index end) {
    for (Index v = begin; v < end; ++v) {
      const double length = normals.col(v).stableNorm();
      normals.col(v) = length > 0 ? Point<3>(normals.col(v) / length) : Point<3>(Point<3>::UnitZ());
    }
  });
  return normals;
}

void append(TriangleMesh& mesh, const LatticeMesh& part, const Points<3>& normals) {
  const Index v = mesh.vertices.cols(), f = mesh.faces.cols();
  mesh.vertices.conservativeResize(3, v + part.vertices());
  mesh.vertices.rightCols(part.vertices()) = part.positions;
  mesh.normals.conservativeResize(3, v + part.vertices());
  mesh.normals.rightCols(part.vertices()) = normals;
  mesh.faces.conservativeResize(3, f + part.faces.cols());
  mesh.faces.rightCols(part.faces.cols()) = part.faces.array() + static_cast<int>(v);
}

// Tries with halved cubes while seeds are missed and memory allows.
Attempt best_attempt(Lattice& lattice, const Points<3>& seeds, Sampler& sampler,
                     const PolygonizeOptions& options, int& halvings) {
  const double precision = options.improve ? rough : fine;
  Attempt best = attempt(lattice, seeds, sampler, options, precision);
  const MemoryBound memory(options.memory_limit);
  for (halvings = 0; halvings < options.halvings && best.missed > 0; ++halvings) {
    const int longest = std::max({lattice.n[0], lattice.n[1], lattice.n[2]});
    if (longest >= 1 << (key_bits - 2)) break;
    if (!memory.allows(growth * best.bytes, growth * static_cast<std::size_t>(best.cubes))) break;
    try {
      Attempt finer = attempt(halved(lattice), seeds, sampler, options, precision);
      finer.times.lattice += best.times.lattice;
      finer.times.assemble += best.times.assemble;
      finer.times.seeds += best.times.seeds;
      best = std::move(finer);
    } catch (const TooMuchMemory&) {
      break;  // what we have is what there is room for
    }
    lattice = halved(lattice);
  }
  return best;
}

}  // namespace

Polygonization polygonize(const Field<3>& field, const PointsRef<3>& given, const PolygonizeOptions& options,
                          const Progress& progress) {
  SEESAW_CHECK_GE(options.cells, 1);
  SEESAW_CHECK_LE(options.cells, 65536);
  Points<3> seeds(3, given.cols());
  Index finite = 0;
  for (Index i = 0; i < given.cols(); ++i)
    if (given.col(i).allFinite()) seeds.col(finite++) = given.col(i);
  seeds.conservativeResize(3, finite);

  Polygonization result;
  result.seeds_outside = given.cols() - finite;
  Sampler sampler(field, progress);
  Lattice lattice = make_lattice(field, seeds, options);
  if (lattice.n[0] == 0) {
    result.seeds_outside = given.cols();
    sampler.finish_stage();
    return result;
  }
  const double tolerance = tolerance::on_curve * lattice.box.sizes().maxCoeff();
  const double square = static_cast<double>(options.cells) * options.cells;
  sampler.stage(0.6, (options.exhaustive || finite == 0 ? options.cells : 10) * square);
  Attempt found = best_attempt(lattice, seeds, sampler, options, result.halved);
  sampler.finish_stage();
  result.times = found.times;
  result.cell = lattice.cell();
  result.clipped = found.clipped;
  result.cubes = found.cubes;
  result.seeds_outside += found.outside;
  result.seeds_nowhere = found.nowhere;
  result.seeds_missed = found.missed;
  for (const Seed& seed : found.seeds) result.seeds_on_surface += seed.on_surface ? 1 : 0;
  result.small_components = static_cast<Index>(found.parts.size()) - 1;

  double raw = 90;
  Stopwatch watch;
  for (Part& part : found.parts) {
    if (part.mesh.faces.cols() == 0) continue;
    raw = std::min(raw, smallest_angle(part.mesh.positions, part.mesh.faces));
    const double vertices = static_cast<double>(part.mesh.vertices());
    sampler.stage(0.8, vertices);
    if (options.improve)
      improve(part.mesh, sampler, part.cell);
    else
      collapse_empty_edges(part.mesh, part.cell);
    sampler.finish_stage();
    result.times.improve += watch.lap();
    sampler.stage(0.98, 2 * vertices);
    const Points<3> normals = polish(part.mesh, sampler, part.cell, tolerance, result);
    append(result.mesh, part.mesh, normals);
    result.times.polish += watch.lap();
  }
  result.smallest_angle = smallest_angle(result.mesh.vertices, result.mesh.faces);
  result.smallest_angle_raw = result.mesh.faces.cols() == 0 ? 0.0 : raw;
  std::vector<int> component;
  result.components = components_of(result.mesh.faces, result.mesh.vertices.cols(), component);
  result.evaluations = sampler.evaluations();
  result.gradient_evaluations = sampler.gradient_evaluations();
  result.nonfinite = sampler.nonfinite();
  sampler.stage(1.0, 1);
  sampler.finish_stage();
  return result;
}

}  // namespace seesaw
