// A small closed component on which a seed stands, between the corners of the lattice.
//
// Before it: seeds.h has found that the mesh does not pass through the seed.  After it: one more mesh beside
// the large one, or the knowledge that this is no small component and the whole lattice must be finer.
//
// Lattices of half the cube, a quarter, ... down to a 64th are laid around the seed, two cubes to every side,
// and the component through the seed is followed on them: from no cube but the seed's own, so that a
// neighboring sheet does not get in the way. Found is a component that closes, is a good number of its cubes
// across, passes through the seed as seeds.h asks, and holds no corner of the large lattice: then the large
// lattice has nothing of it, and the two meshes are apart.
#pragma once

#include "core/polygonize/seeds.h"

namespace seesaw {

struct SmallSearch {
  enum class Answer {
    found,    ///< `mesh` is the component
    nothing,  ///< f changes its sign nowhere near the seed
    large     ///< there is a surface, but no small closed component
  };
  Answer answer = Answer::nothing;
  LatticeMesh mesh;
  double cell = 0;  ///< side of the cubes that made it
};

/// `tolerance` as in assemble.h, as a fraction of the cube.
SmallSearch find_small(const Seed& seed, const Lattice& lattice, Sampler& sampler, const MemoryBound& memory,
                       double tolerance);

}  // namespace seesaw
