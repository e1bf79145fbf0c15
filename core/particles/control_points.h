// Control points: points of the surface that somebody moves, and the motion of the surface that follows them.
//
// Before it: core/implicit/parametric.h, a surface with parameters q, and a mouse.
// After it: differential_step.h moves the surface, and floaters follow it.
//
// Witkin & Heckbert 1994, section 3.4. Control point i at p_i is to move at the velocity P_i. It stays on f =
// 0 if f_x . P_i + f_q . q' = 0 there, plus the feedback phi f that brings back what has drifted off (eq. 3).
// Of all q' that do this for all points take the one nearest to Q, the motion that the surface would make by
// itself (zero, usually), in the metric M (metric.h). With J the m x n matrix of the columns f_q(p_i):
//
//     J' M^-1 J lambda = J' Q + f_x . P + phi f          (eq. 7; the paper has M = 1)
//     q' = Q - M^-1 J lambda                             (eq. 8)
//
// Each equation is divided by |f_x|. That changes no solution, and gives misses a unit: how fast the surface
// leaves the point, in scene units per unit of time.
//
// "The matrix can become singular if inconsistent or redundant constraints are applied, that is if the number
// of constraints exceeds m, or if some of the F_q are linear combinations of others. ... [This] can be
// circumvented by using a least-squares technique." So: Cholesky first. Where there are more points than
// parameters, or where a pivot falls below `rank_tolerance` of the largest f_q / |f_x| (or below 1e-4, which
// is 1e-8 in the matrix, whose rounding would leave few digits), an orthogonal decomposition of J itself
// takes over. Of the motions that miss the points least, in the mean square, it takes the one nearest to Q.
// What lies within `rank_tolerance` of being a combination of others counts as one.
//
// Short of that, points that nearly depend on each other are followed by huge motions of all that they do not
// pin down, and Euler's step then throws the surface away: of 300 random drags among five points, about 2 %
// did. So motions have a largest speed, and the points are slowed with them; follow.h looks after the rest.
#pragma once

#include <vector>

#include "core/implicit/parametric.h"
#include "core/particles/metric.h"

namespace seesaw {

template <int Dim>
struct ControlPoints {
  Points<Dim> positions = Points<Dim>(Dim, 0);   ///< p_i, Dim x n, scene units, on the surface or near it
  Points<Dim> velocities = Points<Dim>(Dim, 0);  ///< P_i, Dim x n, scene units per unit of time

  Index size() const { return positions.cols(); }
  /// Appends one that is at rest; returns its index.
  Index add(const Point<Dim>& position);
  /// Those after it move up.
  void remove(Index index);
};

struct ControlOptions {
  /// phi of eqs. 3 and 7, per unit of time.
  double adhesion_gain = 15;
  /// Q, m: the parameters' rates if nobody pulled, "zero to minimize parametric change in the surface, but
  /// they could also be calculated to attract the surface toward a default shape". Empty: zero.
  Values desired_rates = Values();
  /// M, for the m free parameters.
  Metric metric = {};
  /// Relative to the largest f_q / |f_x| (in the metric): see above. Smaller follows points that are nearly
  /// one more faithfully, with motions that are the larger for it.
  double rank_tolerance = 1e-3;
  /// |q' - Q| (in the metric) times the largest f_q / |f_x| is a speed: how fast some point of the surface
  /// would move if it felt all of the motion. It is held below this many sizes of the surface (its bounding
  /// box's longest side) per unit of time.
  double largest_speed = 3;
  /// follow.h takes a step in parts where a point would end farther off the surface than this many sizes of
  /// the surface (and farther than it was before).
  double largest_miss = 3e-3;
  /// The smallest part is the step over 2 to this power.
  int most_halvings = 4;
};

/// How eq. 7 was solved.
enum class ControlMethod {
  none,           ///< no points, or no free parameters
  cholesky,       ///< all points can be followed
  least_squares,  ///< some depend on others
};

struct SurfaceMotion {
  Values q_rates = Values();  ///< q', m, parameters per unit of time
  ControlMethod method = ControlMethod::none;
  Index rank = 0;  ///< how many points are independent of each other
  /// By how much q' - Q was scaled down to `largest_speed`; 1: not at all.
  double slowed = 1;
  /// By which each point is missed: (f_x . P + f_q . q' + phi f) / |f_x|, n, scene units per unit of time.
  Values residuals = Values();
  /// Points that ask for nothing new: what the others ask for moves the surface as these want it too. Which
  /// one of several points that depend on each other is named is a matter of chance. Ascending.
  std::vector<Index> redundant = {};
  /// Points that cannot be followed, since others ask for something else or no free parameter moves the
  /// surface there: they are missed by more than 1e-4 of the fastest motion asked for. All parties to a
  /// contradiction are named. Ascending.
  std::vector<Index> contradictory = {};
};

/// Eqs. 6 to 8. O(m n^2 + n^3), and n columns of q_gradients.
template <int Dim>
SurfaceMotion surface_motion(const ParametricField<Dim>& field, const ControlPoints<Dim>& points,
                             const ControlOptions& options = {});

/// Euler's step: the surface moves by `time_step` q', then the points by `time_step` P (times
/// `motion.slowed`: where the surface is slowed down the points wait for it). Where set_q throws nothing has
/// moved.
template <int Dim>
void advance(ParametricField<Dim>& field, ControlPoints<Dim>& points, const SurfaceMotion& motion,
             double time_step);

/// The velocity of a control point that is dragged (section 5): "proportional to the vector from the point to
/// the 3-D cursor position. This in effect provides spring coupling". `gain` per unit of time, which the
/// paper does not give: at 5 a point makes 15 % of its way in a step of 0.03. Never faster than `most`, scene
/// units per unit of time, for a cursor that jumps.
template <int Dim>
Point<Dim> spring_velocity(const Point<Dim>& point, const Point<Dim>& cursor, double gain = 5,
                           double most = infinity) {
  const Point<Dim> velocity = gain * (cursor - point);
  const double speed = velocity.norm();
  return speed > most ? Point<Dim>(velocity * (most / speed)) : velocity;
}

extern template struct ControlPoints<2>;
extern template struct ControlPoints<3>;

}  // namespace seesaw
