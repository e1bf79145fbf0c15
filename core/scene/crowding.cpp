#include "core/scene/crowding.h"

#include <algorithm>
#include <cmath>

namespace seesaw {

double usual_spacing(const Document<2>& document) {
  const std::size_t n = document.constraints.size();
  if (n < 100) return infinity;
  std::vector<double> nearest;
  for (std::size_t i = 0; i < n; i += n / 100) {
    const Point<2>& here = document.constraints[i].constraint.at;
    double least = infinity;
    for (std::size_t j = 0; j < n; ++j)
      if (j != i) least = std::min(least, (here - document.constraints[j].constraint.at).squaredNorm());
    nearest.push_back(std::sqrt(least));
  }
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
  std::ranges::nth_element(nearest, middle);
  return *middle;
}

double symbol_share(double usual_spacing, double scale, double wanted) {
  return std::clamp(0.7 * scale * usual_spacing / wanted, 0.3, 1.0);
}

}  // namespace seesaw
