// Thirty thousand damaged sessions: each is read or refused by a FileError, and nothing else; what is read
// survives being written, and is replayed or refused by an Error.
//
// The damage is deterministic: set SEESAW_FUZZ_FIRST to the number of an input to have it again;
// SEESAW_FUZZ_COUNT asks for more.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "core/editing/replay.h"
#include "tests/core/editing/documents.h"

namespace seesaw {
namespace {

const std::vector<std::string>& seeds() {
  static const std::vector<std::string> all = {
      R"({"seesaw_session": 1, "dimension": 2, "start": {"seesaw": 1, "dimension": 2, "constraints": [
{"kind": "boundary", "at": [0, 1], "normal": [0, 1], "offset": 0.01, "value": 1},
{"kind": "interior", "at": [0, 0]}, {"kind": "exterior", "at": [2, 2]}]}, "actions": [
{"do": "add", "constraints": [{"kind": "boundary", "at": [1, 0]}, {"kind": "exterior", "at": [5, 5]}]},
{"do": "move", "which": [0, 1], "by": [0.5, -1e-3]},
{"do": "begin"}, {"do": "move_to", "which": 3, "to": [1, 1]}, {"do": "end"},
{"do": "turn_normal", "which": 0, "direction": [1, 1]}, {"do": "undo"}, {"do": "redo"},
{"do": "set_kind", "which": 1, "kind": "boundary"}, {"do": "label", "text": "x"}]}
)",
      R"({"seesaw_session": 1, "dimension": 3, "title": "T", "comment": "C",
"start": {"seesaw": 1, "dimension": 3, "constraints": [{"kind": "boundary", "at": [0, 0, 1]},
{"kind": "boundary", "at": [0, 1, 0]}, {"kind": "boundary", "at": [1, 0, 0]}, {"kind": "interior", "at": [0, 0, 0]}]},
"actions": [{"do": "set_normal", "which": 0, "normal": [0, 0, 1], "offset": 0.1, "value": 0.2},
{"do": "remove_normal", "which": [0]}, {"do": "set_value", "which": 3, "value": 2}, {"do": "delete", "which": [1, 2]},
{"do": "set_kernel", "kernel": "linear"}, {"do": "set_smoothing", "smoothing": 0.5}, {"do": "begin"},
{"do": "cancel"}, {"do": "restore", "document": {"seesaw": 1, "dimension": 3, "constraints": []}, "comment": "c"}]})",
  };
  return all;
}

const std::vector<std::string>& words() {
  static const std::vector<std::string> all = {"0",
                                               "-1",
                                               "1e999",
                                               "1e308",
                                               "2.5",
                                               "99",
                                               "-0.0",
                                               "null",
                                               "true",
                                               "[",
                                               "]",
                                               "{",
                                               "}",
                                               "[]",
                                               "{}",
                                               ",",
                                               ":",
                                               "\"",
                                               "\"do\":",
                                               "\"which\":",
                                               "\"undo\"",
                                               "\"redo\"",
                                               "\"begin\"",
                                               "\"end\"",
                                               "\"delete\"",
                                               "\"cancel\"",
                                               "\"add_normal\"",
                                               "\"move\"",
                                               "\"interior\"",
                                               "\"value\":1,",
                                               "[0,0]",
                                               "[0,0,0]",
                                               "[0,1]",
                                               "\xFF",
                                               "\n",
                                               "{\"do\":\"undo\"},",
                                               "{\"do\":\"delete\",\"which\":[0]},",
                                               "\"comment\":\"x\",",
                                               "\"x\":1,"};
  return all;
}

class Damage {
 public:
  explicit Damage(std::uint64_t number) : random_(number) {}

  std::string input() {
    std::string text = one_of(seeds());
    for (Index left = 1 + random_.index(3); left > 0; --left) damage(text);
    return text;
  }

 private:
  void damage(std::string& text) {
    const Index kind = random_.index(6);
    const std::size_t here = place(text);
    const std::size_t size = 1 + static_cast<std::size_t>(random_.index(30));
    switch (kind) {
      case 0:
        if (!text.empty()) text[here] = static_cast<char>(random_.index(256));
        break;
      case 1:
        text.erase(here, size);
        break;
      case 2:
        text.insert(place(text), text.substr(here, size));
        break;
      case 3: {  // A token becomes a word.
        const auto [begin, length] = token(text);
        text.replace(begin, length, one_of(words()));
        break;
      }
      case 4: {  // Two objects change places, or one is there twice.
        const std::string piece = object(text);
        const std::size_t at = text.find("{\"do\"", place(text));
        if (at != std::string::npos && !piece.empty()) text.insert(at, piece + ",");
        break;
      }
      case 5:
        if (random_.index(4) == 0)
          text.resize(here);
        else
          text.insert(token(text).first, one_of(words()));
        break;
    }
  }

  std::pair<std::size_t, std::size_t> token(const std::string& text) {
    const auto plain = [](char c) {
      return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || c == '-' || c == '.' || c == '_' || c == '"';
    };
    std::size_t begin = place(text);
    while (begin > 0 && begin < text.size() && plain(text[begin]) && plain(text[begin - 1])) --begin;
    std::size_t end = begin;
    while (end < text.size() && plain(text[end])) ++end;
    return {begin, std::max<std::size_t>(end - begin, begin < text.size() ? 1 : 0)};
  }
  std::string object(const std::string& text) {
    const std::size_t begin = text.find("{\"do\"", place(text));
    if (begin == std::string::npos) return {};
    const std::size_t end = text.find('}', begin);
    return end == std::string::npos ? std::string() : text.substr(begin, end + 1 - begin);
  }
  const std::string& one_of(const std::vector<std::string>& items) {
    return items[static_cast<std::size_t>(random_.index(static_cast<Index>(items.size())))];
  }
  std::size_t place(const std::string& text) {
    return text.empty() ? 0 : static_cast<std::size_t>(random_.index(static_cast<Index>(text.size())));
  }

  Random random_;
};

long setting(const char* name, long usual) {
  const char* value = std::getenv(name);
  return value ? std::atol(value) : usual;
}

/// True where the replay came to its end. Whatever happened, undo leads back to the start.
template <int Dim>
bool replayed(const Session<Dim>& session) {
  ReplayOptions<Dim> options;
  options.editor.solve_at_once = false;  // A few of the thirty thousand ask for the shape.
  try {
    Editor<Dim> editor = replay(session, options);
    if (editor.in_gesture()) editor.end_gesture();
    while (editor.undo().changed) {
    }
    EXPECT_EQ(bits_of(editor.document()), bits_of(session.start));
    return true;
  } catch (const FileError& error) {
    EXPECT_GT(error.line(), 0);
    return false;
  }
}

TEST(SessionFuzz, DamagedSessionsAreReadOrRefusedAndNothingElse) {
  const long first = setting("SEESAW_FUZZ_FIRST", 0);
  const long count = setting("SEESAW_FUZZ_COUNT", 30'000);
  long accepted = 0, done = 0;
  for (long number = first; number < first + count; ++number) {
    const std::string input = Damage(static_cast<std::uint64_t>(number)).input();
    std::optional<AnySession> session;
    try {
      session = parse_session(input, "fuzz");
    } catch (const FileError& error) {
      const std::string what = error.what();
      ASSERT_LT(what.size(), 1000u) << number;
      ASSERT_GE(error.line(), what == "fuzz: is empty" ? 0 : 1) << number << what;
      ASSERT_LE(error.line(), 1 + std::count(input.begin(), input.end(), '\n')) << number;
      for (const char c : what) ASSERT_TRUE(c >= ' ' && c <= '~') << number << ": " << what;
      continue;
    } catch (const std::exception& error) {
      FAIL() << "input " << number << ": not a FileError: " << error.what() << "\n" << input;
    }
    ++accepted;
    try {
      const std::string text = to_json_text(*session);
      ASSERT_EQ(to_json_text(parse_session(text, "again")), text) << "input " << number << ":\n" << input;
      done += std::visit([](const auto& each) { return replayed(each); }, *session);
    } catch (const std::exception& error) {
      FAIL() << "input " << number << ": read, but: " << error.what() << "\n" << input;
    }
  }
  // Damage that is always fatal, or never, would test little.
  if (count >= 1000) {
    EXPECT_GT(accepted, count / 50);
    EXPECT_LT(accepted, count / 2);
    EXPECT_GT(done, count / 100);
    EXPECT_LT(done, accepted);
  }
}

}  // namespace
}  // namespace seesaw
