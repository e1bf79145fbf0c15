// Sphere tracing that cannot step through the surface.
//
// Let |grad f| <= L in a box (bound_tree.h) and let the ray be in it from t = a on. Around a, f keeps its
// sign for |f(a)| / L: the one sphere of Hart 1996. Two points with the same sign prove more. f keeps its
// sign on all of [a, b] when
//     |f(a)| + |f(b)| >= L (b - a),                                                                       (1)
// since a zero at t would need |f(a)| <= L (t - a) and |f(b)| <= L (b - t). So a step may be tried that is
// longer than the sphere, and proven afterwards (Keinert et al. 2014). If |f| goes on to change with slope s,
// (1) still holds for
//     b - a = 2 |f(a)| / (L - s),                                                                         (2)
// which is the sphere's own step for s = -L, and nearly endless for s = L, when a ray flies away from the
// surface (Balint and Valasek 2018 arrive at the same step). Where (1) turns out not to hold the sphere's
// step is taken instead, and where the sign differs at b the surface is between.
//
// What is promised. Every crossing is found, and every pair of crossings that are at least `resolution`
// apart; where f changes sign twice within `resolution`, a chord that short may be passed over. What remains
// within a bracket of one resolution is polished to rounding. A ray that lies in the surface would hardly end
// so: after `patience` steps that short without proof, a hundredth of the diagonal at
// |f| < L * resolution, they grow by a tenth each, though never beyond half the way to where |f| is heading
// for zero. RayCrossings::unproven says the longest chord that may have been passed over, so that a ray for
// which the promise was not kept is known. All this is as rigorous as the field's gradient_bound; where that
// is infinite nothing is promised, and steps are `blind_step` long.
//
// Before it: surface_tracer.h, bound_tree.h. After it: solid.h.
#pragma once

#include "core/raytrace/bound_tree.h"
#include "core/raytrace/surface_tracer.h"

namespace seesaw {

struct RigorousOptions {
  BoundTreeOptions tree = {};
  // Relative to the diagonal of the field's bounding box:
  double resolution = 1e-6;
  double blind_step = 1e-3;  ///< where the field has no bound

  int patience = 10000;  ///< steps of one ray that may be that short without proof
};

class RigorousTracer final : public SurfaceTracer {
 public:
  explicit RigorousTracer(std::shared_ptr<const Field<3>> field, const RigorousOptions& options = {});

  /// The boxes that rays have asked for so far; null for a field without a bounding box.
  const BoundTree* tree() const { return tree_.get(); }

 private:
  void trace_in_box(std::span<const Task> tasks) const override;

  std::unique_ptr<BoundTree> tree_;
  double resolution_ = 0, blind_step_ = 0, small_ = 0;
  int patience_ = 0;
};

}  // namespace seesaw
