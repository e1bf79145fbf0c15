// A mesh without needles. A lattice cuts a surface into slivers wherever it passes close to a corner.
//
// Before it: assemble.h.  After it: project.h brings every vertex onto f = 0 to rounding.
//
// Three moves, none of which changes the topology or turns a triangle over: short edges collapse
// (collapse.h), edges flip (flip.h), vertices slide along the surface (slide.h). Flips and slides take turns,
// and in the end the few needles that are left collapse. Vertices on the box's faces do not move.
#pragma once

#include "core/polygonize/assemble.h"

namespace seesaw {

/// Collapses edges of no length, which exact zeros at lattice corners leave behind.
void collapse_empty_edges(LatticeMesh& mesh, double cell);

/// All three moves; `cell` is the side of a cube.
void improve(LatticeMesh& mesh, Sampler& sampler, double cell);

}  // namespace seesaw
