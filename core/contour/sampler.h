// The field as contouring sees it: the level subtracted, every number finite or plainly outside, and counted.
//
// Before it: Field, in batches.  After it: everything else in this folder.
#pragma once

#include <vector>

#include "core/implicit/field.h"

namespace seesaw {

/// The one sign rule: zero is inside, and so is -0.0.
inline bool is_inside(double value) { return value >= 0; }

class Sampler {
 public:
  /// The sampler keeps a reference to `field`. Values are f - level.
  Sampler(const Field<2>& field, double level) : field_(field), level_(level) {}

  /// f - level at each of `points`, N x 1; minus infinity where f is not a finite number.
  void evaluate(const PointsRef<2>& points, Values& values);

  /// As above, with gradients (2 x N); zero where one is not finite.
  void evaluate(const PointsRef<2>& points, Values& values, Points<2>& gradients);

  double level() const { return level_; }

  Index evaluations = 0;
  Index gradient_evaluations = 0;
  Index nonfinite = 0;

 private:
  void tidy(Values& values);

  const Field<2>& field_;
  double level_;
};

}  // namespace seesaw
