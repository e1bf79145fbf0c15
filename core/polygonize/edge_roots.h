// Where f = 0 on a lattice edge whose ends differ in sign; all edges at once.
//
// Before it: assemble.h, which knows the edges.  After it: improve.h and project.h.
//
// The chord's zero, with the value of an end that stays put halved until it moves (the Illinois rule; Dowell
// & Jarratt 1971), and plain halving when even so the bracket will not shrink: three to six evaluations for a
// smooth field to rounding, one or two to a thousandth of the edge, some fifty for any field at all. The
// bracket always holds a change of sign, so the answer is a zero, or a jump through zero.
#pragma once

#include "core/polygonize/sampler.h"

namespace seesaw {

struct Segments {
  Points<3> inside, outside;             ///< 3 x N each
  Values inside_values, outside_values;  ///< f there: >= 0, and < 0 or minus infinity
};

struct EdgeRoots {
  Points<3> positions;  ///< 3 x N; a coordinate that both ends share is shared by the root
  Values uncertainty;  ///< how far, in scene units, the zero may still be: at most `tolerance` if all is well
};

/// `tolerance` is how near to the zero to wait for, in scene units; rounding stops earlier.
EdgeRoots find_edge_roots(Sampler& sampler, const Segments& segments, double tolerance);

}  // namespace seesaw
