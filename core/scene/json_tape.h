// JSON text as a flat list of tokens, each with the line it stands on.
//
// Before it: the bytes of a file.  After it: core/scene/document_read.cpp, which asks for values by key.
//
// A tree of nodes would need no line numbers if files had no mistakes. Errors are for people, who need the
// line and the path ("constraints[3].at"); nlohmann/json's own tree keeps neither, so its parser's events are
// recorded here. A tape costs 24 bytes a value, and whatever is in the file, no function here calls itself
// more than 64 deep.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace seesaw {

/// Numbers keep the type they are written in: natural 2, integer -2, real 2.0.
enum class JsonType : std::uint8_t { null, boolean, natural, integer, real, string, array, object };

struct JsonToken {
  JsonType type = JsonType::null;
  /// Counted from 1.
  std::uint32_t line = 0;
  /// Of a string: its bytes. Of an array or object: its items or members.
  std::uint32_t length = 0;
  union {
    bool boolean;
    std::uint64_t natural = 0;
    std::int64_t integer;
    double real;
    /// Of a string: where it starts in JsonTape::characters.
    std::uint64_t start;
    /// Of an array or object: the token after its last one.
    std::uint64_t end;
  };
};

/// An array is followed by its items, an object by a string and a value for each of its members.
struct JsonTape {
  /// What errors call the text.
  std::string name;
  std::vector<JsonToken> tokens;
  std::string characters;
};

/// Where a text stops being one that a person could have meant, and before it fills the memory: about two
/// million constraints, a thousand times what can be solved.
struct JsonLimits {
  std::size_t bytes = std::size_t{256} << 20;
  /// Values and keys.
  std::size_t values = 20'000'000;
  int depth = 64;
};

/// Reads one JSON value: RFC 8259, with unique keys, in UTF-8 with or without a byte order mark, numbers
/// within the range of doubles. The locale plays no part. Throws FileError with the line, and the path where
/// there is one.
JsonTape parse_json(std::string_view text, const std::string& name, const JsonLimits& limits = {});

/// One value of a tape that outlives it. Small: pass by value.
class JsonValue {
 public:
  explicit JsonValue(const JsonTape& tape, std::size_t index = 0) : tape_(&tape), index_(index) {}

  JsonType type() const { return token().type; }
  int line() const { return static_cast<int>(token().line); }
  /// How many items or members an array or object has.
  std::size_t size() const { return token().length; }

  // What a value holds, or a FileError: "expected a number, found a string".
  double number() const;
  bool boolean() const;
  std::string_view text() const;

  /// visit(value) for each item of an array.
  template <class Visit>
  void each_item(const Visit& visit) const {
    for (std::size_t i = index_ + 1; i < after(index_); i = after(i)) visit(JsonValue(*tape_, i));
  }
  /// visit(key, value) for each member of an object.
  template <class Visit>
  void each_member(const Visit& visit) const {
    for (std::size_t i = index_ + 1; i < after(index_); i = after(i + 1))
      visit(JsonValue(*tape_, i).characters(), JsonValue(*tape_, i + 1));
  }
  /// The member of that name, or nothing.
  std::optional<JsonValue> find(std::string_view key) const;

  /// How to reach the value from the top: "constraints[3].at", empty for the top itself.
  std::string path() const;
  /// The value as JSON on one line.
  std::string json() const;
  /// "a number", "an array", ...
  const char* description() const;

  /// Throws FileError with the line and the path of this value.
  [[noreturn]] void refuse(const std::string& message) const;
  /// The same for the member `key`, or for where it should have been.
  [[noreturn]] void refuse(std::string_view key, const std::string& message) const;

 private:
  const JsonToken& token() const { return tape_->tokens[index_]; }
  std::string_view characters() const;
  /// The token behind the value that starts at token i.
  std::size_t after(std::size_t i) const;

  const JsonTape* tape_;
  std::size_t index_;
};

namespace detail {
/// Adds ".key" to a path, or ["key"] where the key is no plain word.
void append_key(std::string& path, std::string_view key);
}  // namespace detail

}  // namespace seesaw
