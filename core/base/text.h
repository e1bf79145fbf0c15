// Numbers to text and back, the same under every locale: a decimal comma never gets into a file of ours.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace seesaw {

/// `value` with `digits` significant digits, "%.{digits}g" in the C locale. Seventeen digits always read back
/// to the same double. Not a number is "nan", infinity "inf".
std::string to_text(double value, int digits = 6);

/// With a capital for its first letter, where that is one of a to z.
std::string capitalized(std::string words);

/// As many significant digits, 3 to 17, as tell `value` from its neighbors a `step` > 0 away: a coordinate
/// where a pixel is a `step`.
int digits_for(double value, double step);

/// The number that `text` holds from its first to its last character, or nothing. "nan" and "inf" are numbers
/// here, 1e400 is infinity and 1e-400 zero; the caller refuses what makes no sense. A leading '+' is allowed.
std::optional<double> parse_number(std::string_view text);

}  // namespace seesaw
