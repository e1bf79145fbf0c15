#include "core/particles/landing.h"

#include "core/particles/adhesion.h"

namespace seesaw {
namespace {

constexpr double precision = 1e-9;  // of the box

std::optional<Point<3>> bisected(const Field<3>& field, Point<3> inside, Point<3> outside) {
  for (int k = 0; k < 60; ++k) {
    const Point<3> middle = 0.5 * (inside + outside);
    (field.value(middle) >= 0 ? inside : outside) = middle;
  }
  return inside;
}

}  // namespace

std::optional<Point<3>> some_point_on(const Field<3>& field, Random& random, bool brief) {
  const Box<3> box = field.bounding_box();
  if (box.isEmpty() || !box.sizes().allFinite()) return std::nullopt;
  const double size = box.diagonal().norm();
  const Index walks = 8;
  const PutOn put = put_on(field, random.points_in<3>(box, walks), Values::Constant(walks, size),
                           Values::Constant(walks, precision * size));
  for (Index i = 0; i < walks; ++i)
    if (put.on[static_cast<std::size_t>(i)] && box.contains(Point<3>(put.positions.col(i))))
      return put.positions.col(i);
  if (brief) return std::nullopt;

  std::optional<Point<3>> inside, outside;
  for (int batch = 0; batch < 8; ++batch) {
    const Points<3> points = random.points_in<3>(box, 4096);
    const Values values = touch(field, points).values;
    for (Index i = 0; i < points.cols(); ++i)
      if (values[i] >= 0 && !inside)
        inside = points.col(i);
      else if (values[i] < 0 && !outside)
        outside = points.col(i);
    if (inside && outside) return bisected(field, *inside, *outside);
  }
  return std::nullopt;
}

}  // namespace seesaw
