// The words of a script.

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/window/script.h"

namespace seesaw {

namespace {

struct ScriptWord {
  std::string text;
  bool quoted = false;
};

constexpr int longest_side = 16384, most_steps = 100000;

/// The words of one line, taken one by one.
class ScriptWords {
 public:
  ScriptWords(std::string_view line, const std::string& name, int number, const std::filesystem::path& folder)
      : name_(name), number_(number), folder_(folder) {
    split(line);
  }

  [[noreturn]] void refuse(const std::string& message) const { throw FileError(name_, number_, message); }
  bool done() const { return next_ == words_.size(); }
  void end() const {
    if (!done()) refuse("\"" + words_[next_].text + "\" is one word too many");
  }

  std::string word(const char* expected) {
    if (done()) refuse(std::string("expected ") + expected + ", found the end of the line");
    return words_[next_++].text;
  }
  double number(const char* expected) {
    const std::string text = word(expected);
    const auto value = parse_number(text);
    if (!value || !std::isfinite(*value))
      refuse(std::string("expected ") + expected + ", found \"" + text + "\"");
    return *value;
  }
  int integer(const char* expected, int least, int most) {
    const double value = number(expected);
    if (value != std::floor(value) || value < least || value > most)
      refuse(std::string("expected ") + expected + ", a whole number from " + std::to_string(least) + " to " +
             std::to_string(most) + ", found " + to_text(value));
    return static_cast<int>(value);
  }
  MouseButton button() {
    if (done()) return MouseButton::left;
    const std::string text = word("a button");
    if (text == "left") return MouseButton::left;
    if (text == "middle") return MouseButton::middle;
    if (text == "right") return MouseButton::right;
    refuse("expected left, middle or right, found \"" + text + "\"");
  }
  ScriptPlace place() {
    const char* const expected = "a place, X Y or the name of a widget in quotes";
    if (done()) refuse(std::string("expected ") + expected + ", found the end of the line");
    ScriptPlace result;
    if (words_[next_].quoted) {
      result.widget = word(expected);
      if (result.widget.empty()) refuse("a widget without a name cannot be found");
      if (!next_is_signed()) return result;
      result.at.x() = number("how far to the right of it");
      if (!next_is_signed()) refuse("expected two offsets with their signs, as in \"Undo\" +4 -2");
      result.at.y() = number("how far below it");
      return result;
    }
    result.at.x() = number(expected);
    result.at.y() = number("Y");
    return result;
  }
  bool next_is_number() const {
    return !done() && !words_[next_].quoted && parse_number(words_[next_].text).has_value();
  }
  const std::filesystem::path& folder() const { return folder_; }

 private:
  bool next_is_signed() const {
    return next_is_number() && (words_[next_].text[0] == '+' || words_[next_].text[0] == '-');
  }
  void split(std::string_view line) {
    std::size_t i = 0;
    const auto blank = [&] { return line[i] == ' ' || line[i] == '\t' || line[i] == '\r'; };
    while (i < line.size()) {
      if (blank()) {
        ++i;
      } else if (line[i] == '#') {
        return;
      } else if (line[i] == '"') {
        words_.push_back({quoted(line, i), true});
        if (i < line.size() && !blank() && line[i] != '#') refuse("expected a blank after the closing quote");
      } else {
        ScriptWord word;
        for (; i < line.size() && !blank(); ++i) word.text += line[i];
        words_.push_back(word);
      }
    }
  }
  std::string quoted(std::string_view line, std::size_t& i) const {
    std::string text;
    for (++i; i < line.size() && line[i] != '"'; ++i) {
      if (line[i] != '\\') {
        text += line[i];
        continue;
      }
      const char c = ++i < line.size() ? line[i] : '\0';
      if (c == 'n')
        text += '\n';
      else if (c == '"' || c == '\\')
        text += c;
      else
        refuse("after a backslash stands one of \" \\ n");
    }
    if (i >= line.size()) refuse("a quote is opened and not closed");
    ++i;
    return text;
  }

  const std::string& name_;
  int number_;
  const std::filesystem::path& folder_;
  std::vector<ScriptWord> words_;
  std::size_t next_ = 0;
};

script::Command drag_of(ScriptWords& words) {
  script::Drag drag;
  drag.from = words.place();
  drag.to = words.place();
  if (words.next_is_number()) drag.steps = words.integer("the number of steps", 1, most_steps);
  drag.button = words.button();
  return drag;
}

script::Command click_of(ScriptWords& words, int times) {
  script::Click click;
  click.at = words.place();
  click.button = words.button();
  click.times = times;
  return click;
}

script::Command hold_of(ScriptWords& words, bool down) {
  const std::string name = words.word("a key");
  const auto key = key_named(name);
  if (!key) words.refuse("there is no key \"" + name + "\"");
  return script::Hold{*key, down};
}

script::Command type_of(ScriptWords& words) {
  const std::string name = words.word("a key, as in ctrl+z");
  const auto chord = chord_named(name);
  if (!chord) words.refuse("there is no key \"" + name + "\"; one is written as z, f1 or ctrl+shift+z");
  return script::Type{*chord};
}

std::filesystem::path file_of(ScriptWords& words) {
  const std::string name = words.word("a file");
  if (name.empty()) words.refuse("expected the name of a file, found an empty one");
  return name;
}

const auto& script_commands() {
  using Reader = script::Command (*)(ScriptWords&);
  static const std::map<std::string_view, Reader> all = {
      {"size",
       [](ScriptWords& w) -> script::Command {
         const int width = w.integer("the width", 1, longest_side);
         return script::Size{width, w.integer("the height", 1, longest_side)};
       }},
      {"move", [](ScriptWords& w) -> script::Command { return script::MoveTo{w.place()}; }},
      {"press", [](ScriptWords& w) -> script::Command { return script::Press{w.button()}; }},
      {"release", [](ScriptWords& w) -> script::Command { return script::Release{w.button()}; }},
      {"click", [](ScriptWords& w) { return click_of(w, 1); }},
      {"doubleclick", [](ScriptWords& w) { return click_of(w, 2); }},
      {"drag", drag_of},
      {"wheel",
       [](ScriptWords& w) -> script::Command {
         const double right = w.number("the notches to the right");
         return script::Wheel{right, w.number("the notches up")};
       }},
      {"key", type_of},
      {"keydown", [](ScriptWords& w) { return hold_of(w, true); }},
      {"keyup", [](ScriptWords& w) { return hold_of(w, false); }},
      {"text", [](ScriptWords& w) -> script::Command { return script::Text{w.word("the text")}; }},
      {"drop", [](ScriptWords& w) -> script::Command { return script::Drop{w.folder() / file_of(w)}; }},
      {"frames",
       [](ScriptWords& w) -> script::Command {
         return script::Frames{w.integer("the number of frames", 1, most_steps)};
       }},
      {"screenshot", [](ScriptWords& w) -> script::Command { return script::Screenshot{file_of(w)}; }},
      {"quit", [](ScriptWords&) -> script::Command { return script::Quit{}; }},
  };
  return all;
}

}  // namespace

Script parse_script(std::string_view text, const std::string& name, const std::filesystem::path& folder) {
  Script result;
  result.name = name;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    ScriptWords words(text.substr(0, length), name, number, folder);
    text.remove_prefix(std::min(length + 1, text.size()));
    if (words.done()) continue;
    const std::string verb = words.word("a command");
    const auto found = script_commands().find(verb);
    if (found == script_commands().end()) {
      std::string known;
      for (const auto& [known_name, reader] : script_commands())
        known += (known.empty() ? "" : ", ") + std::string(known_name);
      words.refuse("\"" + verb + "\" is no command; there are " + known);
    }
    result.lines.push_back({found->second(words), number});
    words.end();
  }
  return result;
}

Script read_script(const std::filesystem::path& path) {
  return parse_script(read_file(path, std::size_t{1} << 24), path.string(), path.parent_path());
}

}  // namespace seesaw
