#include "core/polygonize/sampler.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"

namespace seesaw {

namespace {

// Points that one task takes: enough to fill the loops of a field, few enough to share among many cores.
constexpr Index samples_a_block = 512;
// Points between two looks at the listener; one chunk keeps all cores busy.
constexpr Index chunk = 16384;

}  // namespace

void Sampler::report_at(double fraction) {
  fraction_ = std::max(fraction_, std::min(fraction, 1.0));
  report(progress_, fraction_);
}

Values Sampler::values(const Points<3>& points) { return sample(points, nullptr); }

Values Sampler::values(const Points<3>& points, Points<3>& gradients) {
  gradients.resize(3, points.cols());
  gradient_evaluations_ += points.cols();
  return sample(points, &gradients);
}

Values Sampler::sample(const Points<3>& points, Points<3>* gradients) {
  const Index n = points.cols();
  Values values(n);
  for (Index first = 0; first < n; first += chunk) {
    const Index count = std::min(chunk, n - first);
    parallel_blocks(count, samples_a_block, [&](Index begin, Index end) {
      const Index from = first + begin, many = end - begin;
      if (gradients)
        field_.evaluate(points.middleCols(from, many), values.segment(from, many),
                        gradients->middleCols(from, many));
      else
        field_.evaluate(points.middleCols(from, many), values.segment(from, many));
    });
    report_at(fraction_ + (end_ - fraction_) * (1 - std::exp(-static_cast<double>(count) / expected_)));
  }
  for (Index i = 0; i < n; ++i) {
    if (!std::isfinite(values[i])) {
      ++nonfinite_;
      values[i] = -infinity;
    }
    if (gradients && !gradients->col(i).allFinite()) gradients->col(i).setZero();
  }
  evaluations_ += n;
  return values;
}

}  // namespace seesaw
