// Where an axis puts its ticks, and what it writes beside them.
//
// A reader does arithmetic on ticks, so steps are 1, 2 or 5 times a power of ten, and a logarithmic axis
// marks its decades. Labels of one axis have the same number of decimals; the minus is a real minus sign;
// large and small numbers are written with a power of ten, 5×10⁻⁴.
//
// Before it: the range of an axis. After it: chart.h.
#pragma once

#include <string>
#include <vector>

namespace seesaw {

struct Tick {
  double value = 0;
  std::string label;  ///< empty for the small ticks between
  bool major = true;
};

/// Multiples of 1, 2 or 5 times a power of ten within low .. high: the smallest such step that needs no
/// more than `about` steps. Empty unless low < high are numbers.
std::vector<Tick> linear_ticks(double low, double high, int about = 6);

/// For a logarithmic axis over low .. high, 0 < low < high. Three decades or more in range: every first,
/// second, third ... decade is major, so that at most `about` + 1 are, and 2 .. 9 between are minor ticks
/// while every decade is major. Fewer: 1, 2, 5 are major. Less than that: linear ticks. Empty for a bad
/// range.
std::vector<Tick> log_ticks(double low, double high, int about = 6);

/// `value` for people, to `digits` significant digits: "0.25", "−3", "1.5×10⁶". Plain digits from 1e-4 to
/// below 1e6.
std::string number_label(double value, int digits = 4);

/// "10⁻³" for -3, "10⁰" for 0.
std::string power_of_ten_label(int exponent);

}  // namespace seesaw
