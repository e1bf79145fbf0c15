// One attempt at the surface with one size of cube: all but the finishing touches.
//
// Before it: a lattice.  After it: polygonize.cpp tries again with half the cube, or finishes the mesh.
#pragma once

#include "core/polygonize/polygonize.h"
#include "core/polygonize/seeds.h"

namespace seesaw {

/// The lattice that `options` ask for, its range where the surface is to be cut. When no box was given, the
/// lattice itself is larger than its range: the surface may be followed there. n is zero for no surface.
Lattice make_lattice(const Field<3>& field, const Points<3>& seeds, const PolygonizeOptions& options);

/// The same lattice with half the cube.
Lattice halved(const Lattice& lattice);

struct Part {
  LatticeMesh mesh;
  double cell = 0;
};

struct Attempt {
  std::vector<Part> parts;  ///< the surface, and the small components by themselves
  std::vector<Seed> seeds;  ///< those in the range
  Index outside = 0, nowhere = 0, missed = 0;
  Index cubes = 0;
  std::size_t bytes = 0;  ///< that the lattice took
  bool clipped = false;
  PolygonizeTimes times;
};

/// `precision` is how well to find roots on lattice edges, in cubes. Throws TooMuchMemory, Cancelled.
Attempt attempt(Lattice lattice, const Points<3>& seeds, Sampler& sampler, const PolygonizeOptions& options,
                double precision);

}  // namespace seesaw
