#include "core/editing/grid.h"

#include <algorithm>
#include <cmath>

namespace seesaw {

namespace {

// 10^n for n of at most 22 is exact, and so a quotient by it rounds once.
double power_of_ten(int n) { return std::pow(10.0, n); }

double mantissa_times(int mantissa, int exponent) {
  return exponent < 0 ? mantissa / power_of_ten(-exponent) : mantissa * power_of_ten(exponent);
}

struct RoundStep {
  int mantissa = 1, exponent = 0;
  double value() const { return mantissa_times(mantissa, exponent); }
  RoundStep next() const {
    return mantissa == 1   ? RoundStep{2, exponent}
           : mantissa == 2 ? RoundStep{5, exponent}
                           : RoundStep{1, exponent + 1};
  }
};

RoundStep round_step_of(double least) {
  RoundStep step{1, std::clamp(static_cast<int>(std::floor(std::log10(least))) - 1, -300, 300)};
  // A hair of slack, so that what was 0.2 before some rounding does not become 0.5.
  while (step.value() < least * (1 - 1e-12) && step.exponent < 300) step = step.next();
  return step;
}

}  // namespace

double round_step(double least) { return round_step_of(least).value(); }

double next_step(double step, bool larger) {
  const RoundStep here = round_step_of(step);
  if (larger) return here.next().value();
  return here.mantissa == 1   ? mantissa_times(5, here.exponent - 1)
         : here.mantissa == 2 ? mantissa_times(1, here.exponent)
                              : mantissa_times(2, here.exponent);
}

double nearest_multiple(double x, double step) {
  const double count = std::round(x / step);
  // Farther out every double is as near to a multiple as any.
  if (!(std::abs(count) < 0x1p50)) return x;
  const RoundStep round = round_step_of(step);
  const double units = count * round.mantissa;
  if (round.value() != step || std::abs(round.exponent) > 22) return count * step + 0.0;
  return (round.exponent < 0 ? units / power_of_ten(-round.exponent) : units * power_of_ten(round.exponent)) +
         0.0;  // No -0.0.
}

}  // namespace seesaw
