// The step itself; what changes the population is in population.cpp.
#include "core/particles/floaters.h"

#include <algorithm>
#include <cmath>

#include "core/particles/radii.h"
#include "core/particles/walk.h"

namespace seesaw {
namespace {

constexpr double longest_step = 0.5;       // along the surface, in radii
constexpr double longest_following = 0.1;  // along the normal, in diameters: a gradient may be nearly zero
constexpr double least_pace = 0.02, slower = 0.6, faster = 1.05;
constexpr double curvature_memory = 0.9;  // a step
// A spacing may grow by a sixth from a floater to its neighbor, two radii away. Where it grows faster nothing
// comes to rest.
constexpr double grading = 1.0 / 12;
constexpr Index quiet = 100;   // steps
constexpr double slow = 0.05;  // radii per unit of time

void shorten(Eigen::Ref<Point<3>> v, double most) {
  const double length = v.norm();
  if (length > most) v *= most / length;
}

}  // namespace

void Floaters::choose_velocities(const Field<3>& field, const Values& rates) {
  if (rates.size() > 0) SEESAW_CHECK_EQ(rates.size(), size());
  const bool adaptive = options_.repulsion == Repulsion::adaptive;
  contact_ = touch(field, crowd_.positions);
  const Points<3> normals = contact_.normals();
  for (Index i = 0; i < size(); ++i)
    if (contact_.definite[static_cast<std::size_t>(i)]) crowd_.normals.col(i) = normals.col(i);
  crowd_.scales = options_.turn > 0 ? Values(desired_radii() / desired_radius()) : Values();
  sums_ = repulsion(
      crowd_, {.amplitude = options_.amplitude, .mutual = adaptive, .grading = grading / desired_radius()});
  allowed_ = sums_.allowed;
  tangent_ = along(contact_, sums_.push);
  normal_ = following(contact_, rates, options_.adhesion_gain);
  carried_ = rates.size() > 0 ? following(contact_, rates, 0) : Points<3>(Points<3>::Zero(3, size()));
  velocities_ = tangent_ + normal_;
  curvature_ = curvature_memory * curvature_ + (1 - curvature_memory) * sums_.curvature;
}

void Floaters::move(const Field<3>& field) {
  SEESAW_CHECK_EQ(tangent_.cols(), size());  // choose_velocities comes first
  if (size() == 0) return start_again(field);
  const double dt = options_.time_step;
  const Values desired = desired_radii();
  Ways ways = {crowd_.positions, crowd_.normals, dt * tangent_, desired, desired};
  for (Index i = 0; i < size(); ++i) {
    // Feedback alone may promise anything: far from the surface first order is no guide.
    Point<3> following = dt * carried_.col(i), feedback = dt * (normal_.col(i) - carried_.col(i));
    shorten(following, astray_[i] > 0 ? 0.0 : longest_following * diameter_);
    shorten(feedback, 0.5 * desired[i]);
    following += feedback;
    pace_[i] = tangent_.col(i).dot(heading_.col(i)) < 0 ? std::max(least_pace, slower * pace_[i])
                                                        : std::min(1.0, faster * pace_[i]);
    ways.by.col(i) *= pace_[i];
    shorten(ways.by.col(i), longest_step * crowd_.radii[i]);
    ways.from.col(i) += following;
    ways.leashes[i] += 0.5 * following.norm();
  }
  heading_ = tangent_;
  const Points<3> before = crowd_.positions;
  Walked walked = walk(field, ways);
  // "... it is best to leave such floaters motionless."
  for (Index i = 0; i < size(); ++i) {
    const std::size_t row = static_cast<std::size_t>(i);
    if (contact_.definite[row]) continue;
    walked.positions.col(i) = before.col(i);
    walked.normals.col(i) = crowd_.normals.col(i);
    walked.on[row] = contact_.values[i] == 0;
  }
  crowd_.positions = walked.positions;
  crowd_.normals = walked.normals;
  velocities_ = (crowd_.positions - before) / dt;
  count_astray(walked.on);
  update_radii();
  ++quiet_steps_;
  live_and_die(field);
  tangent_.resize(3, 0);
}

void Floaters::update_radii() {
  if (options_.repulsion == Repulsion::adaptive) {
    const RadiusRule rule = {options_.radius_gain, options_.desired_energy * options_.amplitude,
                             options_.softening / diameter_, largest_radius()};
    crowd_.radii = next_radii(crowd_.radii, sums_.own, sums_.own_slope, rule, options_.time_step);
  } else if (options_.repulsion == Repulsion::simple && options_.simple_radius > 0) {
    crowd_.radii.setConstant(options_.simple_radius * diameter_);
  } else {
    crowd_.radii.setConstant(crowd_.radii.mean());
  }
}

Index Floaters::equilibrate(const Field<3>& field, Index most, const Progress& progress) {
  for (Index k = 0; k < most; ++k) {
    if (at_rest()) return k;
    report(progress, static_cast<double>(k) / static_cast<double>(most));
    step(field);
  }
  return most;
}

bool Floaters::at_rest() const { return size() > 0 && quiet_steps_ >= quiet && median_speed() < slow; }

Values Floaters::slide_speeds() const {
  Values result = Values::Zero(size());
  for (Index i = 0; i < size(); ++i) {
    const Point<3> v = velocities_.col(i), n = crowd_.normals.col(i);
    result[i] = (v - n.dot(v) * n).norm() / crowd_.radii[i];
  }
  return result;
}

Values Floaters::desired_radii() const {
  Values result = Values::Constant(size(), desired_radius());
  if (options_.turn > 0)
    for (Index i = 0; i < size(); ++i) {
      // Neighbors are about two radii apart, and the normal turns by the curvature times that.
      const double bend = 2 * curvature_[i] * desired_radius();
      const double scale = bend > options_.turn ? options_.turn / bend : 1.0;
      result[i] *= std::max(options_.smallest_fraction, std::min(scale, allowed_[i]));
    }
  return result;
}

double Floaters::largest_radius() const {
  return std::max(options_.largest_radius * diameter_, 1.5 * desired_radius());
}

// The median, not the mean: a few may sit on a sharp edge, where the tangent plane keeps changing.
double Floaters::median_speed() const {
  Values speeds = slide_speeds();
  std::nth_element(speeds.begin(), speeds.begin() + size() / 2, speeds.end());
  return speeds[size() / 2];
}

Index Floaters::astray() const { return (astray_.array() > 0).count(); }

Discs Floaters::discs(double size) const { return {crowd_.positions, crowd_.normals, size * crowd_.radii}; }

}  // namespace seesaw
