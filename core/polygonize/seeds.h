// Seeds: where the surface is known to be. They say where to start, and whether all was found.
//
// Before it: the boundary constraints.  After it: continuation.h starts there; small.h looks closer where the
// mesh is not the surface through a seed.
//
// A mesh passes through a seed when a triangle is within a quarter of a cube of it (three quarters where it
// is right below the seed: a ridge that the mesh cuts off), the triangle's outward normal is on the side of
// -grad f, and f keeps one sign on the way there: if it did not, the triangle would belong to another sheet,
// and the seed's own sheet, thinner than a cube, would be missing. Where f has a crease or a cone's tip at
// the seed (the kernel |x| has one at each of its centers), there is no normal, and the mesh cuts the tip
// off: there a whole cube is near enough.
#pragma once

#include <vector>

#include "core/polygonize/assemble.h"

namespace seesaw {

struct Seed {
  Point<3> at;                          ///< on f = 0, if `on_zero`
  Point<3> outward = Point<3>::Zero();  ///< -grad f there; zero where there is none
  bool on_zero = false;                 ///< f is zero here
  bool on_surface = false;              ///< and the mesh passes here
  bool is_tip = false;                  ///< f has a crease here
};

/// Walks each seed of `points`, 3 x N, to f = 0 by at most `reach`; the ones that lead nowhere stay.
std::vector<Seed> walk_seeds(Sampler& sampler, const Points<3>& points, double reach, double tolerance);

/// Sets `on_surface` of those seeds that do not have it yet. `mesh` is as assembled from `found`.
void find_on_mesh(std::vector<Seed>& seeds, const LatticeMesh& mesh, const Lattice& lattice,
                  const CrossedCubes& found, Sampler& sampler);

/// The same for any mesh, trying all triangles; `cell` is the side of its cubes.
void find_on_mesh(std::vector<Seed>& seeds, const LatticeMesh& mesh, double cell, Sampler& sampler);

/// Finds out which seeds that are not on the surface yet stand on a crease of f.
void find_tips(std::vector<Seed>& seeds, double cell, Sampler& sampler);

/// The distance from p to the nearest face; infinite for no faces.
double distance_to(const LatticeMesh& mesh, const Point<3>& p);

}  // namespace seesaw
