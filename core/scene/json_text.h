// Pieces of JSON text, written so that a person can read them and a diff stays small.
//
// Before it: a number, a string, a value on one line.  After it: core/scene/document_write.cpp.
#pragma once

#include <string>
#include <string_view>

namespace seesaw {

/// The shortest text that reads back to the same bits: "0.1", "1", "1e-308", "-0.0". `value` is finite.
std::string json_number(double value);

/// As above for a number that is to stay a real one for programs that tell 2.0 from 2: "2.0".
std::string json_real(double value);

/// In quotes and escaped; bytes that are not UTF-8 become U+FFFD.
std::string json_string(std::string_view text);

/// `json`, which is on one line, as it is where it fits into a line, else broken open: each item or member on
/// a line of its own, two columns further in, and so on inward. `column` is where it starts; `indent` is that
/// of its line.
std::string json_layout(std::string_view json, std::size_t indent, std::size_t column);

}  // namespace seesaw
