// The tape: values with the lines they stand on, and the texts that are no JSON for us.
#include "core/scene/json_tape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/base/error.h"

namespace seesaw {
namespace {

/// The error of a text that is refused, named "t".
std::string tape_refusal(std::string_view text, const JsonLimits& limits = {}) {
  try {
    parse_json(text, "t", limits);
  } catch (const FileError& error) {
    EXPECT_EQ(error.path(), "t");
    return error.what();
  }
  return "accepted";
}

void collect(JsonValue value, std::map<std::string, int>& lines) {
  lines[value.path()] = value.line();
  if (value.type() == JsonType::array) value.each_item([&](JsonValue item) { collect(item, lines); });
  if (value.type() == JsonType::object)
    value.each_member([&](std::string_view, JsonValue member) { collect(member, lines); });
}

std::map<std::string, int> lines_of(std::string_view text) {
  const JsonTape tape = parse_json(text, "t");
  std::map<std::string, int> lines;
  collect(JsonValue(tape), lines);
  return lines;
}

using Lines = std::map<std::string, int>;

TEST(JsonTape, EveryValueKnowsItsLineAlsoWhereANumberEndsIt) {
  EXPECT_EQ(
      lines_of("{\"a\": 1\n,\n\"b\": [2\n\n, -3.5\n,true\n,\"x\"\n, null]\n, \"c\":\n {\"d\":\n\n4\n}}"),
      (Lines{{"", 1},
             {"a", 1},
             {"b", 3},
             {"b[0]", 3},
             {"b[1]", 5},
             {"b[2]", 6},
             {"b[3]", 7},
             {"b[4]", 8},
             {"c", 10},
             {"c.d", 12}}));
}

TEST(JsonTape, LinesMayEndInCarriageReturnAndNewline) {
  EXPECT_EQ(lines_of("[1\r\n,2\r\n,\r\n3]"), (Lines{{"", 1}, {"[0]", 1}, {"[1]", 2}, {"[2]", 4}}));
}

TEST(JsonTape, ANumberMayEndTheText) {
  EXPECT_EQ(lines_of("\n\n7"), (Lines{{"", 3}}));
  EXPECT_EQ(lines_of("\n\n7\n\n"), (Lines{{"", 3}}));
}

TEST(JsonTape, AByteOrderMarkIsSkippedOnce) {
  EXPECT_EQ(lines_of("\xEF\xBB\xBF\n[\n1]"), (Lines{{"", 2}, {"[0]", 3}}));
  EXPECT_EQ(tape_refusal("\xEF\xBB\xBF\xEF\xBB\xBF[]"), "t:1: not JSON: cannot read \"\?\?\?\?\?\?\"");
}

TEST(JsonTape, ValuesKeepTheirTypeAndEveryBit) {
  const JsonTape tape = parse_json(
      R"([0, -0, -0.0, 18446744073709551615, -9223372036854775808, 9007199254740993, 5e-324, 1e-999, true, "\u00e9\n"])",
      "t");
  std::vector<JsonValue> v;
  JsonValue(tape).each_item([&](JsonValue item) { v.push_back(item); });
  ASSERT_EQ(v.size(), 10u);
  EXPECT_FALSE(std::signbit(v[0].number()));
  EXPECT_TRUE(v[1].number() == 0 && std::signbit(v[1].number()));
  EXPECT_TRUE(v[2].number() == 0 && std::signbit(v[2].number()));
  EXPECT_EQ(v[3].number(), 0x1p64);
  EXPECT_EQ(v[4].number(), -0x1p63);
  EXPECT_EQ(v[5].number(), 0x1p53);  // halfway, so to even
  EXPECT_EQ(v[6].number(), 0x1p-1074);
  EXPECT_EQ(v[7].number(), 0.0);
  EXPECT_TRUE(v[8].boolean());
  EXPECT_EQ(v[9].text(), "\xC3\xA9\n");
  EXPECT_EQ(
      JsonValue(tape).json(),
      "[0, -0.0, -0.0, 18446744073709551615, -9223372036854775808, 9007199254740993, 5e-324, 0.0, true, "
      "\"\xC3\xA9\\n\"]");
}

TEST(JsonTape, PathsQuoteKeysThatAreNoWords) {
  const Lines lines =
      lines_of("{\"a b\": {\"\": [0]}, \"\xC3\xA9\": 1, \"" + std::string(50, 'k') + "\": 2}");
  EXPECT_EQ(lines, (Lines{{"", 1},
                          {"[\"a b\"]", 1},
                          {"[\"a b\"][\"\"]", 1},
                          {"[\"a b\"][\"\"][0]", 1},
                          {"[\"??\"]", 1},
                          {"[\"" + std::string(40, 'k') + "...\"]", 1}}));
}

TEST(JsonTape, ArraysAndObjectsKnowTheirSize) {
  const JsonTape tape = parse_json(R"({"a": [1, [2, 3], {}], "b": {"x": [], "y": "z"}})", "t");
  const JsonValue top(tape);
  EXPECT_EQ(top.size(), 2u);
  EXPECT_EQ(top.find("a")->size(), 3u);
  EXPECT_EQ(top.find("b")->size(), 2u);
  EXPECT_EQ(top.find("b")->find("x")->size(), 0u);
  EXPECT_FALSE(top.find("x"));
}

TEST(JsonTape, AKeyIsGivenOnce) {
  EXPECT_EQ(tape_refusal("{\"a\": {\"x\": 1,\n\"y\": [{}, {}],\n\"x\": 2}}"),
            "t:3: a.x: the key is given twice");
  EXPECT_EQ(tape_refusal("[0, {\"b\": 1, \"a\": 1,\n\"a\": 2,\n\"b\": 2}]"),
            "t:2: [1].a: the key is given twice");
  EXPECT_EQ(tape_refusal("{\"a\": 1,\n\"\\u0061\": 2}"), "t:2: a: the key is given twice");
  EXPECT_EQ(tape_refusal("[{\"a\": {\"a\": 1}}, {\"a\": 1}]"), "accepted");
}

TEST(JsonTape, NumbersBeyondDoublesAreRefusedWithTheirPath) {
  EXPECT_EQ(tape_refusal("{\"a\": [0,\n{\"b\": 1e999\n}]}"),
            "t:2: a[1].b: 1e999 is too large: numbers end at 1.8e308");
  EXPECT_EQ(tape_refusal("[1,\n-1" + std::string(400, '0') + "]"),
            "t:2: [1]: -1" + std::string(38, '0') + "... is too large: numbers end at 1.8e308");
}

TEST(JsonTape, WordsThatAreNoJsonAreRefusedWithTheirPath) {
  EXPECT_EQ(tape_refusal("{\"a\": [0,\nNaN]}"), "t:2: a[1]: not JSON: cannot read \"NaN\"");
  EXPECT_EQ(tape_refusal("[1,\n]"),
            "t:2: [1]: not JSON: unexpected ']'; expected '[', "
            "'{', or a literal");
  EXPECT_EQ(tape_refusal("{\"a\": 1 // one\n}"), "t:1: not JSON: cannot read \"//\"");
}

TEST(JsonTape, AMissingCommaIsBlamedOnTheLineThatShowsIt) {
  EXPECT_EQ(tape_refusal("[1\n2]"), "t:2: not JSON: unexpected number literal; expected ']'");
  EXPECT_EQ(tape_refusal("{\"a\": 1\n\n\"b\": 2}"), "t:3: not JSON: unexpected string literal; expected '}'");
}

TEST(JsonTape, ATextThatEndsEarlyIsBlamedOnItsLastLine) {
  EXPECT_EQ(tape_refusal("{\"a\": [1,\n2\n"), "t:2: not JSON: unexpected end of input; expected ']'");
  EXPECT_EQ(tape_refusal("[1,\n\"abc"), "t:2: [1]: not JSON: invalid string: missing closing quote");
}

TEST(JsonTape, NothingMayFollow) {
  EXPECT_EQ(tape_refusal("{}\n{}"), "t:2: something follows the end of the document");
  EXPECT_EQ(tape_refusal("1\n\n x"), "t:3: something follows the end of the document");
  EXPECT_EQ(tape_refusal("{}\n]"), "t:2: something follows the end of the document");
  EXPECT_EQ(tape_refusal("{}\n\n\n"), "accepted");
}

TEST(JsonTape, AZeroByteDoesNotHideTheRest) {
  using namespace std::string_literals;
  EXPECT_EQ(tape_refusal("{}\n\0"s), "t:2: something follows the end of the document");
  EXPECT_EQ(tape_refusal("{}\n\0{}"s), "t:2: something follows the end of the document");
  EXPECT_EQ(tape_refusal("1\0"s), "t:1: something follows the end of the document");
  EXPECT_EQ(tape_refusal("\0"s),
            "t:1: not JSON: unexpected end of input; expected '[', "
            "'{', or a literal");
}

TEST(JsonTape, OnlyUtf8IsText) {
  EXPECT_EQ(tape_refusal("[1,\n\"a\xFF\"]"), "t:2: not JSON: a string holds bytes that are not UTF-8");
  EXPECT_EQ(tape_refusal("[\"\xC0\x80\"]"), "t:1: not JSON: a string holds bytes that are not UTF-8");
  EXPECT_EQ(tape_refusal("{\n\"\xED\xA0\x80\": 1}"),
            "t:2: not JSON: a string holds bytes that are not UTF-8");
  EXPECT_EQ(tape_refusal(std::string("\xFF\xFE{\0}\0", 6)), "t:1: is UTF-16 text: save it as UTF-8");
  EXPECT_EQ(tape_refusal("[\"\xF0\x9F\x99\x82\"]"), "accepted");
}

TEST(JsonTape, ALongCulpritIsCutAndBareBytesAreNotRepeated) {
  const std::string error = tape_refusal("[\"" + std::string(100000, 'a') + "\x01\"]");
  EXPECT_LT(error.size(), 220u);
  for (const char c : error) EXPECT_TRUE(c >= ' ' && c <= '~');
}

TEST(JsonTape, AnEmptyTextIsCalledEmpty) {
  for (const char* text : {"", " \n\t\r\n", "\xEF\xBB\xBF", "\xEF\xBB\xBF\n"})
    EXPECT_EQ(tape_refusal(text), "t: is empty");
}

TEST(JsonTape, SixtyFourLevelsAreReadAndNoMore) {
  const auto nested = [](int levels) { return std::string(levels, '[') + std::string(levels, ']'); };
  EXPECT_EQ(tape_refusal(nested(64)), "accepted");
  EXPECT_EQ(tape_refusal(nested(65)), "t:1: is nested deeper than the 64 levels that are read");
  EXPECT_EQ(tape_refusal("\n" + std::string(5'000'000, '[')),
            "t:2: is nested deeper than the 64 levels that are read");
  std::string objects;
  for (int i = 0; i < 100000; ++i) objects += "{\"a\":";
  EXPECT_EQ(tape_refusal(objects), "t:1: is nested deeper than the 64 levels that are read");
}

TEST(JsonTape, HugeTextsAreRefusedBeforeTheyFillTheMemory) {
  EXPECT_EQ(tape_refusal("[1, 2, 3]", {.bytes = 8}), "t: is larger than the 8 bytes that are read");
  EXPECT_EQ(tape_refusal("[1, 2, 3]", {.bytes = 9, .values = 4}), "accepted");
  EXPECT_EQ(tape_refusal("[1, 2,\n3\n]", {.values = 3}), "t:2: holds more than the 3 values that are read");
  EXPECT_EQ(JsonLimits().bytes, 256u * 1024 * 1024);
}

TEST(JsonTape, AnObjectOfAHundredThousandKeysIsReadAtOnce) {
  std::string text = "{";
  for (int i = 0; i < 100000; ++i) text += "\"k" + std::to_string(i) + "\":0,\n";
  EXPECT_EQ(tape_refusal(text + "\"z\":0}"), "accepted");
  EXPECT_EQ(tape_refusal(text + "\"k77\":0}"), "t:100001: k77: the key is given twice");
}

}  // namespace
}  // namespace seesaw
