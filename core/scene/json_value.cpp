#include <algorithm>

#include "core/base/error.h"
#include "core/scene/json_tape.h"
#include "core/scene/json_text.h"

namespace seesaw {

namespace detail {

void append_key(std::string& path, std::string_view key) {
  constexpr std::size_t longest = 40;
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  if (!key.empty() && key.size() <= longest && std::all_of(key.begin(), key.end(), plain)) {
    if (!path.empty()) path += '.';
    path += key;
    return;
  }
  std::string shown(key.substr(0, longest));
  for (char& c : shown)
    if (c < ' ' || c > '~') c = '?';
  path += "[\"" + shown + (key.size() > longest ? "..." : "") + "\"]";
}

}  // namespace detail

std::size_t JsonValue::after(std::size_t i) const {
  const JsonToken& token = tape_->tokens[i];
  return token.type == JsonType::array || token.type == JsonType::object ? token.end : i + 1;
}

std::string_view JsonValue::characters() const {
  return std::string_view(tape_->characters).substr(token().start, token().length);
}

double JsonValue::number() const {
  switch (type()) {
    case JsonType::natural:
      return static_cast<double>(token().natural);
    case JsonType::integer:
      return static_cast<double>(token().integer);
    case JsonType::real:
      return token().real;
    default:
      refuse(std::string("expected a number, found ") + description());
  }
}

bool JsonValue::boolean() const {
  if (type() != JsonType::boolean) refuse(std::string("expected true or false, found ") + description());
  return token().boolean;
}

std::string_view JsonValue::text() const {
  if (type() != JsonType::string) refuse(std::string("expected a string, found ") + description());
  return characters();
}

std::optional<JsonValue> JsonValue::find(std::string_view key) const {
  if (type() != JsonType::object) return std::nullopt;
  for (std::size_t i = index_ + 1; i < after(index_); i = after(i + 1))
    if (JsonValue(*tape_, i).characters() == key) return JsonValue(*tape_, i + 1);
  return std::nullopt;
}

std::string JsonValue::path() const {
  // Walked from the top for the one error that is thrown, and not carried along for the many values that are
  // right.
  std::string path;
  for (std::size_t at = 0; at != index_;) {
    const bool in_array = tape_->tokens[at].type == JsonType::array;
    std::size_t child = at + 1;
    if (in_array) {
      std::size_t item = 0;
      for (; after(child) <= index_; child = after(child)) ++item;
      path += "[" + std::to_string(item) + "]";
      at = child;
    } else {
      while (after(child + 1) <= index_) child = after(child + 1);
      detail::append_key(path, JsonValue(*tape_, child).characters());
      at = child + 1;
    }
  }
  return path;
}

std::string JsonValue::json() const {
  switch (type()) {
    case JsonType::null:
      return "null";
    case JsonType::boolean:
      return token().boolean ? "true" : "false";
    case JsonType::natural:
      return std::to_string(token().natural);
    case JsonType::integer:
      return std::to_string(token().integer);
    case JsonType::real:
      return json_real(token().real);
    case JsonType::string:
      return json_string(characters());
    case JsonType::array: {
      std::string result = "[";
      each_item([&](JsonValue item) { result += (result.size() > 1 ? ", " : "") + item.json(); });
      return result + "]";
    }
    case JsonType::object: {
      std::string result = "{";
      each_member([&](std::string_view key, JsonValue value) {
        result += (result.size() > 1 ? ", " : "") + json_string(key) + ": " + value.json();
      });
      return result + "}";
    }
  }
  return "null";
}

const char* JsonValue::description() const {
  switch (type()) {
    case JsonType::null:
      return "null";
    case JsonType::boolean:
      return token().boolean ? "true" : "false";
    case JsonType::natural:
    case JsonType::integer:
    case JsonType::real:
      return "a number";
    case JsonType::string:
      return "a string";
    case JsonType::array:
      return "an array";
    case JsonType::object:
      return "an object";
  }
  return "?";
}

void JsonValue::refuse(const std::string& message) const {
  const std::string where = path();
  throw FileError(tape_->name, line(), where.empty() ? message : where + ": " + message);
}

void JsonValue::refuse(std::string_view key, const std::string& message) const {
  if (const auto member = find(key)) member->refuse(message);
  std::string where = path();
  detail::append_key(where, key);
  throw FileError(tape_->name, line(), where + ": " + message);
}

}  // namespace seesaw
