// All questions to the field go through here: in parallel blocks, counted, with progress and cancel.
#pragma once

#include "core/base/progress.h"
#include "core/implicit/field.h"

namespace seesaw {

/// Inside, by the sign rule of polygonize.h.
inline bool is_inside(double value) { return value >= 0; }

class Sampler {
 public:
  Sampler(const Field<3>& field, const Progress& progress) : field_(field), progress_(progress) {}

  /// From now on progress moves toward `end`, and would get most of the way there with `expected` points.
  void stage(double end, double expected) {
    end_ = end;
    expected_ = expected;
  }
  /// Progress stands at the stage's end.
  void finish_stage() { report_at(end_); }
  /// Throws Cancelled when the listener says stop.
  void tick() { report_at(fraction_); }

  /// f at `points`, 3 x N. What is not finite is counted, and comes back as minus infinity: outside.
  Values values(const Points<3>& points);
  /// The same with gradients; those that are not finite come back as zero.
  Values values(const Points<3>& points, Points<3>& gradients);

  const Field<3>& field() const { return field_; }
  Index evaluations() const { return evaluations_; }
  Index gradient_evaluations() const { return gradient_evaluations_; }
  Index nonfinite() const { return nonfinite_; }

 private:
  void report_at(double fraction);
  Values sample(const Points<3>& points, Points<3>* gradients);

  const Field<3>& field_;
  const Progress& progress_;
  double fraction_ = 0, end_ = 1, expected_ = 1;
  Index evaluations_ = 0, gradient_evaluations_ = 0, nonfinite_ = 0;
};

}  // namespace seesaw
