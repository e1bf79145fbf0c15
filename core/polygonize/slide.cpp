#include "core/polygonize/slide.h"

#include <algorithm>
#include <vector>

#include "core/base/parallel.h"
#include "core/polygonize/project.h"
#include "core/polygonize/triangle_quality.h"

namespace seesaw {

namespace {

// How far to slide, and how far Newton's step may lead back onto f = 0, in cubes.
constexpr double farthest = 0.3, leash = 0.25;
constexpr Index targets_a_block = 1024;

// The corners of triangles that are not good as they are.
std::vector<int> find_movable(const WorkingMesh& work) {
  VertexSet asked(work.mesh.vertices(), false);
  std::vector<int> movable;
  for (int f = 0; f < work.net.size() / 3; ++f) {
    if (work.quality[static_cast<std::size_t>(f)] >= good_as_it_is) continue;
    for (int h = 3 * f; h < 3 * f + 3; ++h) {
      const int v = work.net.origin(h);
      if (!asked.has(v) && !work.is_fixed(v)) movable.push_back(v);
      asked.add(v);
    }
  }
  return movable;
}

// In the tangent plane toward the middle of the neighbors.
Point<3> propose(const WorkingMesh& work, int v) {
  const Point<3> here = work.at(v);
  Point<3> sum = Point<3>::Zero(), normal = Point<3>::Zero();
  double count = 0;
  work.net.for_each_leaving(v, [&](int h) {
    const Point<3> b = work.at(work.net.target(h)), c = work.at(work.net.origin(HalfEdges::previous(h)));
    normal += normal_of(here, b, c);
    sum += b - here;
    ++count;
  });
  Point<3> move = sum / count;
  if (const double size = normal.squaredNorm(); size > 0) move -= normal * (normal.dot(move) / size);
  if (const double size = move.norm(); size > farthest * work.cell) move *= farthest * work.cell / size;
  return here + move;
}

// Whether the triangles around v may be as they are rather than as they were with the vertices `before`, of
// which the qualities still are.
bool is_content(const WorkingMesh& work, const Points<3>& before, int v) {
  const HalfEdges& net = work.net;
  const Point<3> from = before.col(v), to = work.at(v);
  double fresh = 1;
  const bool turned = net.any_leaving(v, [&](int h) {
    const int q = net.target(h), r = net.origin(HalfEdges::previous(h));
    const Point<3> b = work.at(q), c = work.at(r);
    const Point<3> was = normal_of(from, before.col(q), before.col(r)), is = normal_of(to, b, c);
    fresh = std::min(fresh, quality_of(to, b, c, is));
    return !was.isZero(0) && !within(was, is, largest_turn);
  });
  if (turned) return false;
  return fresh >= good_enough || fresh >= work.worst_around(v);
}

// Takes slides back until everybody who is still `sliding` is content; `asked` are those to ask first.
void take_back(WorkingMesh& work, const Points<3>& before, std::vector<int> asked, VertexSet& sliding) {
  while (!asked.empty()) {
    std::vector<char> back(asked.size());
    parallel_blocks(static_cast<Index>(asked.size()), targets_a_block, [&](Index begin, Index end) {
      for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
        back[i] = sliding.has(asked[i]) && !is_content(work, before, asked[i]);
    });
    std::vector<int> neighbors;
    for (std::size_t i = 0; i < asked.size(); ++i) {
      if (back[i] == 0) continue;
      sliding.remove(asked[i]);
      work.mesh.positions.col(asked[i]) = before.col(asked[i]);
      work.net.for_each_leaving(asked[i], [&](int h) { neighbors.push_back(work.net.target(h)); });
    }
    std::sort(neighbors.begin(), neighbors.end());
    neighbors.erase(std::unique(neighbors.begin(), neighbors.end()), neighbors.end());
    asked = std::move(neighbors);
  }
}

}  // namespace

void slide_vertices(WorkingMesh& work, Sampler& sampler) {
  const std::vector<int> movable = find_movable(work);
  Points<3> targets(3, static_cast<Index>(movable.size()));
  parallel_blocks(targets.cols(), targets_a_block, [&](Index begin, Index end) {
    for (Index i = begin; i < end; ++i) targets.col(i) = propose(work, movable[static_cast<std::size_t>(i)]);
  });
  const Projected projected = project(sampler, targets, {}, {.leash = leash * work.cell, .steps = 1});
  const Points<3> before = work.mesh.positions;
  VertexSet sliding(work.mesh.vertices(), false);
  for (std::size_t i = 0; i < movable.size(); ++i) {
    if (!projected.good[i]) continue;
    work.mesh.positions.col(movable[i]) = projected.positions.col(static_cast<Index>(i));
    sliding.add(movable[i]);
  }
  take_back(work, before, movable, sliding);
  work.renew_all();
}

}  // namespace seesaw
