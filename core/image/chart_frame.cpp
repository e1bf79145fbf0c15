#include "core/image/chart_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace seesaw {

Scale::Scale(double low, double high, bool logarithmic) : low_(low), high_(high), logarithmic_(logarithmic) {
  const double least =
      logarithmic ? std::numeric_limits<double>::min() : std::numeric_limits<double>::lowest() / 4;
  const double most = std::numeric_limits<double>::max() / 4;
  if (!std::isfinite(low_) || low_ < least)
    low_ = logarithmic ? (high_ > 0 && high_ <= most ? high_ / 1000 : 0.1) : 0;
  if (!std::isfinite(high_) || high_ > most) high_ = logarithmic ? 10 * low_ : low_ + 1;
  if (low_ > high_) std::swap(low_, high_);
  if (logarithmic_) {
    low_ = std::max(low_, least);
    if (!(high_ > low_ * (1 + 1e-12))) {
      low_ /= 2;
      high_ = 4 * low_;
    }
  } else if (!(high_ - low_ > 1e-12 * std::max(std::abs(low_), std::abs(high_)))) {
    const double room = low_ == 0 ? 1 : 0.1 * std::abs(low_);
    low_ -= room;
    high_ += room;
  }
}

double Scale::fraction(double value) const {
  if (!logarithmic_) return (value - low_) / (high_ - low_);
  if (!(value > 0)) return std::numeric_limits<double>::quiet_NaN();
  return std::log(value / low_) / std::log(high_ / low_);
}

double Scale::value(double fraction) const {
  if (!logarithmic_) return low_ + fraction * (high_ - low_);
  return low_ * std::pow(high_ / low_, fraction);
}

std::vector<Tick> Scale::ticks(int about) const {
  return logarithmic_ ? log_ticks(low_, high_, about) : linear_ticks(low_, high_, about);
}

Scale scale_for(const Axis& axis, const std::vector<double>& values) {
  double low = infinity, high = -low;
  for (const double v : values) {
    if (!std::isfinite(v) || (axis.logarithmic && v <= 0)) continue;
    low = std::min(low, v);
    high = std::max(high, v);
  }
  if (low > high) {
    low = axis.logarithmic ? 0.1 : 0;
    high = 1;
  }
  const Scale tight(axis.low.value_or(low), axis.high.value_or(high), axis.logarithmic);
  // Room beyond the data, but an axis that starts at 0 keeps starting there.
  constexpr double room = 0.05;
  const bool from_zero = !axis.logarithmic && tight.low() == 0,
             to_zero = !axis.logarithmic && tight.high() == 0;
  return Scale(axis.low || from_zero ? tight.low() : tight.value(-room),
               axis.high || to_zero ? tight.high() : tight.value(1 + room), axis.logarithmic);
}

Point<2> ChartFrame::pixel_from_data(const Point<2>& data) const {
  return {plot.left() + x.fraction(data.x()) * plot.width,
          plot.bottom() - y.fraction(data.y()) * plot.height};
}

Point<2> ChartFrame::data_from_pixel(const Point<2>& pixel) const {
  return {x.value((pixel.x() - plot.left()) / plot.width),
          y.value((plot.bottom() - pixel.y()) / plot.height)};
}

}  // namespace seesaw
