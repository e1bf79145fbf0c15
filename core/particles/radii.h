// Repulsion radii grow where it is lonely and shrink where it is crowded.
//
// Before it: energies from repulsion.h.  After it: birth_and_death.h, which divides the large and thins the
// small.
//
// Witkin & Heckbert 1994, section 4.3: D_i, the energy that i's own radius decides, is led to a desired one,
//
//     dD_i/dt     = -rho (D_i - E-hat)                                                        (eq. 10)
//     dsigma_i/dt = (dD_i/dt) / (dD_i/dsigma_i + beta)                                        (eq. 12)
//
// beta keeps a lonely floater's radius from jumping (eq. 11 has none, and divides by zero there). One step of
// Euler's may overshoot where a newborn's energy is far too large: no radius shrinks by more than half in a
// step, none grows past twice the largest.
#pragma once

#include "core/base/types.h"

namespace seesaw {

struct RadiusRule {
  double gain = 15;           ///< rho, per unit of time
  double desired_energy = 0;  ///< E-hat
  double softening = 0;       ///< beta, per scene unit
  double largest = 0;         ///< sigma-max, scene units
};

/// The radii (N, scene units) after `time_step`; `own` D_i and `own_slope` dD_i/dsigma_i, N.
inline Values next_radii(const Values& radii, const Values& own, const Values& own_slope,
                         const RadiusRule& rule, double time_step) {
  const auto rates = rule.gain * (rule.desired_energy - own.array()) / (own_slope.array() + rule.softening);
  return (radii.array() + time_step * rates).max(0.5 * radii.array()).min(2 * rule.largest);
}

}  // namespace seesaw
