#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace seesaw {

std::string to_text(double value, int digits) {
  std::array<char, 64> buffer;
  const auto [end, error] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, digits);
  return error == std::errc() ? std::string(buffer.data(), end) : std::string("?");
}

std::optional<double> parse_number(std::string_view text) {
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size()) return std::nullopt;
  if (error == std::errc()) return value;
  if (error != std::errc::result_out_of_range) return std::nullopt;
  // Too large or too small for a double: infinity or zero, which the wider type tells apart.
  long double wide = 0;
  const auto again = std::from_chars(text.data(), text.data() + text.size(), wide);
  if (again.ec != std::errc()) return std::nullopt;
  return static_cast<double>(wide);
}

std::string capitalized(std::string words) {
  if (!words.empty() && words[0] >= 'a' && words[0] <= 'z')
    words[0] = static_cast<char>(words[0] - 'a' + 'A');
  return words;
}

int digits_for(double value, double step) {
  const double size = std::max(std::abs(value), step);
  if (!std::isfinite(size) || !(step > 0)) return 17;
  return std::clamp(1 + static_cast<int>(std::ceil(std::log10(size) - std::log10(step))), 3, 17);
}

}  // namespace seesaw
