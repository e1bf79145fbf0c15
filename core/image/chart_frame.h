// Data to page and back: the two axes of a chart.
//
// Before it: the range of the data. After it: chart.h, which draws in it, and callers that add marks of
// their own.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/image/rect.h"
#include "core/image/ticks.h"

namespace seesaw {

/// What a caller says of an axis.
struct Axis {
  std::string label = {};
  bool logarithmic = false;
  std::optional<double> low = {}, high = {};  ///< ends; by default around the data, with a little room
};

/// An axis with both ends known: data value <-> fraction 0 .. 1 of the way along it.
class Scale {
 public:
  Scale() = default;
  /// Ends that are not low < high (0 < low, if logarithmic) are widened or replaced until they are.
  Scale(double low, double high, bool logarithmic);

  /// 0 at the low end, 1 at the high end, beyond outside. Not a number where a logarithm does not exist.
  double fraction(double value) const;
  /// Its inverse.
  double value(double fraction) const;

  double low() const { return low_; }
  double high() const { return high_; }
  bool logarithmic() const { return logarithmic_; }
  /// Around `about` steps, by ticks.h.
  std::vector<Tick> ticks(int about) const;

 private:
  double low_ = 0, high_ = 1;
  bool logarithmic_ = false;
};

/// The scale that shows all of `values` and honors what the axis fixes. Values that are not numbers, or
/// that a logarithmic axis cannot show, have no say.
Scale scale_for(const Axis& axis, const std::vector<double>& values);

/// Where a chart's plot lies on the page, points, y down; data has y up.
struct ChartFrame {
  Rect plot;  ///< the area inside the axes
  Scale x, y;
  std::vector<Tick> x_ticks, y_ticks;

  /// The place on the page of a data point; with NaN where there is none.
  Point<2> pixel_from_data(const Point<2>& data) const;
  Point<2> data_from_pixel(const Point<2>& pixel) const;
};

}  // namespace seesaw
