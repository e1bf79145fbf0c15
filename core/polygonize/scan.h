// The exhaustive mode: every corner of the range gets a value, layer by layer, so that also components that
// pass through no seed are found.
//
// Before it: a lattice.  After it: assemble.h, as after continuation.h.
#pragma once

#include "core/polygonize/continuation.h"

namespace seesaw {

/// All crossed cubes of the lattice's range, sorted. Costs as many evaluations as the range has corners, and
/// memory for two layers of them beside what is found.
CrossedCubes scan(const Lattice& lattice, Sampler& sampler, const MemoryBound& memory);

/// Whether the surface crosses a face of the lattice's range.
bool crosses_range(const Lattice& lattice, const CrossedCubes& found);

}  // namespace seesaw
