// A step of the surface and its control points in which no point comes off the surface.
//
// Before it: control_points.h, which says how fast parameters have to move now.
// After it: differential_step.h, which does this once a frame.
//
// Witkin & Heckbert 1994, section 5: q' follows from the points' velocities P, and Euler's step moves both.
// That is right to first order; the points come off the surface by what is of second order, and the feedback
// phi brings them back. It fails in two ways, and both throw the surface away, not just the point:
//
//   - Euler's step is too long for a motion that turns quickly. So the step is taken, and where a point has
//     come off by more than `largest_miss` it is taken back and taken in halves, quarters, ..., with
//     q' computed anew for each.
//   - Nothing that the parameters can do lets the surface follow: what is asked for would tear it away from
//     the other points. So the points stand still for the rest of the step, and feedback alone moves the
//     surface. A dragged point then waits on the surface, short of its cursor, until it is dragged elsewhere.
//
// And where a motion is slowed down to `largest_speed` the points are slowed with it: what moves a point at
// full speed off a surface that follows at a tenth of it is not a drag.
//
// Of 300 random drags of one among eight points, on 13 to 28 parameters, Euler's step alone left 4 to 12 in a
// hundred with a point off the surface, by as much as 30 sizes of it. With this no point of 1,800 such drags
// was ever farther off than `largest_miss`, for 1.0 to 1.1 solutions of eq. 7 a step. (Two cylinders have
// shapes enough to follow nine drags in ten to their cursors; in the tenth the point waits.)
#pragma once

#include "core/particles/control_points.h"

namespace seesaw {

/// What a step has done.
struct FollowedStep {
  /// As eqs. 7 and 8 had it at the start of the step.
  SurfaceMotion motion = {};
  /// The mean of q' over the step, m: what floaters feel. motion.q_rates itself where the step was one part.
  Values q_rates = Values();
  /// How many of Euler's steps it took; 1: the paper's own.
  int parts = 1;
  /// The points stood still for some of the time, since the surface could not follow.
  bool waited = false;
};

/// Moves field and points on by `time_step`. `motion`: what surface_motion says of them as they are. Their
/// velocities are what is asked for and stay as they are. Throws what set_q does where not even the smallest
/// part of a step is possible for it; then nothing has moved. Cost: one set_q, and eqs. 6 to 8 and a set_q
/// for each part more.
template <int Dim>
FollowedStep follow(ParametricField<Dim>& field, ControlPoints<Dim>& points, const SurfaceMotion& motion,
                    double time_step, const ControlOptions& options = {});

}  // namespace seesaw
