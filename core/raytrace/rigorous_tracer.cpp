#include "core/raytrace/rigorous_tracer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/raytrace/walk.h"

namespace seesaw {

namespace {

// f has been proven to keep its sign up to `a`; `leaf` is the box that the ray is in there.
struct RigorousWalker {
  enum class Asking { nothing, start_of_leaf, step, root };

  Ray ray;
  bool one_is_enough;
  RayCrossings* found;
  const BoundTree* tree;
  double finest, blind_step, small;

  double a = 0, fa = 0;
  bool fa_known = false, inside = false, began = false, arrived = false, has_leaf = false;
  double bound = 0, leaf_end = 0;
  double slope = 0;  // of |f| along the ray, as last seen; times L where nothing has been seen
  bool slope_known = false;
  bool doubtful = false;      // the last try went too far
  double changed_at = 0;      // the sign is known to differ here ...
  bool change_known = false;  // ... if it is known
  double resolution = 0;      // `finest`, or more for a ray that has run out of patience, or without a bound
  int patience = 0;           // how many more steps may be as short as `finest` without proof
  double asked = 0;
  Asking asking = Asking::nothing;
  RootSearch root = {};

  bool ask(Point<3>& where) {
    while (asking == Asking::nothing && !arrived) choose();
    if (arrived) return false;
    where = ray.at(asked);
    ++found->evaluations;
    return true;
  }

  void note_side(bool side) {
    if (!began) {
      found->inside_at_begin = side;
      began = true;
    } else if (side != inside) {
      // Rounding at the border of two boxes; the surface is here.
      found->crossings.push_back({a, false});
      if (one_is_enough) arrived = true;
    }
    inside = side;
  }

  // What to ask next, or one box further on.
  void choose() {
    if (!(a < ray.end)) {
      arrived = true;
      return;
    }
    if (!has_leaf) {
      const BoundTree::Leaf leaf = tree->leaf_at(ray.at(a + 4 * small), ray.direction);
      Ray rest = ray;
      rest.begin = -infinity;
      leaf_end = std::max(within(rest, leaf.box).end, a + small);
      if (leaf.empty) {
        note_side(is_inside(leaf.middle));
        a = leaf_end;
        fa_known = slope_known = false;
        return;
      }
      leaf_end = std::min(leaf_end, ray.end);
      bound = leaf.bound;
      resolution = std::isfinite(bound) ? finest : blind_step;
      has_leaf = true;
      doubtful = false;
    }
    if (!fa_known) {
      asked = a;
      asking = Asking::start_of_leaf;
      return;
    }
    const double sphere = bound > 0 ? std::abs(fa) / bound : leaf_end - a;
    const double s = slope_known ? std::clamp(slope, -bound, 0.9 * bound) : -0.5 * bound;
    double step = doubtful ? sphere : std::max(sphere, 0.98 * 2 * std::abs(fa) / (bound - s));
    if (change_known && step > 0.5 * (changed_at - a)) step = std::max(sphere, 0.5 * (changed_at - a));
    // Also where the value is not a number.
    if (!(step > resolution)) step = resolution;
    asked = std::min(a + step, leaf_end);
    // A step that leads right onto the surface, or by rounding beyond: just before it there is something to
    // learn.
    if (change_known && !(asked < changed_at)) asked = a + std::max(0.98 * (changed_at - a), resolution);
    if (!(asked > a)) asked = std::nextafter(a, ray.end);
    asking = Asking::step;
  }

  void answer(double value) {
    const Asking what = asking;
    asking = Asking::nothing;
    if (what == Asking::root) {
      root.take(asked, value);
      look_for_root();
    } else if (what == Asking::start_of_leaf) {
      note_side(is_inside(value));
      fa = value;
      fa_known = true;
      change_known = false;
    } else if (is_inside(value) == inside) {
      take_step(value);
    } else if (asked - a <= resolution * (1 + 1e-6)) {
      note_unproven(asked - a);  // one crossing, or three
      root.start(a, fa, asked, value);
      a = asked, fa = value;  // where the walk goes on
      look_for_root();
    } else {
      changed_at = asked;
      change_known = true;
      slope = -(std::abs(fa) + std::abs(value)) / (asked - a);
      slope_known = true;
      doubtful = false;
    }
  }

  void note_unproven(double length) {
    found->unproven = std::max(found->unproven, std::isfinite(bound) ? length : infinity);
  }

  void take_step(double value) {
    const double length = asked - a;
    const bool proven =
        std::abs(fa) + std::abs(value) >= bound * length || length * bound <= std::abs(fa) * (1 + 1e-12);
    if (!proven && length > resolution * (1 + 1e-6)) {
      doubtful = true;
      return;
    }
    slope = (std::abs(value) - std::abs(fa)) / length;
    if (!proven) note_unproven(length);
    if (std::isfinite(bound)) {
      if (proven) {
        resolution = finest;
      } else if (patience > 0) {
        --patience;
      } else {  // longer, but not beyond half the way to where |f| is heading for zero
        const double heading = slope < 0 ? 0.5 * std::abs(value) / -slope : ray.end - asked;
        resolution = std::clamp(heading, finest, 1.1 * resolution);
      }
    }
    slope_known = true;
    doubtful = false;
    a = asked, fa = value;
    if (!(a < leaf_end)) has_leaf = false;
    if (change_known && !(a < changed_at)) change_known = false;
  }

  void look_for_root() {
    if (!root.done(small)) {
      asked = root.next();
      asking = Asking::root;
      return;
    }
    found->crossings.push_back({root.root(), false});
    inside = !inside;
    change_known = slope_known = doubtful = false;
    if (!(a < leaf_end)) has_leaf = false;
    if (one_is_enough) arrived = true;
  }
};

}  // namespace

RigorousTracer::RigorousTracer(std::shared_ptr<const Field<3>> field, const RigorousOptions& options)
    : SurfaceTracer(field) {
  SEESAW_CHECK_LT(0.0, options.resolution);
  SEESAW_CHECK_LE(0, options.patience);
  if (box().isEmpty()) return;
  tree_ = std::make_unique<BoundTree>(field, box(), options.tree);
  resolution_ = options.resolution * box().sizes().norm();
  blind_step_ = options.blind_step * box().sizes().norm();
  patience_ = options.patience;
  small_ = 1e-13 * box().sizes().norm();
}

void RigorousTracer::trace_in_box(std::span<const Task> tasks) const {
  std::vector<RigorousWalker> walkers;
  walkers.reserve(tasks.size());
  for (const Task& task : tasks) {
    walkers.push_back(
        {task.ray, task.one_is_enough, task.found, tree_.get(), resolution_, blind_step_, small_});
    walkers.back().a = task.ray.begin;
    walkers.back().patience = patience_;
  }
  walk_together(field(), walkers);
}

}  // namespace seesaw
