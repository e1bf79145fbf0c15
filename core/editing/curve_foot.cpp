#include "core/editing/curve_foot.h"

#include <cmath>

namespace seesaw {

std::optional<Point<2>> curve_foot(const Field<2>& field, const Point<2>& p, double reach) {
  if (!p.allFinite() || !(reach > 0)) return std::nullopt;
  Values value(1);
  Points<2> gradient(2, 1);
  Point<2> x = p, best = p;
  double nearest_to_zero = infinity, slope = 0;
  // First perpendicularity and f = 0 together, then f = 0 alone, to the last digits.
  constexpr int along_too = 8, in_all = 14;
  for (int step = 0; step < in_all; ++step) {
    field.evaluate(x, value, gradient);
    const double square = gradient.col(0).squaredNorm();
    if (!std::isfinite(value[0]) || !(square > 0) || !std::isfinite(square)) {
      // A constraint may stand where the function has no gradient: a cone's tip, a flat top.
      if (value[0] != 0) return std::nullopt;
      best = x, nearest_to_zero = 0;
      break;
    }
    if (step == 0 && std::abs(value[0]) > 2 * reach * std::sqrt(square)) return std::nullopt;
    if (step >= along_too && std::abs(value[0]) < nearest_to_zero) {
      best = x, nearest_to_zero = std::abs(value[0]), slope = std::sqrt(square);
      if (value[0] == 0) break;
    }
    Point<2> next = x - value[0] / square * gradient.col(0);
    if (step < along_too) {
      const Point<2> tangent = Point<2>(-gradient(1, 0), gradient(0, 0)) / std::sqrt(square);
      next += tangent.dot(p - x) * tangent;
    }
    x = next;
    if (!((x - p).norm() <= 2 * reach)) return std::nullopt;
  }
  if (nearest_to_zero > 1e-9 * reach * slope || !((best - p).norm() <= reach)) return std::nullopt;
  return best;
}

}  // namespace seesaw
