// Sphere tracing as the paper has it: one steepness for everything, from samples.
//
// "We sample the space in and around our implicit surface at 2000 positions, and we use the maximum gradient
// magnitude over all of these locations as the Lipschitz constant for sphere tracing." (Turk & O'Brien 2002,
// section 7.2; sphere tracing is Hart 1996.) At x a step of |f(x)| / L cannot pass the surface as long as
// |grad f| <= L on the way. The samples may have missed the steepest place: then the ray steps through thin
// parts of the surface without a word. How often, the tests count, beside rigorous_tracer.h.
//
// The paper stops where |f| falls below a tolerance. Here steps are never shorter than `least_step`, and
// where the sign changes within one the root is polished, so that CSG knows in from out.
//
// Before it: surface_tracer.h. After it: solid.h.
#pragma once

#include "core/raytrace/surface_tracer.h"

namespace seesaw {

struct HeuristicOptions {
  Index samples = 2000;      ///< the paper's, at random places of the field's bounding box
  std::uint64_t seed = 1;    ///< of those places
  double least_step = 1e-5;  ///< relative to the box's diagonal
};

class HeuristicTracer final : public SurfaceTracer {
 public:
  explicit HeuristicTracer(std::shared_ptr<const Field<3>> field, const HeuristicOptions& options = {});

  /// The largest |grad f| among the samples, value per scene unit.
  double steepness() const { return steepness_; }

 private:
  void trace_in_box(std::span<const Task> tasks) const override;

  double steepness_ = 0, least_step_ = 0, small_ = 0;
};

}  // namespace seesaw
