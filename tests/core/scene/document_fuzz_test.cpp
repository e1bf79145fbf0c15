// A hundred thousand damaged documents: each is read as a document or refused by a FileError, and nothing
// else; what is read survives being written.
//
// The damage is deterministic, so a failure names the number of its input and can be had again: set
// SEESAW_FUZZ_FIRST to that number. SEESAW_FUZZ_COUNT asks for more inputs.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/base/text.h"
#include "core/scene/document_json.h"

namespace seesaw {
namespace {

const std::vector<std::string>& seeds() {
  static const std::vector<std::string> all = {
      R"({"seesaw":1,"dimension":2,"constraints":[]})",
      R"({"seesaw": 1, "dimension": 2, "kernel": "thin_plate_spline", "smoothing": 0,
 "constraints": [{"kind": "boundary", "at": [0, 1], "normal": [0, 1], "offset": 0.01, "value": 1},
                 {"kind": "interior", "at": [0, 0], "value": 1},
                 {"kind": "exterior", "at": [2, 2], "value": -1}]}
)",
      R"({"seesaw": 1, "dimension": 3, "title": "T \"q\" \u00fc\ud83d\ude42", "figure": "f-1", "description": "a\nb",
"kernel": "cubic", "smoothing": 1e-3,
"display": {"view": {"min": [-1,-1,-1], "max": [1,1,1], "k": 0}, "field": true, "grid": false, "unknown": [1,[2,{}]]},
"camera": {"position": [0,0,5], "target": [0,0,0], "up": [0,1,0], "field_of_view": 35, "x": null},
"constraints": [{"kind": "boundary", "at": [0.1,-0.0,1e-308], "normal": [0,0,-2], "highlight": true, "label": "L", "u": 7},
{"kind": "exterior", "at": [9,9,9]}], "extra": {"deep": [[[{"a": -1.5e+10}]]], "t": true}}
)",
      "\xEF\xBB\xBF{\"constraints\":[{\"at\":[1,2],\"kind\":\"boundary\",\"value\":0}],\r\n\"dimension\":2,"
      "\r\n\"seesaw\":1,"
      "\"display\":{\"normals\":false,\"isolines\":true,\"gradient\":false,\"scale_bar\":true},\"camera\":3}",
  };
  return all;
}

/// Pieces that mean something to the format, or look as if they did.
std::vector<std::string> make_words() {
  using namespace std::string_literals;
  std::vector<std::string> all = {"\xFF",         "\xC0\x80", "\xED\xA0\x80", "\xF0\x9F\x99\x82",
                                  "\xEF\xBB\xBF", "\0"s,      "\n",           "\r\n"};
  all.push_back(std::string(70, '['));
  all.push_back(std::string(62, '[') + std::string(62, ']'));
  all.push_back("1" + std::string(400, '0'));
  all.push_back("0." + std::string(400, '3'));
  std::istringstream plain(R"(
      0 -0 -0.0 1 2 3 -1 1e999 -1e999 1e-999 1e308 5e-324 18446744073709551616 -9223372036854775809
      01 1. .5 +1 NaN -Infinity nan 0x10 1e true false null [ ] { } [] {} , : " \ "" /* // "\ud800" "\u0000"
      "a": "at": "kind": "normal": "value": "offset": "seesaw": "camera": "display": "view": "seesaw":2
      "boundary" "interior" "exterior" "linear" [0,0] [0,0,0] [1e999,0]
      {"a":{"a":{"a":[{"a": {"kind":"interior","at":[1,1]},)");
  for (std::string word; plain >> word;) all.push_back(word);
  return all;
}
const std::vector<std::string>& words() {
  static const std::vector<std::string> all = make_words();
  return all;
}

class Damage {
 public:
  explicit Damage(std::uint64_t number) : random_(number) {}

  std::string input() {
    std::string text = one_of(seeds());
    for (Index left = 1 + random_.index(3); left > 0; --left) damage(text);
    // Small inputs reach as much of the reader as large ones, and there are many.
    if (text.size() > 4000) text.resize(4000);
    return text;
  }

 private:
  void damage(std::string& text) {
    // One draw a statement: compilers differ in which argument of a call they work out first.
    const Index kind = random_.index(12);
    const std::size_t here = place(text);
    switch (kind) {
      case 0: {  // One bit.
        const int bit = static_cast<int>(random_.index(8));
        if (!text.empty()) text[here] = static_cast<char>(text[here] ^ (1 << bit));
        break;
      }
      case 1:  // Any byte.
        text.insert(here, 1, static_cast<char>(random_.index(256)));
        break;
      case 2:  // A piece is gone.
        text.erase(here, 1 + length(20));
        break;
      case 3: {  // A piece is there twice.
        const std::string piece = text.substr(here, 1 + length(60));
        text.insert(place(text), piece);
        break;
      }
      case 4: {  // The end of another document.
        const std::string& other = one_of(seeds());
        text = text.substr(0, here) + other.substr(place(other));
        break;
      }
      case 5:  // A word where it may not belong.
        text.insert(here, one_of(words()));
        break;
      case 6:  // One token becomes another word.
      case 7: {
        const auto [begin, size] = token(text);
        text.replace(begin, size, one_of(words()));
        break;
      }
      case 8:  // Cut short, but not always.
        if (random_.index(4) == 0) {
          text.resize(here);
        } else {  // Two tokens change places.
          const auto [a, a_size] = token(text);
          const std::string first = text.substr(a, a_size);
          const auto [b, b_size] = token(text);
          const std::string second = text.substr(b, b_size);
          if (a + a_size <= b) {
            text.replace(b, b_size, first);
            text.replace(a, a_size, second);
          }
        }
        break;
      case 9: {  // A number becomes another number.
        const std::size_t digit = text.find_first_of("0123456789", here);
        if (digit == std::string::npos) break;
        std::size_t begin = digit, end = digit;
        while (begin > 0 && number_sign(text[begin - 1])) --begin;
        while (end < text.size() && number_sign(text[end])) ++end;
        text.replace(begin, end - begin, number());
        break;
      }
      case 10: {  // An object gets one more member.
        const std::size_t brace = text.find('{', here);
        if (brace == std::string::npos) break;
        const std::string key = "\"key" + std::to_string(random_.index(20)) + "\": ";
        text.insert(brace + 1, key + one_of(words()) + ",");
        break;
      }
      case 11: {  // Room around a token.
        const std::size_t begin = token(text).begin;
        text.insert(begin, one_of<std::string>({" ", "\n", "\r\n", "\t \n\n"}));
        break;
      }
    }
  }

  template <class Item>
  const Item& one_of(const std::vector<Item>& items) {
    return items[static_cast<std::size_t>(random_.index(static_cast<Index>(items.size())))];
  }
  std::size_t place(const std::string& text) {
    return text.empty() ? 0 : static_cast<std::size_t>(random_.index(static_cast<Index>(text.size())));
  }
  std::size_t length(Index most) { return static_cast<std::size_t>(random_.index(most)); }

  static bool number_sign(char c) {
    return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.' || c == 'e';
  }
  std::string number() {
    switch (random_.index(4)) {
      case 0:
        return std::to_string(random_.index(7) - 3);
      case 1:
        return to_text(random_.uniform(-2, 2), 3);
      case 2:
        return to_text(std::bit_cast<double>(random_.bits()), 17);  // "nan" and "inf" among them, rarely
      default:
        return to_text(random_.normal(), 17);
    }
  }

  struct Token {
    std::size_t begin, size;
  };
  /// A number, word, string or sign somewhere behind a random place.
  Token token(const std::string& text) {
    const auto plain = [](char c) {
      return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || c == '-' || c == '+' || c == '.' || c == '_';
    };
    std::size_t begin = text.find_first_not_of(" \n\r", place(text));
    if (begin == std::string::npos) return {text.size(), 0};
    while (begin > 0 && plain(text[begin]) && plain(text[begin - 1])) --begin;
    std::size_t end = begin + 1;
    if (text[begin] == '"') {
      end = std::min(text.find('"', begin + 1), text.size() - 1) + 1;
    } else if (plain(text[begin])) {
      while (end < text.size() && plain(text[end])) ++end;
    }
    return {begin, end - begin};
  }

  Random random_;
};

long setting(const char* name, long usual) {
  const char* value = std::getenv(name);
  return value ? std::atol(value) : usual;
}

TEST(DocumentFuzz, DamagedDocumentsAreReadOrRefusedAndNothingElse) {
  const long first = setting("SEESAW_FUZZ_FIRST", 0);
  const long count = setting("SEESAW_FUZZ_COUNT", 100'000);
  long accepted = 0;
  for (long number = first; number < first + count; ++number) {
    const std::string input = Damage(static_cast<std::uint64_t>(number)).input();
    std::optional<AnyDocument> document;
    try {
      document = parse_document(input, "fuzz");
    } catch (const FileError& error) {
      const std::string what = error.what();
      ASSERT_LT(what.size(), 1000u) << number;
      ASSERT_LE(error.line(), 1 + std::count(input.begin(), input.end(), '\n')) << number;
      for (const char c : what) ASSERT_TRUE(c >= ' ' && c <= '~') << number << ": " << what;
      continue;
    } catch (const std::exception& error) {
      FAIL() << "input " << number << ": not a FileError: " << error.what() << "\n" << input;
    }
    ++accepted;
    try {
      const std::string text = to_json_text(*document);
      const AnyDocument again = parse_document(text, "again");
      ASSERT_TRUE(again == *document) << "input " << number << ":\n" << input << "\n" << text;
      ASSERT_EQ(to_json_text(again), text) << "input " << number << ":\n" << input;
    } catch (const std::exception& error) {
      FAIL() << "input " << number << ": read, but: " << error.what() << "\n" << input;
    }
  }
  // Damage that is always fatal, or never, would test little.
  if (count >= 1000) {
    EXPECT_GT(accepted, count / 50);
    EXPECT_LT(accepted, count / 2);
  }
  RecordProperty("accepted", std::to_string(accepted));
}

}  // namespace
}  // namespace seesaw
