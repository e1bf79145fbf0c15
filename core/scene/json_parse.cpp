// parse_json: nlohmann/json's events onto the tape.

#include <locale.h>
#include <clocale>
#if __has_include(<xlocale.h>)
#include <xlocale.h>
#endif

#include <algorithm>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/error.h"
#include "core/scene/json_tape.h"
#include "core/scene/json_text.h"

namespace seesaw {

namespace {

/// While it lives, this thread's locale is "C". nlohmann/json reads numbers by strtod after putting the
/// locale's decimal point into them, which goes wrong where that is longer than one byte (fa_IR's is two) or
/// changes meanwhile.
class PlainLocale {
 public:
  PlainLocale() : before_(::uselocale(plain())) {}
  ~PlainLocale() { ::uselocale(before_); }
  PlainLocale(const PlainLocale&) = delete;
  PlainLocale& operator=(const PlainLocale&) = delete;

 private:
  static ::locale_t plain() {
    static const ::locale_t locale = ::newlocale(LC_ALL_MASK, "C", nullptr);
    return locale;
  }
  ::locale_t before_;
};

/// How far the parser has read. A newline belongs to the line that it ends, so the line of the last character
/// that was read is the line of the token being reported: a number is known to be over only when the
/// character behind it has been read, and that one stands on the same line even where it is a newline.
struct Position {
  std::size_t line = 1;
  std::size_t consumed = 0;
  bool after_newline = false;
};

/// Walks over the text and keeps count.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, Position* position) : at_(at), position_(position) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    if (position_->after_newline) ++position_->line;
    position_->after_newline = *at_ == '\n';
    ++position_->consumed;
    ++at_;
    return *this;
  }
  CountingIterator operator++(int) {
    CountingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountingIterator& other) const { return at_ == other.at_; }
  bool operator!=(const CountingIterator& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  Position* position_;
};

bool has(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

/// Printable ASCII, and not endless.
std::string tamed(std::string text, std::size_t longest) {
  if (text.size() > longest) text = text.substr(0, longest) + "...";
  for (char& c : text)
    if (c < ' ' || c > '~') c = '?';
  return text;
}

/// The run of characters around text[i] that no white space, punctuation or quote of JSON cuts.
std::string word_at(std::string_view text, std::size_t i) {
  constexpr std::string_view cuts = " \t\r\n,:[]{}\"";
  const std::size_t before = i > 0 ? text.find_last_of(cuts, i - 1) : std::string_view::npos;
  const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
  return std::string(text.substr(begin, std::max(text.find_first_of(cuts, i), begin + 1) - begin));
}

/// What nlohmann/json says about a syntax error, without its frame and without the text that it repeats:
/// "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error while parsing value -
/// REASON; last read: '...'; expected '}'".
std::string reason_of(std::string what) {
  if (const std::size_t frame = what.find(" - "); frame != std::string::npos) what.erase(0, frame + 3);
  if (const std::size_t last = what.find("; last read: "); last != std::string::npos) {
    const std::size_t expected = what.rfind("; expected ");
    what.erase(last, expected > last ? expected - last : std::string::npos);
  }
  return what;
}

/// The listener of nlohmann/json's parser; every function returns true for "go on".
class TapeWriter {
 public:
  TapeWriter(JsonTape& tape, std::string_view text, const JsonLimits& limits)
      : tape_(tape), text_(text), limits_(limits) {}

  Position position;

  bool null() {
    add(JsonType::null);
    return true;
  }
  bool boolean(bool value) {
    add(JsonType::boolean).boolean = value;
    return true;
  }
  bool number_unsigned(std::uint64_t value) {
    add(JsonType::natural).natural = value;
    return true;
  }
  bool number_integer(std::int64_t value) {
    // An integer with a minus sign that is 0 was "-0", which only a real number can hold.
    if (value == 0)
      add(JsonType::real).real = -0.0;
    else
      add(JsonType::integer).integer = value;
    return true;
  }
  bool number_float(double value, const std::string&) {
    add(JsonType::real).real = value;
    return true;
  }
  bool string(const std::string& value) {
    add(JsonType::string);
    set_characters(value);
    return true;
  }
  bool binary(const nlohmann::json::binary_t&) { return false; }

  bool start_object(std::size_t) { return open(JsonType::object); }
  bool start_array(std::size_t) { return open(JsonType::array); }
  bool end_array() { return close(); }
  bool end_object() {
    refuse_a_key_given_twice();
    return close();
  }
  bool key(const std::string& value) {
    ++tape_.tokens[open_.back().index].length;
    open_.back().key = tape_.tokens.size();
    push(JsonType::string);
    set_characters(value);
    return true;
  }

  [[noreturn]] bool parse_error(std::size_t, const std::string& token,
                                const nlohmann::json::exception& error) {
    const std::string what = error.what();
    if (error.id == 406) refuse(path_of_next(), tamed(token, 40) + " is too large: numbers end at 1.8e308");
    if (open_.empty() && !tape_.tokens.empty()) refuse("", "something follows the end of the document");
    if (has(what, "ill-formed UTF-8")) refuse("", "not JSON: a string holds bytes that are not UTF-8");
    const bool unknown_word = has(what, "invalid literal") && position.consumed > 0;
    const std::string reason =
        unknown_word ? "cannot read \"" + tamed(word_at(text_, position.consumed - 1), 40) + "\""
                     : tamed(reason_of(what), 160);
    refuse(has(what, "while parsing value") ? path_of_next() : "", "not JSON: " + reason);
  }

  [[noreturn]] void refuse(const std::string& path, const std::string& message) const {
    refuse_line(position.line, path, message);
  }

 private:
  struct Open {
    std::size_t index;  // of the array's or object's own token
    std::size_t key;    // of an object's last key
  };

  [[noreturn]] void refuse_line(std::size_t line, const std::string& path, const std::string& message) const {
    throw FileError(tape_.name, static_cast<int>(line), (path.empty() ? "" : path + ": ") + message);
  }

  JsonToken& push(JsonType type) {
    if (tape_.tokens.size() >= limits_.values)
      refuse("", "holds more than the " + std::to_string(limits_.values) + " values that are read");
    JsonToken token;
    token.type = type;
    token.line = static_cast<std::uint32_t>(position.line);
    return tape_.tokens.emplace_back(token);
  }

  JsonToken& add(JsonType type) {
    JsonToken& token = push(type);
    if (!open_.empty()) {
      JsonToken& parent = tape_.tokens[open_.back().index];
      if (parent.type == JsonType::array) ++parent.length;
    }
    return token;
  }

  void set_characters(const std::string& value) {
    tape_.tokens.back().start = tape_.characters.size();
    tape_.tokens.back().length = static_cast<std::uint32_t>(value.size());
    tape_.characters += value;
  }

  bool open(JsonType type) {
    if (open_.size() >= static_cast<std::size_t>(limits_.depth))
      refuse("", "is nested deeper than the " + std::to_string(limits_.depth) + " levels that are read");
    add(type);
    open_.push_back({tape_.tokens.size() - 1, 0});
    return true;
  }

  bool close() {
    tape_.tokens[open_.back().index].end = tape_.tokens.size();
    open_.pop_back();
    return true;
  }

  std::string_view characters_of(std::size_t string) const {
    return std::string_view(tape_.characters).substr(tape_.tokens[string].start, tape_.tokens[string].length);
  }

  /// Two values for one key: whichever were taken, somebody would wonder. Sorted, so that a large object
  /// costs little.
  void refuse_a_key_given_twice() {
    const std::size_t object = open_.back().index;
    if (tape_.tokens[object].length < 2) return;
    keys_.clear();
    for (std::size_t i = object + 1; i < tape_.tokens.size();) {
      keys_.emplace_back(characters_of(i), i);
      const JsonToken& value = tape_.tokens[i + 1];
      i = value.type == JsonType::array || value.type == JsonType::object ? value.end : i + 2;
    }
    std::sort(keys_.begin(), keys_.end());
    std::size_t first = tape_.tokens.size();
    for (std::size_t k = 1; k < keys_.size(); ++k)
      if (keys_[k].first == keys_[k - 1].first) first = std::min(first, keys_[k].second);
    if (first == tape_.tokens.size()) return;
    open_.back().key = first;
    refuse_line(tape_.tokens[first].line, path_of_next(), "the key is given twice");
  }

  /// The path of the value that is being read.
  std::string path_of_next() const {
    std::string path;
    for (std::size_t level = 0; level < open_.size(); ++level) {
      const JsonToken& token = tape_.tokens[open_[level].index];
      if (token.type == JsonType::object) {
        if (open_[level].key) detail::append_key(path, characters_of(open_[level].key));
      } else {
        // Arrays further out have counted the item that they are in.
        path += "[" + std::to_string(level + 1 < open_.size() ? token.length - 1 : token.length) + "]";
      }
    }
    return path;
  }

  JsonTape& tape_;
  std::string_view text_;
  const JsonLimits& limits_;
  std::vector<Open> open_;
  std::vector<std::pair<std::string_view, std::size_t>> keys_;
};

}  // namespace

JsonTape parse_json(std::string_view text, const std::string& name, const JsonLimits& limits) {
  if (text.size() > limits.bytes)
    throw FileError(name, "is larger than the " + std::to_string(limits.bytes) + " bytes that are read");
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    throw FileError(name, 1, "is UTF-16 text: save it as UTF-8");
  // The parser skips the mark itself.
  const std::size_t start = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  if (text.find_first_not_of(" \t\r\n", start) == std::string_view::npos) throw FileError(name, "is empty");

  JsonTape tape;
  tape.name = name;
  TapeWriter writer(tape, text, limits);
  const PlainLocale plain_locale;
  nlohmann::json::sax_parse(CountingIterator(text.data(), &writer.position),
                            CountingIterator(text.data() + text.size(), &writer.position), &writer);
  // To the parser a zero byte is the end of the text; whatever hides behind it is still there.
  if (writer.position.consumed < text.size() || text.back() == '\0')
    writer.refuse("", "something follows the end of the document");
  return tape;
}

}  // namespace seesaw
