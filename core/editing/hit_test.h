// What is under the cursor?
//
// Before it: a cursor, the document, its function.  After it: core/editing/desk.h, which grabs it; a drawing,
// which marks what would be grabbed.
//
// Things with a handle (constraints, the free ends of normals' spikes, the ends of the profile line) come
// before lines (the curve, the profile line): one can always grab a constraint on the curve. Among handles
// the nearest wins. Where two are as near to the last bit, a constraint comes before a spike before the
// profile line, and of two constraints in one place the one that was added last, which is drawn on top.
#pragma once

#include <vector>

#include "core/implicit/field.h"
#include "core/scene/document.h"

namespace seesaw {

enum class Over { nothing, constraint, spike, profile_start, profile_end, profile, curve };

/// A line across the curve, along which the function's profile is drawn.
struct ProfileLine {
  Point<2> from = Point<2>::Zero(), to = Point<2>::Zero();  ///< scene units
  bool operator==(const ProfileLine&) const = default;
};

/// All in pixels.
struct Reaches {
  double constraint = 9, spike = 8, profile = 7, curve = 6;
  /// How large symbols are drawn where they have room, and how far from its constraint the free end of a
  /// spike: PictureOptions. Where there is none both are smaller (core/scene/crowding.h).
  double symbol_size = 11, spike_length = 26;
};

struct Hit {
  Over over = Over::nothing;
  /// The constraint, or whose spike; -1 for the others.
  Index which = -1;
  /// Where the thing is, scene units: of a line, the point nearest to the cursor.
  Point<2> at = Point<2>::Zero();
  /// From the cursor to `at`.
  double pixels = 0;
};

/// The free end of a normal's spike as it is drawn; `pixel` in scene units. The constraint has a normal.
Point<2> spike_end(const Constraint<2>& constraint, double spike_length, double pixel);

struct HitScene {
  const Document<2>& document;
  /// What of it is drawn: what one does not see, one does not grab.
  const Display<2>& display;
  const Field<2>* field = nullptr;  ///< null for no curve
  const ProfileLine* profile = nullptr;
  double pixel = 0.01;  ///< scene units
};

/// All that is under the cursor, what is to be grabbed first. Linear in the number of constraints.
std::vector<Hit> hits(const Point<2>& cursor, const HitScene& scene, const Reaches& reaches = {});
/// The first of them, or nothing.
Hit first_hit(const Point<2>& cursor, const HitScene& scene, const Reaches& reaches = {});

}  // namespace seesaw
