#include "core/image/ticks.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"

namespace seesaw {
namespace {

constexpr const char* minus = "\u2212";
constexpr const char* times_ten = "\u00D710";

std::string superscript(int number) {
  static constexpr const char* digits[] = {"\u2070", "\u00B9", "\u00B2", "\u00B3", "\u2074",
                                           "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
  std::string result = number < 0 ? "\u207B" : "";
  for (const char c : std::to_string(std::abs(number))) result += digits[c - '0'];
  return result;
}

// Ten to a whole power, as exact as a double can be: pow(10, -1) need not be the double nearest to 0.1.
// Beyond what doubles hold without loss, the nearest power that they do.
double power_of_ten(int exponent) {
  return *parse_number(std::string("1e").append(std::to_string(std::clamp(exponent, -307, 308))));
}

// `plain` is decimal digits, perhaps with a sign and a point; the decimals are filled up with zeros.
std::string with_decimals(std::string plain, int decimals) {
  const std::size_t point = plain.find('.');
  int have = point == std::string::npos ? 0 : static_cast<int>(plain.size() - point - 1);
  if (point == std::string::npos && decimals > 0) plain += '.';
  for (; have < decimals; ++have) plain += '0';
  if (plain[0] == '-') plain.replace(0, 1, minus);
  return plain;
}

bool in_range(double low, double high) { return std::isfinite(low) && std::isfinite(high) && low < high; }

}  // namespace

std::string number_label(double value, int digits) {
  const std::string text = to_text(value, digits);
  if (!std::isfinite(value)) return text;
  const double size = std::abs(value);
  if (value == 0) return "0";
  if (size >= 1e-4 && size < 1e6) {
    // More digits than asked for before the point are still plain: 12345 to three digits is 12300, not
    // 1.23e4.
    const auto e = text.find('e');
    return with_decimals(e == std::string::npos ? text : to_text(*parse_number(text), 17), 0);
  }
  int exponent = static_cast<int>(std::floor(std::log10(size)));
  std::string mantissa = to_text(value / power_of_ten(exponent), digits);
  if (mantissa == "10" || mantissa == "-10") {
    mantissa.pop_back();
    ++exponent;
  }
  if (mantissa == "1") return power_of_ten_label(exponent);
  if (mantissa == "-1") return std::string(minus).append("10").append(superscript(exponent));
  return with_decimals(mantissa, 0).append(times_ten).append(superscript(exponent));
}

std::string power_of_ten_label(int exponent) { return std::string("10").append(superscript(exponent)); }

std::vector<Tick> linear_ticks(double low, double high, int about) {
  if (!in_range(low, high) || !std::isfinite(high - low)) return {};
  const double wanted = (high - low) / std::max(1, about);
  int exponent = static_cast<int>(std::floor(std::log10(wanted)));
  // The rounding of the logarithm is made up for by starting one step early.
  double step = 0;
  for (const int factor : {1, 2, 5, 10, 20}) {
    step = factor * power_of_ten(exponent);
    if (step >= wanted * (1 - 1e-9)) {
      if (factor >= 10) ++exponent;
      break;
    }
  }
  const double slack = 1e-9 * step;
  std::vector<Tick> ticks;
  const double first = std::ceil((low - slack) / step), last = std::floor((high + slack) / step);
  if (!(last - first < 1000) || std::abs(first) > 1e15 || std::abs(last) > 1e15) return {};
  // Value k * 10^e is better rounded as a division when e is negative: 3 / 10 is 0.3, 3 * 0.1 is not.
  for (double k = first; k <= last; ++k) {
    const double factor = std::round(step / power_of_ten(exponent));
    const double value =
        exponent < 0 ? k * factor / power_of_ten(-exponent) : k * factor * power_of_ten(exponent);
    ticks.push_back({value == 0 ? 0.0 : value, "", true});
  }

  const double largest = std::max(std::abs(low), std::abs(high));
  const int top = static_cast<int>(std::floor(std::log10(largest)));
  const bool plain = largest < 1e6 && step >= 0.99e-4;
  for (Tick& tick : ticks) {
    if (tick.value == 0) {
      tick.label = plain ? with_decimals("0", std::max(0, -exponent)) : "0";
      continue;
    }
    const int digits = std::clamp(top - exponent + 2, 1, 17);
    tick.label = plain ? with_decimals(to_text(tick.value, std::max(digits, 7)), std::max(0, -exponent))
                       : number_label(tick.value, digits);
  }
  return ticks;
}

std::vector<Tick> log_ticks(double low, double high, int about) {
  if (!in_range(low, high) || low <= 0) return {};
  const double slack = 1e-9;
  const int first = static_cast<int>(std::ceil(std::log10(low) - slack));
  const int last = static_cast<int>(std::floor(std::log10(high) + slack));
  const auto inside = [&](double v) { return v >= low * (1 - slack) && v <= high * (1 + slack); };
  std::vector<Tick> ticks;
  if (last - first >= 2) {
    const int stride = (last - first) / std::max(1, about) + ((last - first) % std::max(1, about) != 0);
    const bool plain = first >= -2 && last <= 5;
    const bool fill = stride == 1 && last - first < 6;
    for (int e = first - 1; e <= last; ++e) {
      const double decade = power_of_ten(e);
      const bool major = e % stride == 0;
      const std::string label = !major ? "" : plain ? number_label(decade) : power_of_ten_label(e);
      if (inside(decade)) ticks.push_back({decade, label, major});
      for (int m = 2; m <= 9 && fill; ++m)
        if (inside(m * decade)) ticks.push_back({m * decade, "", false});
    }
    return ticks;
  }
  int majors = 0;
  for (int e = first - 1; e <= last; ++e)
    for (int m = 1; m <= 9; ++m) {
      const double value = m * power_of_ten(e);
      if (!inside(value)) continue;
      const bool major = m == 1 || m == 2 || m == 5;
      majors += major;
      ticks.push_back({value, major ? number_label(value) : "", major});
    }
  return majors >= 3 ? ticks : linear_ticks(low, high, about);
}

}  // namespace seesaw
