// What stands on the plate: poles at the constraints, and the profile along a line with its curtain.
//
// A pole goes from the zero plane to the height that its constraint asks for, and the plate touches its head.
// A boundary constraint asks for zero, so it is a head alone; its normal constraint is a short pole beside
// it, at `at - offset * direction`, section 4.3 of Turk and O'Brien 2002.
//
// Before it: plate_mesh.h, whose PlateSpace says where things are.  After it: plate.h draws them.
#pragma once

#include <vector>

#include "core/editing/hit_test.h"
#include "core/mesh/triangle_mesh.h"
#include "sandbox2d/plate_mesh.h"

namespace seesaw {

struct PlatePole {
  Point<3> foot = Point<3>::Zero(), head = Point<3>::Zero();  ///< view units
  bool open = false;   ///< a boundary constraint's head: a ring, as on paper
  bool small = false;  ///< of a normal constraint
  bool highlight = false;
};

/// The poles of all constraints in `box`, in the document's order. Heads beyond the limit stand at it.
std::vector<PlatePole> plate_poles(const Document<2>& document, const PlateSpace& space, const Box<2>& box);

/// The profile on the plate, view units; empty where the line does not pass the box.
struct PlateProfile {
  /// 3 x N along the line, from `from` to `to`.
  Points<3> line = Points<3>(3, 0);
  /// The upright areas between it and the zero plane.
  TriangleMesh above, below;
};

PlateProfile plate_profile(const Field<2>& field, const ProfileLine& line, const PlateSpace& space,
                           const Box<2>& box, Index samples = 161);

}  // namespace seesaw
