// Leaves out the vertices of a chain that say nothing new.
//
// Before it: trace.h strings all crossings together.  After it: polylines.
//
// Three kinds: vertices that coincide (all crossings at one zero corner), vertices that crowd (a triangle cut
// across a mere corner), and vertices in straight runs through small triangles (beside a corner of the curve,
// or along two thin sheets, where triangles are small for other reasons than the curve's shape). Seeds and
// ends on the box stay.
#pragma once

#include <vector>

#include "core/base/types.h"

namespace seesaw {

/// A vertex of a chain, with what is known of the curve there.
struct Node {
  Point<2> at;
  Point<2> gradient;
  double edge_length;     ///< of the triangle edge it was found on, in scene units
  int corner = -1;        ///< the vertex of the triangulation, when f is exactly zero there
  bool keep = false;      ///< a seed, or an end on the box
  bool on_box = false;    ///< an end on the box
  bool shadowed = false;  ///< a seed beside it takes its place
};

struct ThinLimits {
  double coincident;   ///< nodes this near are one, in scene units
  double longest;      ///< no straight run becomes longer than this, in scene units
  double turn_cosine;  ///< nor turns by more than this
  Box<2> box;
};

/// What is left of the nodes of a chain. When that is too few for a polyline (3 closed, 2 open), only nodes
/// that coincide are left out; when even that leaves too few, the result has too few.
std::vector<Node> thinned(const std::vector<Node>& nodes, bool closed, const ThinLimits& limits);

}  // namespace seesaw
