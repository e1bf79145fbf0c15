// A small closed component on which a seed stands, between the corners of the lattice.
//
// Before it: seeds.h has found that the mesh does not pass through the seed.  After it: one more mesh beside
// the large one, or the knowledge that this is no small component and the whole lattice must be finer.
//
// Lattices of half the cube, a quarter, ... down to a 16384th are laid around the seed, two cubes to every
// side, and the component through the seed is followed on them: from no cube but the seed's own, so that a
// neighboring sheet does not get in the way. Found is a component that closes, is a good number of its cubes
// across, and passes through the seed as seeds.h asks.
//
// What the large lattice has of it must go. If no corner of the large lattice is inside, it has nothing. If
// one is, the large mesh has a component, most likely a crude one, all of whose vertices stand on the fine
// one: that is replaced. If it has not, it must have mistaken two components for one, and only a finer
// lattice everywhere will help.
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
  bool holds_corner = false;  ///< a corner of the large lattice is inside of it
  double cell = 0;            ///< side of the cubes that made it
};

/// `tolerance` as in assemble.h, as a fraction of the cube.
SmallSearch find_small(const Seed& seed, const Lattice& lattice, Sampler& sampler, const MemoryBound& memory,
                       double tolerance);

/// Takes the components out of `large` whose vertices all stand on `small`; false when there are none.
bool remove_crude(LatticeMesh& large, const SmallSearch& small);

}  // namespace seesaw
