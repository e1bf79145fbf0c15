#include "core/polygonize/seeds.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/polygonize/project.h"

namespace seesaw {

namespace {

// In cubes: how near is on the mesh, and how near is so near that no other sheet fits between.
constexpr double near_enough = 0.25, certain = 0.01;
// A ridge is cut off, too, if less: then the mesh is right below the seed, in the direction of its normal.
// (The rim of a hole, which a sheet that is too thin has, is beside the seed.)
constexpr double near_enough_below = 0.75, below_cosine = 0.8;
// A tip or a crease is cut off by the cube that it stands in.
constexpr double near_enough_for_tips = 1.0;
// A crease: this near to the seed, in cubes, the gradient turns to a cosine of less than this.
constexpr double beside = 1e-3, least_cosine = 0.9;
// Where to look at f's sign on the way, as fractions of it: most of them near the seed.
constexpr std::array<double, 7> looks = {1.0 / 64, 1.0 / 32, 1.0 / 16, 1.0 / 8, 1.0 / 4, 1.0 / 2, 3.0 / 4};

// The point of triangle a, b, c nearest to p (Ericson 2005, section 5.1.5).
Point<3> nearest_in(const Point<3>& p, const Point<3>& a, const Point<3>& b, const Point<3>& c) {
  const Point<3> ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + d1 / (d1 - d3) * ab;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  const double sum = va + vb + vc;
  return sum > 0 ? Point<3>(a + vb / sum * ab + vc / sum * ac) : a;
}

struct Nearest {
  Point<3> point = Point<3>::Zero();
  double distance = infinity;

  void look_at(const Seed& seed, const LatticeMesh& mesh, Index face) {
    const Point<3> a = mesh.positions.col(mesh.faces(0, face)), b = mesh.positions.col(mesh.faces(1, face)),
                   c = mesh.positions.col(mesh.faces(2, face));
    if ((b - a).cross(c - a).dot(seed.outward) < 0) return;
    const Point<3> q = nearest_in(seed.at, a, b, c);
    if (const double its = (q - seed.at).norm(); its < distance) {
      distance = its;
      point = q;
    }
  }
};

// How near is near enough, in cubes.
double reach_of(const Seed& seed, const Point<3>& nearest) {
  if (seed.is_tip) return near_enough_for_tips;
  const Point<3> way = nearest - seed.at;
  const bool below = std::abs(way.dot(seed.outward)) >= below_cosine * way.norm() * seed.outward.norm();
  return below && !seed.outward.isZero(0) ? near_enough_below : near_enough;
}

void settle(std::vector<Seed>& seeds, const std::vector<Nearest>& nearest, double cell, Sampler& sampler) {
  std::vector<std::size_t> asked;
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    if (seeds[i].on_surface) continue;
    if (nearest[i].distance <= certain * cell)
      seeds[i].on_surface = true;
    else if (nearest[i].distance <= reach_of(seeds[i], nearest[i].point) * cell)
      asked.push_back(i);
  }
  Points<3> points(3, static_cast<Index>(asked.size() * looks.size()));
  Index column = 0;
  for (const std::size_t i : asked)
    for (const double t : looks) points.col(column++) = seeds[i].at + t * (nearest[i].point - seeds[i].at);
  const Values values = sampler.values(points);
  column = 0;
  for (const std::size_t i : asked) {
    int inside = 0;
    for (std::size_t k = 0; k < looks.size(); ++k) inside += is_inside(values[column++]) ? 1 : 0;
    seeds[i].on_surface = inside == 0 || inside == static_cast<int>(looks.size());
  }
}

}  // namespace

std::vector<Seed> walk_seeds(Sampler& sampler, const Points<3>& points, double reach, double tolerance) {
  const Projected projected = project(sampler, points, {}, {.leash = reach, .tolerance = tolerance});
  std::vector<Seed> seeds(static_cast<std::size_t>(points.cols()));
  for (Index i = 0; i < points.cols(); ++i) {
    Seed& seed = seeds[static_cast<std::size_t>(i)];
    seed.at = projected.positions.col(i);
    seed.on_zero = projected.good[static_cast<std::size_t>(i)];
    if (seed.on_zero) seed.outward = -projected.gradients.col(i);
  }
  return seeds;
}

void find_on_mesh(std::vector<Seed>& seeds, const LatticeMesh& mesh, const Lattice& lattice,
                  const CrossedCubes& found, Sampler& sampler) {
  std::vector<Nearest> nearest(seeds.size());
  const auto before = [](const CrossedCube& cube, Key key) { return cube.key < key; };
  const auto look_around = [&](std::size_t i) {
    const Corner cube = lattice.cube_at(seeds[i].at);
    for (int z = std::max(0, cube[2] - 1); z <= cube[2] + 1; ++z)
      for (int y = std::max(0, cube[1] - 1); y <= cube[1] + 1; ++y) {
        const Key last = key_of({cube[0] + 1, y, z});
        auto at = std::lower_bound(found.cubes.begin(), found.cubes.end(),
                                   key_of({std::max(0, cube[0] - 1), y, z}), before);
        for (; at != found.cubes.end() && at->key <= last; ++at) {
          const std::size_t c = static_cast<std::size_t>(at - found.cubes.begin());
          for (int f = mesh.cube_start[c]; f < mesh.cube_start[c + 1]; ++f)
            nearest[i].look_at(seeds[i], mesh, f);
        }
      }
  };
  parallel_blocks(static_cast<Index>(seeds.size()), 32, [&](Index begin, Index end) {
    for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      if (!seeds[i].on_surface) look_around(i);
  });
  settle(seeds, nearest, lattice.cell(), sampler);
}

void find_on_mesh(std::vector<Seed>& seeds, const LatticeMesh& mesh, double cell, Sampler& sampler) {
  std::vector<Nearest> nearest(seeds.size());
  for (std::size_t i = 0; i < seeds.size(); ++i)
    if (!seeds[i].on_surface)
      for (Index f = 0; f < mesh.faces.cols(); ++f) nearest[i].look_at(seeds[i], mesh, f);
  settle(seeds, nearest, cell, sampler);
}

void find_tips(std::vector<Seed>& seeds, double cell, Sampler& sampler) {
  std::vector<std::size_t> asked;
  for (std::size_t i = 0; i < seeds.size(); ++i)
    if (seeds[i].on_zero && !seeds[i].on_surface) asked.push_back(i);
  Points<3> points(3, static_cast<Index>(6 * asked.size())), gradients;
  Index column = 0;
  for (const std::size_t i : asked)
    for (int d = 0; d < 3; ++d)
      for (const double side : {-beside, beside})
        points.col(column++) = seeds[i].at + side * cell * Point<3>::Unit(d);
  sampler.values(points, gradients);
  for (std::size_t k = 0; k < asked.size(); ++k) {
    double cosine = 1;
    for (Index a = 0; a < 6; ++a)
      for (Index b = 0; b < a; ++b) {
        const Point<3> g = gradients.col(static_cast<Index>(6 * k) + a),
                       h = gradients.col(static_cast<Index>(6 * k) + b);
        cosine = std::min(cosine, g.dot(h) / (g.norm() * h.norm()));
      }
    if (cosine >= least_cosine) continue;
    seeds[asked[k]].is_tip = true;
    seeds[asked[k]].outward.setZero();
  }
}

double distance_to(const LatticeMesh& mesh, const Point<3>& p) {
  Seed seed;
  seed.at = p;
  Nearest nearest;
  for (Index f = 0; f < mesh.faces.cols(); ++f) nearest.look_at(seed, mesh, f);
  return nearest.distance;
}

}  // namespace seesaw
