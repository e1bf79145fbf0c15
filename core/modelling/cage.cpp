#include "core/modelling/cage.h"

#include <cmath>

#include "core/base/check.h"

namespace seesaw {

namespace {
constexpr double pi = 3.141592653589793;
}

Constraints<2> circle_cage(const Point<2>& center, double radius, int count, double start, double value) {
  SEESAW_CHECK_LT(0.0, radius);
  SEESAW_CHECK_LE(1, count);
  SEESAW_CHECK_LT(value, 0.0);
  Constraints<2> cage;
  for (int i = 0; i < count; ++i) {
    const double angle = start + 2 * pi * i / count;
    cage.push_back(exterior<2>(center + radius * Point<2>(std::cos(angle), std::sin(angle)), value));
  }
  return cage;
}

Constraints<3> sphere_cage(const Point<3>& center, double radius, int count, double value) {
  SEESAW_CHECK_LT(0.0, radius);
  SEESAW_CHECK_LE(1, count);
  SEESAW_CHECK_LT(value, 0.0);
  // Each step turns by the golden angle, so that no two turns of the spiral line up.
  const double golden_angle = pi * (3 - std::sqrt(5.0));
  Constraints<3> cage;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2.0 * i + 1) / count, ring = std::sqrt(1 - z * z);
    const double angle = golden_angle * i;
    cage.push_back(
        exterior<3>(center + radius * Point<3>(ring * std::cos(angle), ring * std::sin(angle), z), value));
  }
  return cage;
}

Constraints<3> cube_cage(const Point<3>& center, double side, int along, double value) {
  SEESAW_CHECK_LT(0.0, side);
  SEESAW_CHECK_LE(2, along);
  SEESAW_CHECK_LT(value, 0.0);
  Constraints<3> cage;
  const auto on_rim = [&](int i) { return i == 0 || i == along - 1; };
  const auto at = [&](int i) { return side * (static_cast<double>(i) / (along - 1) - 0.5); };
  for (int z = 0; z < along; ++z)
    for (int y = 0; y < along; ++y)
      for (int x = 0; x < along; ++x)
        if (on_rim(x) || on_rim(y) || on_rim(z))
          cage.push_back(exterior<3>(center + Point<3>(at(x), at(y), at(z)), value));
  return cage;
}

}  // namespace seesaw
