// Prisms upon prisms: the branching surface of Fig. 2 (right) of Turk & O'Brien 2002.
//
// Before it: how many generations, and how a child stands on its parent.
// After it: core/rbf/fit.h makes the smooth surface; the prisms themselves are drawn as an inset.
//
// Section 4.1: "Each of the six vertices of a large prism specified the location of a zero-valued constraint,
// and a single interior constraint was placed in the center of this prism. Next, three smaller and slightly
// tilted prisms were placed atop the first large prism [...] and so on." The measures are ours: the paper
// prints none. A child all but touches its parent, by a corner where it leans outward. With the defaults the
// surface is in one piece and without holes for 1 to 6 generations, and stays so when any one measure changes
// by a tenth or the gap by 0.06. Children that touch (a gap of 0.01 or less) or are much larger make handles;
// the same value in every prism, and much taller prisms, cut the last generation off.
#pragma once

#include "core/mesh/triangle_mesh.h"
#include "core/rbf/constraints.h"

namespace seesaw {

struct BranchingPrismsOptions {
  /// 1 is the large prism alone; g generations are (3^g - 1) / 2 prisms.
  int generations = 4;
  /// Of the large prism: circumradius of its triangles, and height.
  double radius = 1.0;
  double height = 1.6;
  /// A child's measures over its parent's.
  double shrink = 0.52;
  /// How far a child leans away from its parent's axis, in degrees.
  double tilt = 30.0;
  /// Where a child's foot has its middle: so many parent radii from the parent's axis toward a corner.
  double spread = 0.75;
  /// What is left between a child's foot and its parent's top where they are nearest, along the parent's axis
  /// and in parent radii. 0: they touch.
  double gap = 0.08;
  /// f at the center of the large prism. A child's is `shrink` times its parent's, so that f is as steep in
  /// the twigs as in the trunk.
  double value = 1.0;
};

struct BranchingPrisms {
  /// Prism after prism, parents first: six boundary constraints (foot, then top), then one interior.
  Constraints<3> constraints;
  /// Every prism as a closed mesh of 6 vertices and 8 triangles of its own.
  TriangleMesh prisms;
};

/// The large prism's foot is centered at the origin, its axis is +z. 1 <= generations <= 8.
BranchingPrisms branching_prisms(const BranchingPrismsOptions& options = {});

}  // namespace seesaw
