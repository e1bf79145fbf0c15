// The whole differential step of Witkin & Heckbert 1994, section 5, in the paper's order.
//
// Before it: control_points.h and floaters.h, which know nothing of each other.
// After it: sandboxes and figures, which call it once a frame and draw what has become of both.
//
//     points.velocities.col(dragged) = spring_velocity<3>(points.positions.col(dragged), cursor);
//     differential_step(surface, points, floaters);
//     draw(floaters.discs());
#pragma once

#include "core/particles/floaters.h"
#include "core/particles/follow.h"

namespace seesaw {

/// One step of `floaters.options().time_step`:
///   - The caller has set the desired velocities P of the control points, and Q in `options`.
///   - q' follows from them (eqs. 7 and 8, control_points.h).
///   - Repulsion sets the floaters' desired velocities (eq. 9), and q' makes actual ones of them (eq. 5).
///   - Euler's step for q and the control points (in parts where one would be too long: follow.h), then for
///     the floaters.
///   - The floaters' radii (eqs. 10, 12, 13), their fissions and deaths (section 4.4). (The paper computes
///     the radii's change before Euler's step and adds it after; that is the same number.)
/// Returns what it has done to the surface, and which control points it could not follow. Throws what set_q
/// does where not even a part of the step can be taken; then surface, control points and floaters are where
/// they were.
FollowedStep differential_step(ParametricField<3>& field, ControlPoints<3>& points, Floaters& floaters,
                               const ControlOptions& options = {});

}  // namespace seesaw
