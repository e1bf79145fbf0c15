#include "core/particles/birth_and_death.h"

#include "core/base/check.h"

namespace seesaw {

std::vector<Fate> fates(const Values& radii, const Values& desired, const Values& own, const Values& speeds,
                        const LifeRule& rule, Random& random) {
  const Index n = radii.size();
  SEESAW_CHECK_EQ(desired.size(), n);
  SEESAW_CHECK_EQ(own.size(), n);
  SEESAW_CHECK_EQ(speeds.size(), n);
  std::vector<Fate> result(static_cast<std::size_t>(n), Fate::stays);
  for (Index i = 0; i < n; ++i) {
    if (!(speeds[i] < rule.equilibrium_speed * radii[i])) continue;
    Fate& fate = result[static_cast<std::size_t>(i)];
    const double smallest = rule.death_radius * desired[i];
    if (radii[i] > rule.largest || (own[i] > rule.energized && radii[i] > desired[i]))
      fate = Fate::divides;
    else if (radii[i] < smallest && random.uniform() > radii[i] / smallest)
      fate = Fate::dies;
  }
  return result;
}

Point<3> tangent_direction(const Point<3>& normal, Random& random) {
  Point<3> tangent;
  do {
    const Point<3> direction = random.direction<3>();
    tangent = direction - normal.dot(direction) * normal;
  } while (tangent.squaredNorm() < 1e-4);
  return tangent.normalized();
}

}  // namespace seesaw
