// The numbers that steer floaters, with Witkin & Heckbert's letters and recommended values (1994, section 5).
//
// Before it: a user's wish for a density.  After it: floaters.h, and the files of one idea each behind it.
//
// "Most of these parameters can be set once and forgotten. The only parameter that a user would typically
// need to control is the desired repulsion radius." Lengths are fractions of the surface's diameter d, so
// that all of it scales with the surface. Two of the paper's numbers have units that its table does not
// print: rates are per unit of time, of which a step is `time_step`, and beta is compared with dD/dsigma, an
// energy over a length, so ours is 10 / d.
#pragma once

#include <cstdint>

namespace seesaw {

enum class Repulsion {
  simple,             ///< one radius for all, no births, no deaths (section 4.1)
  global_fissioning,  ///< one radius for all; at rest all divide, and the radius shrinks by sqrt 2 (4.2)
  adaptive,           ///< a radius each, births and deaths (4.3, 4.4)
};

struct FloaterOptions {
  Repulsion repulsion = Repulsion::adaptive;

  /// sigma-hat over d, "d/4 or less": the density. Neighbors settle at about 1.75 of it; on a sphere (d = 2.5
  /// radii) there are about 0.67 / desired_radius^2 floaters.
  double desired_radius = 0.25;
  /// d, in scene units; 0: the longest side of the field's bounding box when the floaters begin.
  double diameter = 0;

  double time_step = 0.03;       ///< Delta t
  double adhesion_gain = 15;     ///< phi of eqs. 3 and 5: how fast what is off the surface comes back
  double radius_gain = 15;       ///< rho of eq. 10: how fast radii follow the energy
  double amplitude = 6;          ///< alpha: how strong repulsion is
  double desired_energy = 0.8;   ///< E-hat over alpha; a hexagonal packing two radii apart has 6 e^-2
  double softening = 10;         ///< beta of eq. 12, times d: keeps a lonely floater's radius finite
  double largest_radius = 0.5;   ///< sigma-max over d; at least 1.5 desired_radius. Beyond it: fission
  double equilibrium_speed = 4;  ///< gamma, radii per unit of time: slower ones may divide and die
  double fission_energy = 0.2;   ///< nu, of E-hat: who is this energized and large divides
  double death_radius = 0.7;     ///< delta, of sigma-hat: who is smaller may die

  /// The common radius of simple repulsion over d. 0: the average of the radii there are, which for a
  /// population that was at rest is about the paper's best value, 0.3 sqrt(area / number).
  double simple_radius = 0;
  /// Global fissioning: all divide when half of them are slower than this, in radii per unit of time.
  double generation_speed = 0.5;

  /// Density by curvature (their future work): the angle in radians by which the normal should turn, at most,
  /// from a floater to its neighbor. Where the surface bends more, sigma-hat shrinks. 0: the same everywhere.
  double turn = 0;
  /// ... but never below this fraction of sigma-hat.
  double smallest_fraction = 0.25;

  /// Random numbers decide on directions of fission and on deaths. Same seed, same floaters.
  std::uint64_t seed = 1;
};

}  // namespace seesaw
