// Floaters walk along the surface and stay on their own sheet of it.
//
// Before it: points on the surface (or where the moving surface has just left them), and how far each wants
// to go. After it: floaters.h and birth_and_death.h, which move floaters in no other way.
//
// A tangential step leaves a curved surface, and Newton's way back (adhesion.h) may end on another sheet:
// the far side of a thin wall, or another component. Witkin & Heckbert do not say what then; with pioneers
// whose steps are half the size of the surface it happens all the time. So long ways go in pieces, at most
// half a desired radius each, each followed by Newton, and the rest of the way turns with the tangent plane.
// A piece counts when
//   - Newton came no farther than three quarters of the piece, plus what the surface's own motion is allowed;
//   - the normal turned by less than 127 degrees (edges must be passable, unless they are sharp as a knife);
//   - half-way, if the piece is long, the surface is near too: between two components it is not.
// A piece that fails is halved, twice, and then given up: the floater stays where it last was on f = 0.
#pragma once

#include <vector>

#include "core/implicit/field.h"

namespace seesaw {

struct Ways {
  Points<3> from = Points<3>(3, 0);     ///< 3 x N, scene units
  Points<3> normals = Points<3>(3, 0);  ///< 3 x N, outward, unit: of the sheet that each is on
  Points<3> by = Points<3>(3, 0);       ///< 3 x N, tangential, scene units
  /// The length of a floater's desired spacing, N, scene units: pieces are up to half of it.
  Values grain;
  /// How far from `from` the surface may be found, N, scene units: 0 where it cannot have moved.
  Values leashes;
};

struct Walked {
  Points<3> positions = Points<3>(3, 0);  ///< `from` where not on
  Points<3> normals = Points<3>(3, 0);    ///< outward, unit; as they came where not on
  std::vector<char> on;                   ///< whether the floater's sheet was found
};

/// |f| / |grad f| of what is on the surface is at most this times `grain`.
inline constexpr double walk_tolerance = 1e-4;
/// No way is longer than this times `grain`; longer ones end there.
inline constexpr double longest_way = 4;

Walked walk(const Field<3>& field, const Ways& ways);

}  // namespace seesaw
