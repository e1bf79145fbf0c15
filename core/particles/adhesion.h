// What keeps a floater on a surface, also while the surface moves.
//
// Before it: a field, points on or near f = 0, and how fast f changes where they are.
// After it: walk.h moves floaters along the surface; floaters.h puts the step together.
//
// Witkin & Heckbert 1994, section 3.3: of all velocities that keep f = 0 in first order, and that lead back
// to it at the rate phi where it is not, take the one nearest to the desired velocity P:
//
//     p' = P - (f_x . P + f_t + phi f) / (f_x . f_x) f_x,        f_t = f_q . q'                   (eq. 5)
//
// It is linear in f, so it holds in our sign (f > 0 inside) as it does in theirs. The part along P is the
// tangential one of P; the rest, `following`, goes along the normal.
//
// Velocities alone leave an error of second order in every step, and feedback removes only a part of it a
// step. So after each step floaters are also put on f = 0 by Newton's iteration along the gradient
// (`put_on`), within a leash: a floater that f = 0 has left far behind must not be dragged to some other
// surface.
#pragma once

#include <vector>

#include "core/implicit/field.h"

namespace seesaw {

/// f and its gradient where floaters are.
struct Contact {
  Values values;                          ///< f, N
  Points<3> gradients = Points<3>(3, 0);  ///< 3 x N; zero where f or the gradient is not finite
  /// Whether there is a gradient to speak of: more than 1e-5 of the median. "When the gradient is near zero
  /// the surface is locally ill-defined, and it is best to leave such floaters motionless" (section 5).
  std::vector<char> definite;

  Index size() const { return values.size(); }
  /// |f| / |grad f|, the distance from the surface in first order, N, scene units; infinite where not
  /// definite unless f is exactly 0.
  Values distances() const;
  /// Outward unit normals, 3 x N; zero where not definite.
  Points<3> normals() const;
};

/// Evaluates at `positions` (3 x N), on all cores.
Contact touch(const Field<3>& field, const PointsRef<3>& positions);

/// The normal part of eq. 5, -(f_t + phi f) f_x / |f_x|^2, 3 x N, scene units per unit of time; zero where
/// not definite. `rates` f_t, N, or empty for a surface at rest.
Points<3> following(const Contact& contact, const Values& rates, double adhesion_gain);

/// The tangential part of P: P - (f_x . P) f_x / |f_x|^2, 3 x N; zero where not definite.
Points<3> along(const Contact& contact, const Points<3>& desired);

struct PutOn {
  Points<3> positions = Points<3>(3, 0);  ///< where `on`, on f = 0; elsewhere as they came
  Points<3> gradients = Points<3>(3, 0);  ///< 3 x N; not meaningful where not on
  std::vector<char> on;
  Values moved;  ///< how far, N, scene units
};

/// Newton along the gradient, at most ten steps: a point is `on` when |f| / |grad f| <= its `tolerances` and
/// it has come no farther than its `leashes`, both N, scene units. A step is at most half the leash, and
/// halved where |f| does not shrink. One evaluation for points that are on already.
PutOn put_on(const Field<3>& field, const PointsRef<3>& positions, const Values& leashes,
             const Values& tolerances);

}  // namespace seesaw
