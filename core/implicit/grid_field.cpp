#include "core/implicit/grid_field.h"

#include <algorithm>
#include <cmath>

namespace seesaw {

namespace {

// Hermite's cubics at t in 0 .. 1: of the value and slope at 0, and at 1; and their derivatives.
struct Hermite {
  double v0, s0, v1, s1;
};
Hermite hermite(double t) {
  const double u = 1 - t;
  return {u * u * (1 + 2 * t), t * u * u, t * t * (3 - 2 * t), -t * t * u};
}
Hermite hermite_slope(double t) {
  return {6 * t * (t - 1), (1 - t) * (1 - 3 * t), 6 * t * (1 - t), t * (3 * t - 2)};
}

}  // namespace

GridField::GridField(const Field<2>& field, const Box<2>& box, int columns, int rows)
    : box_(box), columns_(columns), rows_(rows) {
  SEESAW_CHECK_GE(columns, 1);
  SEESAW_CHECK_GE(rows, 1);
  SEESAW_CHECK_LT(0.0, box.sizes().minCoeff());
  cell_ = box.sizes().cwiseQuotient(Point<2>(columns, rows));
  const Index count = static_cast<Index>(columns + 1) * (rows + 1);
  Points<2> points(2, count);
  for (int r = 0; r <= rows; ++r)
    for (int c = 0; c <= columns; ++c)
      points.col(static_cast<Index>(r) * (columns + 1) + c) =
          box.min() +
          box.sizes().cwiseProduct(Point<2>(static_cast<double>(c) / columns, static_cast<double>(r) / rows));
  Values values(count);
  Points<2> gradients(2, count);
  field.evaluate(points, values, gradients);
  corners_.resize(static_cast<std::size_t>(count));
  for (Index i = 0; i < count; ++i)
    corners_[static_cast<std::size_t>(i)] = {values[i], gradients(0, i) * cell_.x(),
                                             gradients(1, i) * cell_.y(), 0};
  // Half of each order of differences; one-sided at the rim.
  const auto slope = [](double before, double after, int steps) {
    return steps > 0 ? (after - before) / steps : 0;
  };
  for (int r = 0; r <= rows; ++r)
    for (int c = 0; c <= columns; ++c) {
      const int left = std::max(c - 1, 0), right = std::min(c + 1, columns);
      const int low = std::max(r - 1, 0), high = std::min(r + 1, rows);
      const double yx = slope(corner(left, r).fy, corner(right, r).fy, right - left);
      const double xy = slope(corner(c, low).fx, corner(c, high).fx, high - low);
      corners_[static_cast<std::size_t>(r) * static_cast<std::size_t>(columns + 1) +
               static_cast<std::size_t>(c)]
          .fxy = 0.5 * (yx + xy);
    }
}

double GridField::at(const Point<2>& p, Point<2>* gradient) const {
  const Point<2> place = (p - box_.min()).cwiseQuotient(cell_);
  if (!place.allFinite()) {
    if (gradient) gradient->setZero();
    return std::nan("");
  }
  const int c = static_cast<int>(std::clamp(std::floor(place.x()), 0.0, columns_ - 1.0));
  const int r = static_cast<int>(std::clamp(std::floor(place.y()), 0.0, rows_ - 1.0));
  const Corner &a = corner(c, r), &b = corner(c + 1, r), &d = corner(c, r + 1), &e = corner(c + 1, r + 1);
  const double tx = place.x() - c, ty = place.y() - r;
  const Hermite x = hermite(tx), y = hermite(ty);
  const auto along_x = [&](const Hermite& h, double v0, double s0, double v1, double s1) {
    return h.v0 * v0 + h.s0 * s0 + h.v1 * v1 + h.s1 * s1;
  };
  // Along x at the lower and upper side: value, and slope across.
  const double low = along_x(x, a.f, a.fx, b.f, b.fx), low_y = along_x(x, a.fy, a.fxy, b.fy, b.fxy);
  const double high = along_x(x, d.f, d.fx, e.f, e.fx), high_y = along_x(x, d.fy, d.fxy, e.fy, e.fxy);
  if (gradient) {
    const Hermite dx = hermite_slope(tx), dy = hermite_slope(ty);
    const double low_x = along_x(dx, a.f, a.fx, b.f, b.fx), low_xy = along_x(dx, a.fy, a.fxy, b.fy, b.fxy);
    const double high_x = along_x(dx, d.f, d.fx, e.f, e.fx), high_xy = along_x(dx, d.fy, d.fxy, e.fy, e.fxy);
    *gradient = Point<2>(along_x(y, low_x, low_xy, high_x, high_xy), along_x(dy, low, low_y, high, high_y))
                    .cwiseQuotient(cell_);
  }
  return along_x(y, low, low_y, high, high_y);
}

void GridField::evaluate(const PointsRef<2>& points, Eigen::Ref<Values> values) const {
  check_shapes(points, values);
  for (Index i = 0; i < points.cols(); ++i) values[i] = at(points.col(i), nullptr);
}

void GridField::evaluate(const PointsRef<2>& points, Eigen::Ref<Values> values,
                         Eigen::Ref<Points<2>> gradients) const {
  check_shapes(points, values);
  for (Index i = 0; i < points.cols(); ++i) {
    Point<2> gradient;
    values[i] = at(points.col(i), &gradient);
    gradients.col(i) = gradient;
  }
}

double GridField::gradient_bound(const Box<2>&) const { return infinity; }

}  // namespace seesaw
