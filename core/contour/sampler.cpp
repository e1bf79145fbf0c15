#include "core/contour/sampler.h"

#include <cmath>

namespace seesaw {

void Sampler::tidy(Values& values) {
  for (double& value : values) {
    value -= level_;
    if (!std::isfinite(value)) {
      value = -infinity;
      ++nonfinite;
    }
  }
}

void Sampler::evaluate(const PointsRef<2>& points, Values& values) {
  values.resize(points.cols());
  if (points.cols() == 0) return;
  field_.evaluate(points, values);
  evaluations += points.cols();
  tidy(values);
}

void Sampler::evaluate(const PointsRef<2>& points, Values& values, Points<2>& gradients) {
  values.resize(points.cols());
  gradients.resize(2, points.cols());
  if (points.cols() == 0) return;
  field_.evaluate(points, values, gradients);
  evaluations += points.cols();
  gradient_evaluations += points.cols();
  tidy(values);
  for (Index i = 0; i < points.cols(); ++i)
    if (!gradients.col(i).allFinite()) gradients.col(i).setZero();
}

}  // namespace seesaw
