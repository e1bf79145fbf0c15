#include "core/modelling/foot_points.h"

#include <cmath>
#include <vector>

namespace seesaw {

namespace {

double first_order(double value, const Point<3>& gradient) {
  if (value == 0) return 0;
  const double slope = gradient.norm();
  return slope > 0 ? std::abs(value) / slope : infinity;
}

}  // namespace

Values first_order_distances(const Field<3>& field, const PointsRef<3>& points) {
  Values values(points.cols());
  Points<3> gradients(3, points.cols());
  field.evaluate(points, values, gradients);
  for (Index i = 0; i < points.cols(); ++i) values[i] = first_order(values[i], gradients.col(i));
  return values;
}

Values foot_distances(const Field<3>& field, const PointsRef<3>& points, double reach) {
  SEESAW_CHECK_LT(0.0, reach);
  Values result = Values::Zero(points.cols());
  Points<3> at = points;
  std::vector<Index> walking(static_cast<std::size_t>(points.cols()));
  for (std::size_t i = 0; i < walking.size(); ++i) walking[i] = static_cast<Index>(i);
  for (int step = 0; step < 20 && !walking.empty(); ++step) {
    const Index n = static_cast<Index>(walking.size());
    Points<3> x(3, n), gradients(3, n);
    for (Index k = 0; k < n; ++k) x.col(k) = at.col(walking[static_cast<std::size_t>(k)]);
    Values values(n);
    field.evaluate(x, values, gradients);
    std::vector<Index> next;
    for (Index k = 0; k < n; ++k) {
      const Index i = walking[static_cast<std::size_t>(k)];
      const double left = first_order(values[k], gradients.col(k));
      const double gone = (x.col(k) - points.col(i)).norm();
      result[i] = gone + left;
      // Two digits of what was gone are enough, and nothing at all is left to find below rounding.
      if (!std::isfinite(left) || left <= 0.01 * gone || left <= 1e-9 * reach) continue;
      const Point<3> direction = -std::copysign(1.0, values[k]) * gradients.col(k).normalized();
      at.col(i) += std::min(left, reach) * direction;
      next.push_back(i);
    }
    walking = std::move(next);
  }
  return result;
}

std::optional<Point<3>> foot_point(const Field<3>& field, const Point<3>& from, double tolerance) {
  Point<3> x = from;
  double before = infinity;
  Values value(1);
  Points<3> gradient(3, 1);
  for (int step = 0; step < 60; ++step) {
    field.evaluate(x, value, gradient);
    const double left = first_order(value[0], gradient);
    if (left <= tolerance) return x;
    if (!std::isfinite(left)) return std::nullopt;
    // Steps that no longer shrink, of a size that only rounding explains.
    if (left >= before && left <= 1e3 * tolerance) return x;
    before = left;
    x -= value[0] / gradient.squaredNorm() * gradient.col(0);
  }
  return std::nullopt;
}

}  // namespace seesaw
