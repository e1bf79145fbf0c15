#include "core/editing/pick.h"

#include <algorithm>
#include <cmath>

#include "core/contour/contour.h"
#include "core/raytrace/rigorous_tracer.h"

namespace seesaw {

namespace {

struct Probe {
  double value = 0;
  Point<2> gradient = Point<2>::Zero();
};

Probe probe(const Field<2>& field, const Point<2>& at) {
  Values value(1);
  Points<2> gradient(2, 1);
  field.evaluate(at, value, gradient);
  return {value[0], gradient.col(0)};
}

/// Newton along the gradient, no farther than `reach`; nothing where it does not arrive.
std::optional<Point<2>> onto(const Field<2>& field, Point<2> x, double reach) {
  const Point<2> start = x;
  Point<2> best = x;
  double best_value = infinity;
  for (int step = 0; step < 30; ++step) {
    const Probe here = probe(field, x);
    if (std::abs(here.value) < best_value) {
      best_value = std::abs(here.value);
      best = x;
    } else if (step > 2) {
      break;  // Rounding is all that is left.
    }
    const double slope2 = here.gradient.squaredNorm();
    if (here.value == 0 || !(slope2 > 0)) break;
    x -= here.value / slope2 * here.gradient;
    if (!((x - start).norm() <= reach)) return std::nullopt;
  }
  const Probe there = probe(field, best);
  const double slope = there.gradient.norm();
  if (there.value == 0 || std::abs(there.value) <= 1e-9 * reach * slope) return best;
  return std::nullopt;
}

/// The point of the segment ab nearest to x.
Point<2> nearest_on_segment(const Point<2>& a, const Point<2>& b, const Point<2>& x) {
  const Point<2> along = b - a;
  const double square = along.squaredNorm();
  const double t = square > 0 ? std::clamp((x - a).dot(along) / square, 0.0, 1.0) : 0.0;
  return a + t * along;
}

/// From `start`, which is nearly on the curve, along it to where `near` stands perpendicularly off it.
std::optional<Point<2>> to_foot(const Field<2>& field, const Point<2>& start, const Point<2>& near,
                                double extent) {
  std::optional<Point<2>> foot = onto(field, start, 0.1 * extent);
  if (!foot) return std::nullopt;
  const auto tangent_at = [&](const Point<2>& x) -> Point<2> {
    const Point<2> gradient = probe(field, x).gradient;
    return Point<2>(-gradient.y(), gradient.x()).normalized();
  };
  Point<2> tangent = tangent_at(*foot);
  double slide = tangent.dot(near - *foot);
  // How fast `slide` falls along the curve: 1 on a straight line, more where the curve bends away from
  // `near`. From the steps themselves, so this is the secant method.
  double rate = 1;
  for (int step = 0; step < 40 && std::abs(slide) > 1e-14 * extent; ++step) {
    const double along = slide / rate;
    const auto next = onto(field, *foot + along * tangent, 0.1 * extent);
    if (!next) {
      rate *= 2;
      continue;
    }
    const Point<2> next_tangent = tangent_at(*next);
    const double next_slide = next_tangent.dot(near - *next);
    const double measured = (slide - next_slide) / along;
    const bool better = std::abs(next_slide) < std::abs(slide) &&
                        (*next - near).norm() <= (*foot - near).norm() * (1 + 1e-12);
    rate = better ? (measured > 0.1 ? measured : rate) : std::max(2 * rate, measured);
    if (!better) continue;
    foot = next;
    tangent = next_tangent;
    slide = next_slide;
  }
  return foot;
}

}  // namespace

std::optional<Point<3>> first_on_surface(std::shared_ptr<const Field<3>> field, const Point<3>& from,
                                         const Point<3>& direction) {
  const double length = direction.stableNorm();
  if (!(length > 0) || !std::isfinite(length) || !from.allFinite()) return std::nullopt;
  const Ray ray{from, direction / length};
  const RigorousTracer tracer(std::move(field));
  RayCrossings found;
  tracer.trace({&ray, 1}, HowMany::all, {&found, 1});
  // Where the box cuts the solid off there is no surface.
  for (const Crossing& each : found.crossings)
    if (!each.cap) return ray.at(each.t);
  return std::nullopt;
}

std::optional<Point<2>> nearest_on_curve(const Field<2>& field, const Point<2>& near,
                                         const PointsRef<2>& seeds) {
  Box<2> box = field.bounding_box();
  if (box.isEmpty() || !near.allFinite()) return std::nullopt;
  box = grown<2>(box.extend(near), 0.05);
  const Contour curve = contour(field, box, seeds);
  const double extent = box.sizes().maxCoeff();
  double least = infinity;
  Point<2> best = near;
  for (const Polyline& each : curve.polylines)
    for (Index i = 0; i < each.segments(); ++i) {
      const Point<2> x =
          nearest_on_segment(each.vertices.col(i), each.vertices.col((i + 1) % each.vertices.cols()), near);
      if ((x - near).norm() >= least) continue;
      least = (x - near).norm();
      best = x;
    }
  if (!std::isfinite(least)) return std::nullopt;
  return to_foot(field, best, near, extent);
}

}  // namespace seesaw
