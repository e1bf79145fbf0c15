#include "core/particles/differential_step.h"

namespace seesaw {

SurfaceMotion differential_step(ParametricField<3>& field, ControlPoints<3>& points, Floaters& floaters,
                                const ControlOptions& options) {
  const SurfaceMotion motion = surface_motion(field, points, options);
  const bool at_rest = motion.q_rates.isZero(0);
  floaters.choose_velocities(field, at_rest ? Values() : field.rates(floaters.positions(), motion.q_rates));
  advance(field, points, motion, floaters.options().time_step);
  floaters.move(field);
  return motion;
}

}  // namespace seesaw
