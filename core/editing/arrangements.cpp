#include "core/editing/arrangements.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/base/check.h"
#include "core/modelling/cage.h"

namespace seesaw {

Constraint<2> fresh(ConstraintKind kind, const Point<2>& at) {
  switch (kind) {
    case ConstraintKind::boundary:
      return boundary<2>(at);
    case ConstraintKind::interior:
      return interior<2>(at);
    case ConstraintKind::exterior:
      return exterior<2>(at);
  }
  return boundary<2>(at);
}

Points<2> points_on_line(const Point<2>& from, const Point<2>& to, int count) {
  SEESAW_CHECK_GE(count, 1);
  Points<2> points(2, count);
  for (int i = 0; i < count; ++i) {
    const double t = count == 1 ? 0.5 : static_cast<double>(i) / (count - 1);
    points.col(i) = i == 0 && count > 1 ? from : t == 1 ? to : Point<2>(from + t * (to - from));
  }
  return points;
}

Points<2> points_on_circle(const Point<2>& center, const Point<2>& rim, int count) {
  SEESAW_CHECK_GE(count, 1);
  Points<2> points(2, count);
  const Point<2> arm = rim - center;
  points.col(0) = rim;
  for (int i = 1; i < count; ++i) {
    const double angle = 2 * M_PI * i / count, c = std::cos(angle), s = std::sin(angle);
    points.col(i) = center + Point<2>(c * arm.x() - s * arm.y(), s * arm.x() + c * arm.y());
  }
  return points;
}

Constraints<2> cage_around(const Document<2>& document, const Box<2>& view, int count) {
  Box<2> box;
  for (const SceneConstraint<2>& each : document.constraints)
    if (each.constraint.kind != ConstraintKind::exterior) box.extend(each.constraint.at);
  if (box.isEmpty()) return circle_cage(view.center(), 0.4 * view.sizes().minCoeff(), count);
  double radius = 0;
  for (const SceneConstraint<2>& each : document.constraints)
    if (each.constraint.kind != ConstraintKind::exterior)
      radius = std::max(radius, (each.constraint.at - box.center()).norm());
  return circle_cage(box.center(), radius > 0 ? 1.6 * radius : 0.4 * view.sizes().minCoeff(), count);
}

Constraints<2> without_doubles(const Constraints<2>& constraints, const Document<2>& document) {
  std::set<std::pair<double, double>> taken;
  for (const SceneConstraint<2>& each : document.constraints)
    taken.insert({each.constraint.at.x(), each.constraint.at.y()});
  Constraints<2> result;
  for (const Constraint<2>& each : constraints)
    if (taken.insert({each.at.x(), each.at.y()}).second) result.push_back(each);
  return result;
}

}  // namespace seesaw
