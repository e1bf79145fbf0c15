#include "core/polygonize/attempt.h"

#include <algorithm>
#include <cmath>

#include "core/base/tolerances.h"
#include "core/polygonize/scan.h"
#include "core/polygonize/small.h"
#include "core/polygonize/specks.h"
#include "core/polygonize/stopwatch.h"

namespace seesaw {

namespace {

// How far a seed may be from f = 0, in cubes.
constexpr double seed_reach = 2;
// A seed that is beyond the range by so little, in cubes, is on its face.
constexpr double face_slack = 1e-6;
// Small components that seeds are looked at for; beyond, a field of dust would take forever.
constexpr int most_small = 1000;

bool is_bounded(const Box<3>& box) {
  return !box.isEmpty() && box.min().allFinite() && box.max().allFinite() && box.sizes().allFinite();
}

// The cube of the range that holds the seed, or the nearest one: seeds like to stand on the faces of boxes.
Corner cube_of(const Seed& seed, const Lattice& lattice) {
  Corner cube = lattice.cube_at(seed.at);
  for (std::size_t d = 0; d < 3; ++d)
    cube[d] = std::clamp(cube[d], lattice.range.low[d], lattice.range.high[d] - 1);
  return cube;
}

CrossedCubes follow(Lattice& lattice, const std::vector<Seed>& seeds, Sampler& sampler,
                    const MemoryBound& memory, Attempt& result) {
  Continuation continuation(lattice, sampler, memory);
  for (const Seed& seed : seeds) continuation.look_at(cube_of(seed, lattice));
  continuation.run();
  // A seed on a corner, or a little off the surface: its neighbors.
  for (const Seed& seed : seeds) {
    const Corner cube = cube_of(seed, lattice);
    if (continuation.is_crossed(cube)) continue;
    for (int c = 0; c < 27; ++c) {
      const Corner next = {cube[0] + c % 3 - 1, cube[1] + c / 3 % 3 - 1, cube[2] + c / 9 - 1};
      if (lattice.range.contains(next)) continuation.look_at(next);
    }
  }
  continuation.run();
  const CubeRange inner = lattice.range, all{{0, 0, 0}, lattice.n};
  if (continuation.clipped() && (inner.low != all.low || inner.high != all.high)) {
    lattice.range = all;
    continuation.unblock();
    continuation.run();
    if (continuation.clipped()) {
      lattice.range = inner;
      continuation.keep_range();
    }
  }
  result.clipped = continuation.clipped();
  result.bytes = continuation.bytes();
  continuation.found().sort();
  return std::move(continuation.found());
}

// Small components for the seeds that the mesh misses; the answer to what became of them.
void look_closer(const Lattice& lattice, Sampler& sampler, const MemoryBound& memory, double precision,
                 Attempt& result) {
  int looks = 0;
  for (Seed& seed : result.seeds) {
    if (seed.on_surface) continue;
    if (!seed.on_zero) {
      ++result.nowhere;
      continue;
    }
    std::vector<Seed> alone = {seed};
    for (std::size_t part = 1; part < result.parts.size() && !alone[0].on_surface; ++part)
      find_on_mesh(alone, result.parts[part].mesh, result.parts[part].cell, sampler);
    seed.on_surface = alone[0].on_surface;
    if (seed.on_surface) continue;
    if (looks++ >= most_small) {
      ++result.missed;
      continue;
    }
    SmallSearch search = find_small(seed, lattice, sampler, memory, precision);
    if (search.answer == SmallSearch::Answer::found &&
        (remove_crude(result.parts[0].mesh, search) || !search.holds_corner)) {
      seed.on_surface = true;
      result.parts.push_back({std::move(search.mesh), search.cell});
    } else if (search.answer == SmallSearch::Answer::nothing) {
      ++result.nowhere;
    } else {
      ++result.missed;
    }
  }
}

}  // namespace

Lattice make_lattice(const Field<3>& field, const Points<3>& seeds, const PolygonizeOptions& options) {
  Lattice lattice;
  if (options.box) {
    const Box<3>& box = *options.box;
    if (!is_bounded(box) || box.sizes().minCoeff() <= 0) return lattice;
    const double cell = box.sizes().maxCoeff() / options.cells;
    for (std::size_t d = 0; d < 3; ++d) {
      const double side = box.sizes()[static_cast<Index>(d)];
      lattice.n[d] = std::max(1, static_cast<int>(std::lround(side / cell)));
      lattice.step[static_cast<Index>(d)] = side / lattice.n[d];
    }
    lattice.box = box;
    lattice.range = {{0, 0, 0}, lattice.n};
    return lattice;
  }
  Box<3> box = field.bounding_box();
  const Box<3> around = bounding_box_of<3>(seeds);
  if (!around.isEmpty()) box.extend(around);
  if (!is_bounded(box) || box.sizes().maxCoeff() <= 0) return lattice;
  const double longest = box.sizes().maxCoeff();
  const double across = around.isEmpty() ? longest : std::max(around.sizes().maxCoeff(), longest / 4);
  const double cell = across / options.cells;
  Point<3> half;
  for (std::size_t d = 0; d < 3; ++d) {
    const int inner = std::max(1, static_cast<int>(std::ceil(box.sizes()[static_cast<Index>(d)] / cell)));
    const int margin = (inner + 1) / 2;
    lattice.n[d] = inner + 2 * margin;
    lattice.range.low[d] = margin;
    lattice.range.high[d] = margin + inner;
    half[static_cast<Index>(d)] = 0.5 * lattice.n[d] * cell;
  }
  lattice.step = Point<3>::Constant(cell);
  lattice.box = Box<3>(box.center() - half, box.center() + half);
  return lattice;
}

Lattice halved(const Lattice& lattice) {
  Lattice result = lattice;
  result.step *= 0.5;
  for (std::size_t d = 0; d < 3; ++d)
    for (int* number : {&result.n[d], &result.range.low[d], &result.range.high[d]}) *number *= 2;
  return result;
}

Attempt attempt(Lattice lattice, const Points<3>& seeds, Sampler& sampler, const PolygonizeOptions& options,
                double precision) {
  Attempt result;
  const MemoryBound memory(options.memory_limit);
  Stopwatch watch;
  const Point<3> slack = face_slack * lattice.step;
  const Box<3> range(lattice.position(lattice.range.low) - slack,
                     lattice.position(lattice.range.high) + slack);
  std::vector<Index> within;
  for (Index i = 0; i < seeds.cols(); ++i)
    if (range.contains(Point<3>(seeds.col(i)))) within.push_back(i);
  result.outside = seeds.cols() - static_cast<Index>(within.size());
  const double tolerance = tolerance::on_curve * lattice.box.sizes().maxCoeff();
  result.seeds =
      walk_seeds(sampler, Points<3>(seeds(Eigen::all, within)), seed_reach * lattice.cell(), tolerance);
  result.times.seeds += watch.lap();

  CrossedCubes found;
  if (options.exhaustive || seeds.cols() == 0) {
    found = scan(lattice, sampler, memory);
    result.clipped = crosses_range(lattice, found);
    result.bytes = found.corners.capacity() * (sizeof(Key) + sizeof(double)) +
                   found.cubes.capacity() * sizeof(CrossedCube);
  } else {
    found = follow(lattice, result.seeds, sampler, memory, result);
  }
  result.cubes = static_cast<Index>(found.cubes.size());
  result.times.lattice += watch.lap();

  result.parts.push_back({assemble(lattice, found, sampler, precision * lattice.cell()), lattice.cell()});
  drop_specks(result.parts[0].mesh, lattice, sampler);
  result.times.assemble += watch.lap();

  find_on_mesh(result.seeds, result.parts[0].mesh, lattice, found, sampler);
  find_tips(result.seeds, lattice.cell(), sampler);
  find_on_mesh(result.seeds, result.parts[0].mesh, lattice, found, sampler);
  look_closer(lattice, sampler, memory, precision, result);
  result.times.seeds += watch.lap();
  return result;
}

}  // namespace seesaw
