// Several constraints at once: along a line, on a circle, around everything.
//
// Before it: a line or a circle that was dragged.  After it: one Add.
//
// Turk & O'Brien 2002, section 9: "Perhaps several new constraints could be created simultaneously, maybe
// arranged in a line or in a circle for greater surface control." Section 4.2: a circle of exterior
// constraints is the start "best suited to interactive free-form design".
#pragma once

#include "core/scene/document.h"

namespace seesaw {

/// A constraint as it is placed: f is 0, 1 or -1 by its kind.
Constraint<2> fresh(ConstraintKind kind, const Point<2>& at);

/// `count` >= 1 points evenly from `from` to `to`, both included (exactly); one alone stands in the middle.
/// 2 x count.
Points<2> points_on_line(const Point<2>& from, const Point<2>& to, int count);

/// `count` >= 1 points evenly on the circle, counter-clockwise, the first at `rim` exactly. 2 x count.
Points<2> points_on_circle(const Point<2>& center, const Point<2>& rim, int count);

/// A circle of `count` exterior constraints around all others of the document, in the proportions of Fig. 4:
/// 1.6 times the radius of what they surround. Exterior constraints that are there do not count, so a second
/// cage is the first. Around `view` where there is nothing to surround.
Constraints<2> cage_around(const Document<2>& document, const Box<2>& view, int count = 8);

/// Those of `constraints` that stand nowhere where the document, or one before them, has one.
Constraints<2> without_doubles(const Constraints<2>& constraints, const Document<2>& document);

}  // namespace seesaw
