#include "core/particles/differential_step.h"

namespace seesaw {

FollowedStep differential_step(ParametricField<3>& field, ControlPoints<3>& points, Floaters& floaters,
                               const ControlOptions& options) {
  const auto choose_velocities = [&](const Values& q_rates) {
    floaters.choose_velocities(field,
                               q_rates.isZero(0) ? Values() : field.rates(floaters.positions(), q_rates));
  };
  const SurfaceMotion motion = surface_motion(field, points, options);
  choose_velocities(motion.q_rates);
  const Values q = field.q();
  const FollowedStep step = follow(field, points, motion, floaters.options().time_step, options);
  if (step.q_rates != motion.q_rates) {
    // It moved otherwise than announced: the floaters choose again, on the surface as it was.
    const Values moved = field.q();
    field.set_q(q);
    choose_velocities(step.q_rates);
    field.set_q(moved);
  }
  floaters.move(field);
  return step;
}

}  // namespace seesaw
