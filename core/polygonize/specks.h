// What has nothing inside is no surface: f may touch zero from below, in a point (-|x|^2), along a line or a
// sheet (-x^2).
//
// Before it: assemble.h, which wraps a skin of no thickness around such zeros where they meet lattice
// corners. After it: the mesh without these skins.
#pragma once

#include "core/polygonize/assemble.h"

namespace seesaw {

/// Drops the components whose vertices all stand on exact zeros none of which has a neighbor on the lattice
/// where f > 0.
void drop_specks(LatticeMesh& mesh, const Lattice& lattice, Sampler& sampler);

}  // namespace seesaw
