#include "core/rbf/energy.h"

#include <cmath>

namespace seesaw {

double growth_of(Kernel kernel) {
  switch (kernel) {
    case Kernel::thin_plate_spline:
      return 2.0;
    case Kernel::cubic:
      return 3.0;
    case Kernel::linear:
      return 1.0;
  }
  return 0.0;
}

double energy_factor(Kernel kernel, int dimension) {
  const double n = dimension, b = growth_of(kernel);
  const double common = std::exp2(n + b) * std::pow(M_PI, n / 2) * std::tgamma((b + n) / 2);
  return kernel == Kernel::thin_plate_spline ? common / 2 : common / std::abs(std::tgamma(-b / 2));
}

}  // namespace seesaw
