#include "core/scene/json_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>

namespace seesaw {

namespace {

constexpr std::size_t line_width = 110;

/// The end of the string, array, object or plain word that starts at `i`.
std::size_t end_of_value(std::string_view json, std::size_t i) {
  int depth = 0;
  bool in_string = false;
  for (; i < json.size(); ++i) {
    const char c = json[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
      continue;
    }
    if (c == '"') in_string = true;
    if (c == '[' || c == '{') ++depth;
    if (c == ']' || c == '}') --depth;
    if (depth < 0 || (depth == 0 && (c == ',' || c == ':'))) return i;
  }
  return json.size();
}

}  // namespace

std::string json_number(double value) {
  std::array<char, 32> buffer;
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  static_cast<void>(error);  // The longest double has 24 characters.
  const std::string text(buffer.data(), end);
  // "-0" is an integer to many readers, and integers have no negative zero.
  return text == "-0" ? "-0.0" : text;
}

std::string json_real(double value) {
  const std::string text = json_number(value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string json_string(std::string_view text) {
  const auto as_it_is = [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; };
  if (std::all_of(text.begin(), text.end(), as_it_is)) return '"' + std::string(text) + '"';
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string json_layout(std::string_view json, std::size_t indent, std::size_t column) {
  const bool object = json.starts_with('{');
  if (column + json.size() <= line_width || json.size() <= 2 || !(object || json.starts_with('[')))
    return std::string(json);
  const std::string margin(indent + 2, ' ');
  std::string result(1, json.front());
  for (std::size_t i = 1; i < json.size();) {
    std::string key;
    std::size_t end = end_of_value(json, i);
    if (object && end < json.size() && json[end] == ':') {
      key = std::string(json.substr(i, end - i)) + ": ";
      i = std::min(end + 2, json.size());
      end = end_of_value(json, i);
    }
    result += (result.size() > 1 ? ",\n" : "\n") + margin + key;
    result += json_layout(json.substr(i, end - i), indent + 2, indent + 2 + key.size());
    i = end + 2;  // Behind ", " or the closing bracket.
  }
  return result + "\n" + std::string(indent, ' ') + (object ? "}" : "]");
}

}  // namespace seesaw
