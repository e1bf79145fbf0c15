#include "core/raytrace/heuristic_tracer.h"

#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/raytrace/walk.h"

namespace seesaw {

namespace {

struct HeuristicWalker {
  Ray ray;
  bool one_is_enough;
  RayCrossings* found;
  double steepness, least_step, small;

  double a = 0, fa = 0, asked = 0;
  bool began = false, polishing = false, arrived = false;
  RootSearch root = {};
  double value_after = 0;

  bool ask(Point<3>& where) {
    if (arrived) return false;
    if (!began)
      asked = ray.begin;
    else if (polishing)
      asked = root.next();
    else
      asked = std::min(ray.end, a + std::max(std::abs(fa) / steepness, least_step));
    where = ray.at(asked);
    ++found->evaluations;
    return true;
  }

  void answer(double value) {
    if (!began) {
      began = true;
      found->inside_at_begin = is_inside(value);
      found->unproven = infinity;
      arrive_at(ray.begin, value);
    } else if (polishing) {
      root.take(asked, value);
      finish_if_polished();
    } else if (is_inside(value) == is_inside(fa)) {
      arrive_at(asked, value);
    } else {
      root.start(a, fa, asked, value);
      polishing = true;
      a = asked, fa = value;  // where the walk goes on
      finish_if_polished();
    }
  }

  void arrive_at(double t, double value) {
    a = t, fa = value;
    arrived = !(a < ray.end);
  }

  void finish_if_polished() {
    if (!root.done(small)) return;
    polishing = false;
    found->crossings.push_back({root.root(), false});
    arrived = one_is_enough || !(a < ray.end);
  }
};

}  // namespace

HeuristicTracer::HeuristicTracer(std::shared_ptr<const Field<3>> field, const HeuristicOptions& options)
    : SurfaceTracer(std::move(field)) {
  SEESAW_CHECK_LT(0, options.samples);
  SEESAW_CHECK_LT(0.0, options.least_step);
  if (box().isEmpty()) return;
  Random random(options.seed);
  const Points<3> places = random.points_in<3>(box(), options.samples);
  Values values(options.samples);
  Points<3> gradients(3, options.samples);
  this->field().evaluate(places, values, gradients);
  steepness_ = gradients.colwise().norm().maxCoeff();
  const double diagonal = box().sizes().norm();
  least_step_ = options.least_step * diagonal;
  small_ = 1e-13 * diagonal;
}

void HeuristicTracer::trace_in_box(std::span<const Task> tasks) const {
  std::vector<HeuristicWalker> walkers;
  walkers.reserve(tasks.size());
  for (const Task& task : tasks)
    walkers.push_back({task.ray, task.one_is_enough, task.found, steepness_, least_step_, small_});
  walk_together(field(), walkers);
}

}  // namespace seesaw
