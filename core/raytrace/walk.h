// Inside core/raytrace: many rays, each with its own next question, asked in one batch.
//
// Before it: a tracer's walkers. After it: nothing; they hold what they found.
#pragma once

#include <cmath>
#include <vector>

#include "core/implicit/field.h"

namespace seesaw {

/// Inside is f >= 0; what is not a number is outside.
inline bool is_inside(double value) { return value >= 0; }

/// A Walker has `bool ask(Point<3>& where)`, false when it has arrived, and `void answer(double value)`.
template <class Walker>
void walk_together(const Field<3>& field, std::vector<Walker>& walkers) {
  std::vector<std::size_t> asking(walkers.size());
  for (std::size_t i = 0; i < walkers.size(); ++i) asking[i] = i;
  Points<3> places(3, static_cast<Index>(walkers.size()));
  Values values(static_cast<Index>(walkers.size()));
  while (!asking.empty()) {
    std::size_t count = 0;
    for (const std::size_t i : asking) {
      Point<3> where;
      if (!walkers[i].ask(where)) continue;
      places.col(static_cast<Index>(count)) = where;
      asking[count++] = i;
    }
    asking.resize(count);
    if (count == 0) return;
    const Index n = static_cast<Index>(count);
    field.evaluate(places.leftCols(n), values.head(n));
    for (std::size_t k = 0; k < count; ++k) walkers[asking[k]].answer(values[static_cast<Index>(k)]);
  }
}

/// Narrows a sign change between a and b by regula falsi with Illinois' correction (Dowell and Jarratt 1971),
/// with bisection wherever that does not shrink: about three values take 1e-6 to rounding where f is smooth.
class RootSearch {
 public:
  void start(double a, double value_a, double b, double value_b) {
    a_ = a, b_ = b, fa_ = value_a, fb_ = value_b;
    asked_ = 0;
    last_side_ = 0;
  }
  /// Done once the bracket is no longer than `small`, or after 60 values.
  bool done(double small) const { return b_ - a_ <= small || asked_ >= 60 || fa_ == 0 || fb_ == 0; }
  double next() const {
    const double width = b_ - a_;
    double t = asked_ % 8 == 7 ? a_ + 0.5 * width : a_ + width * (fa_ / (fa_ - fb_));
    if (!(t > a_ && t < b_)) t = a_ + 0.5 * width;
    return t;
  }
  void take(double t, double value) {
    ++asked_;
    if (is_inside(value) == is_inside(fa_)) {
      step_ = t - a_;
      a_ = t, fa_ = value;
      if (last_side_ == 1) fb_ *= 0.5;
      last_side_ = 1;
    } else {
      step_ = b_ - t;
      b_ = t, fb_ = value;
      if (last_side_ == 2) fa_ *= 0.5;
      last_side_ = 2;
    }
  }
  /// The root, as well as it is known.
  double root() const {
    if (fb_ == 0) return b_;
    if (fa_ == 0) return a_;
    const double t = a_ + (b_ - a_) * (fa_ / (fa_ - fb_));
    return t >= a_ && t <= b_ ? t : 0.5 * (a_ + b_);
  }
  double after() const { return b_; }

 private:
  double a_ = 0, b_ = 0, fa_ = 0, fb_ = 0, step_ = 0;
  int asked_ = 0, last_side_ = 0;
};

}  // namespace seesaw
