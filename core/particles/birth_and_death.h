// Large floaters divide, crowded ones die.
//
// Before it: radii.h's radii, repulsion.h's energies, and how fast floaters move.
// After it: floaters.h carries the decisions out.
//
// Witkin & Heckbert 1994, section 4.4. Only who is near equilibrium, slower than gamma sigma_i, is asked:
//
//     divides  iff  sigma_i > sigma-max,  or  D_i > nu E-hat and sigma_i > sigma-hat
//     dies     iff  sigma_i < delta sigma-hat  and  R > sigma_i / (delta sigma-hat),  R uniform in (0, 1)
//
// "The death criteria are made stochastic to prevent mass suicide in overcrowded regions." Both halves of a
// division get sigma_i / sqrt 2: half the area each. The paper leaves them in one place and gives them
// desired velocities in random directions; we let them walk (walk.h) 0.3 of the new radius in opposite random
// directions at once, which is the same after a step and never leaves two floaters in one point, where
// repulsion has no direction.
#pragma once

#include <vector>

#include "core/base/random.h"
#include "core/base/types.h"

namespace seesaw {

enum class Fate : char { stays, divides, dies };

struct LifeRule {
  double equilibrium_speed = 4;  ///< gamma, radii per unit of time
  double largest = 0;            ///< sigma-max, scene units
  double energized = 0;          ///< nu E-hat
  double death_radius = 0.7;     ///< delta
};

/// All N: `radii` sigma_i, `desired` sigma-hat for each (both scene units), `own` D_i, `speeds` scene units
/// per unit of time. Draws from `random` once for each candidate for death, in order.
std::vector<Fate> fates(const Values& radii, const Values& desired, const Values& own, const Values& speeds,
                        const LifeRule& rule, Random& random);

/// How far from its parent a newborn is set, in new radii.
inline constexpr double birth_distance = 0.3;

/// A random unit vector square to `normal` (unit).
Point<3> tangent_direction(const Point<3>& normal, Random& random);

}  // namespace seesaw
