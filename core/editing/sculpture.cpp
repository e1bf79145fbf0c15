#include "core/editing/sculpture.h"

#include <algorithm>
#include <cmath>

namespace seesaw {

namespace {

ParametricBlobbyCylinders<3> surface_of(const Sculpture& sculpture) {
  ParametricBlobbyCylinders<3> surface(
      BlobbyCylinders<3>(sculpture.threshold, sculpture.starts, sculpture.ends, sculpture.deviations));
  const std::vector<std::string> names = surface.names();
  for (const std::string& frozen : sculpture.frozen) {
    const auto found = std::find(names.begin(), names.end(), frozen);
    if (found == names.end()) throw Error("there is no parameter " + frozen + " to freeze");
    surface.freeze(found - names.begin());
  }
  return surface;
}

double off_surface(const Field<3>& field, const PointsRef<3>& points) {
  Values values(points.cols());
  Points<3> gradients(3, points.cols());
  field.evaluate(points, values, gradients);
  double most = 0;
  for (Index i = 0; i < points.cols(); ++i)
    most = std::max(most, std::abs(values[i]) / gradients.col(i).norm());
  return most;
}

}  // namespace

Sculptor::Sculptor(const Sculpture& sculpture, const ControlOptions& options)
    : surface_(surface_of(sculpture)),
      options_(options),
      desired_radius_(sculpture.desired_radius),
      floaters_(surface_,
                {.desired_radius = sculpture.desired_radius / surface_.bounding_box().sizes().maxCoeff(),
                 .diameter = surface_.bounding_box().sizes().maxCoeff()}) {
  SEESAW_CHECK_LT(0.0, sculpture.desired_radius);
  floaters_.equilibrate(surface_);
}

Index Sculptor::grab(const Point<3>& at, bool& is_new) {
  const double reach = 2 * desired_radius_;
  Index nearest = -1;
  for (Index i = 0; i < points_.size(); ++i)
    if (nearest < 0 || (points_.positions.col(i) - at).norm() < (points_.positions.col(nearest) - at).norm())
      nearest = i;
  is_new = nearest < 0 || (points_.positions.col(nearest) - at).norm() > reach;
  if (!is_new) return nearest;
  // The floater nearest to it, for a start; from there Newton's way onto f = 0, along the surface to the
  // place that is nearest to `at`.
  if (floaters_.size() == 0) throw Error("there is no surface to take hold of");
  Index first = 0;
  (floaters_.positions().colwise() - at).colwise().squaredNorm().minCoeff(&first);
  Point<3> foot = floaters_.positions().col(first);
  for (int step = 0; step < 60; ++step) {
    const Point<3> gradient = surface_.gradient(foot);
    const double square = gradient.squaredNorm();
    if (!(square > 0)) break;
    const Point<3> toward = at - foot, along = toward - toward.dot(gradient) / square * gradient;
    foot += 0.5 * along - surface_.value(foot) / square * gradient;
  }
  if (!foot.allFinite() || !(off_surface(surface_, foot) < 1e-6 * desired_radius_))
    throw Error("the surface is not met near the place that was taken hold of");
  return points_.add(foot);
}

DragReport Sculptor::drag(const Drag& drag, int most_steps, const Progress& progress) {
  DragReport report;
  report.point = grab(drag.grab, report.is_new);
  const Point<3> from = points_.positions.col(report.point);
  const double step_time = floaters_.options().time_step, distance = (drag.to - from).norm();
  // A hand's speed: four desired radii per unit of time, some eight steps of 0.03 a radius.
  const double speed = 4 * desired_radius_;
  for (; report.steps < most_steps; ++report.steps) {
    seesaw::report(progress, report.steps / static_cast<double>(most_steps));
    const double gone = std::min(distance, speed * report.steps * step_time);
    const Point<3> cursor = distance > 0 ? Point<3>(from + gone / distance * (drag.to - from)) : drag.to;
    const Point<3> at = points_.positions.col(report.point);
    report.miss = (drag.to - at).norm();
    if (report.miss < 1e-3 * desired_radius_) break;
    points_.velocities.setZero();
    points_.velocities.col(report.point) = spring_velocity<3>(at, cursor);
    const FollowedStep step = differential_step(surface_, points_, floaters_, options_);
    report.least_squares += step.motion.method == ControlMethod::least_squares;
    report.waited += step.waited;
    report.most_off = std::max(report.most_off, off_surface(surface_, points_.positions));
  }
  points_.velocities.setZero();
  return report;
}

}  // namespace seesaw
