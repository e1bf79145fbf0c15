#include "core/particles/follow.h"

#include <cmath>
#include <exception>

namespace seesaw {
namespace {

// How far the farthest point is from the surface, |f| / |f_x|, scene units; infinite where that is no number.
template <int Dim>
double farthest_off(const Field<Dim>& field, const PointsRef<Dim>& positions) {
  const Index n = positions.cols();
  Values values(n);
  Points<Dim> slopes(Dim, n);
  field.evaluate(positions, values, slopes);
  double most = 0;
  for (Index i = 0; i < n; ++i) {
    const double off = values[i] == 0 ? 0 : std::abs(values[i]) / slopes.col(i).norm();
    most = std::isfinite(off) ? std::max(most, off) : infinity;
  }
  return most;
}

template <int Dim>
double size_of(const Field<Dim>& field) {
  const Box<Dim> box = field.bounding_box();
  return box.isEmpty() ? 0.0 : box.sizes().maxCoeff();
}

// One of Euler's steps at a time, each taken back where it ends off the surface.
template <int Dim>
class Follower {
 public:
  Follower(ParametricField<Dim>& field, ControlPoints<Dim>& points, const ControlOptions& options)
      : field_(field), points_(points), options_(options), allowed_(options.largest_miss * size_of(field)) {}

  // Moves on by `h`, or does not move and returns false.
  bool moves(const SurfaceMotion& motion, double h) {
    const Values q = field_.q();
    const Points<Dim> positions = points_.positions;
    const double before = points_.size() > 0 ? farthest_off<Dim>(field_, positions) : 0.0;
    try {
      advance(field_, points_, motion, h);
      if (points_.size() == 0 || farthest_off<Dim>(field_, points_.positions) <= std::max(allowed_, before))
        return true;
    } catch (const std::exception&) {
      refusal_ = std::current_exception();
    }
    field_.set_q(q);
    points_.positions = positions;
    return false;
  }

  FollowedStep run(SurfaceMotion motion, double time_step) {
    const Values from = field_.q();
    const Points<Dim> asked = points_.velocities;
    const double shortest = time_step / std::exp2(options_.most_halvings);
    FollowedStep step;
    step.motion = motion;
    step.parts = 0;
    double left = time_step, h = time_step;
    while (left > 0.5 * shortest) {
      if (left < time_step || step.waited) motion = surface_motion(field_, points_, options_);
      h = std::min(h, left);
      bool moved = moves(motion, h);
      while (!moved && h > 1.5 * shortest) moved = moves(motion, h /= 2);
      if (moved) {
        ++step.parts;
        left -= h;
        h *= 2;
      } else if (!step.waited) {
        step.waited = true;
        points_.velocities.setZero();
        h = left;
      } else {
        break;  // not even feedback helps: the rest of the time is spent waiting
      }
    }
    points_.velocities = asked;
    if (step.parts == 0 && refusal_) std::rethrow_exception(refusal_);
    step.q_rates = step.parts == 1 && !step.waited ? motion.q_rates : Values((field_.q() - from) / time_step);
    return step;
  }

 private:
  ParametricField<Dim>& field_;
  ControlPoints<Dim>& points_;
  const ControlOptions& options_;
  double allowed_;
  std::exception_ptr refusal_;
};

}  // namespace

template <int Dim>
FollowedStep follow(ParametricField<Dim>& field, ControlPoints<Dim>& points, const SurfaceMotion& motion,
                    double time_step, const ControlOptions& options) {
  SEESAW_CHECK_LT(0.0, time_step);
  return Follower<Dim>(field, points, options).run(motion, time_step);
}

template FollowedStep follow<2>(ParametricField<2>&, ControlPoints<2>&, const SurfaceMotion&, double,
                                const ControlOptions&);
template FollowedStep follow<3>(ParametricField<3>&, ControlPoints<3>&, const SurfaceMotion&, double,
                                const ControlOptions&);

}  // namespace seesaw
