// Every kind of mistake in a file: the exact words, the line and the path.
#include <gtest/gtest.h>

#include <filesystem>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/scene/document_json.h"
#include "tests/support/scratch_folder.h"

namespace seesaw {
namespace {

std::string refusal(std::string_view text) {
  try {
    parse_document(text, "f.json");
  } catch (const FileError& error) {
    EXPECT_EQ(error.path(), "f.json");
    return error.what();
  }
  return "accepted";
}

/// The refusal of a document whose constraints start on line 2, without "f.json:".
std::string in_constraints(const std::string& constraints, int dimension = 2) {
  const std::string what = refusal("{\"seesaw\": 1, \"dimension\": " + std::to_string(dimension) +
                                   ", \"constraints\": [\n" + constraints + "\n]}");
  return what.starts_with("f.json:") ? what.substr(7) : what;
}

/// The refusal of a document with one more member, which starts on line 2.
std::string with(const std::string& member, int dimension = 3) {
  const std::string what = refusal("{\"seesaw\": 1, \"dimension\": " + std::to_string(dimension) +
                                   ", \"constraints\": [],\n" + member + "\n}");
  return what.starts_with("f.json:") ? what.substr(7) : what;
}

TEST(DocumentErrors, WhatIsNoDocumentIsCalledThat) {
  EXPECT_EQ(refusal(""), "f.json: is empty");
  for (const char* text : {"{}", "[1]", "3", "\"seesaw\"", "null", "{\"dimension\": 2, \"constraints\": []}"})
    EXPECT_EQ(refusal(text), "f.json:1: is not a Seesaw document: one is an object with \"seesaw\": 1");
  EXPECT_EQ(refusal("\n\n[]"), "f.json:3: is not a Seesaw document: one is an object with \"seesaw\": 1");
  EXPECT_EQ(refusal("\x89PNG\r\n"), "f.json:1: not JSON: cannot read \"?PNG\"");
}

TEST(DocumentErrors, ANewerVersionIsCalledThatWhateverElseIsInTheFile) {
  EXPECT_EQ(refusal("{\"dimension\": 4,\n\"seesaw\": 2\n}"),
            "f.json:2: seesaw: was made by a newer Seesaw (version 2; this one reads up to 1)");
  EXPECT_EQ(refusal("{\"seesaw\": 0}"), "f.json:1: seesaw: expected the version, 1, found 0");
  EXPECT_EQ(refusal("{\"seesaw\": \"1\"}"), "f.json:1: seesaw: expected a number, found a string");
}

TEST(DocumentErrors, TheDimensionIsTwoOrThree) {
  EXPECT_EQ(refusal("{\n\"seesaw\": 1}"), "f.json:1: dimension: is missing: expected 2 or 3");
  EXPECT_EQ(refusal("{\n\"seesaw\": 1,\n\"dimension\": 4}"), "f.json:3: dimension: expected 2 or 3, found 4");
  EXPECT_EQ(refusal("{\n\"seesaw\": 1,\n\"dimension\": 2.5}"),
            "f.json:3: dimension: expected 2 or 3, found 2.5");
  EXPECT_EQ(refusal("{\n\"seesaw\": 1,\n\"dimension\": null}"),
            "f.json:3: dimension: expected a number, found null");
}

TEST(DocumentErrors, TheConstraintsAreAnArrayOfObjects) {
  EXPECT_EQ(refusal("{\"seesaw\": 1,\n\"dimension\": 2}"),
            "f.json:1: constraints: is missing: expected an array of constraints");
  EXPECT_EQ(refusal("{\"seesaw\": 1,\n\"dimension\": 2,\n\"constraints\": {}}"),
            "f.json:3: constraints: expected an array of constraints, found an object");
  EXPECT_EQ(in_constraints("[0, 1]"), "2: constraints[0]: expected an object, found an array");
}

TEST(DocumentErrors, AConstraintHasAKindAndAPlace) {
  EXPECT_EQ(in_constraints("{\"kind\": \"interior\", \"at\": [0, 0]},\n{\"at\": [0, 0]}"),
            "3: constraints[1].kind: is missing: expected \"boundary\", \"interior\" or \"exterior\"");
  EXPECT_EQ(in_constraints("{\"kind\":\n\"normal\", \"at\": [0, 0]}"),
            "3: constraints[0].kind: expected \"boundary\", \"interior\" or \"exterior\"");
  EXPECT_EQ(in_constraints("{\"kind\":\n7, \"at\": [0, 0]}"),
            "3: constraints[0].kind: expected a string, found a number");
  EXPECT_EQ(in_constraints("\n{\"kind\": \"boundary\"\n}"),
            "3: constraints[0].at: is missing: expected 2 numbers such as [0, 1]");
  EXPECT_EQ(in_constraints("{\"kind\": \"boundary\"}", 3),
            "2: constraints[0].at: is missing: expected 3 numbers such as [0, 1, 0]");
}

TEST(DocumentErrors, APointIsOneFiniteNumberACoordinate) {
  const auto at = [](const std::string& value, int dimension = 2) {
    return in_constraints("{\"kind\": \"boundary\",\n\"at\":\n" + value + "\n}", dimension);
  };
  EXPECT_EQ(at("[0, 1, 2]"), "4: constraints[0].at: expected 2 numbers, found 3");
  EXPECT_EQ(at("[]"), "4: constraints[0].at: expected 2 numbers, found 0");
  EXPECT_EQ(at("[0, 1]", 3), "4: constraints[0].at: expected 3 numbers, found 2");
  EXPECT_EQ(at("5"), "4: constraints[0].at: expected 2 numbers such as [0, 1], found a number");
  EXPECT_EQ(at("{\"x\": 1, \"y\": 2}"),
            "4: constraints[0].at: expected 2 numbers such as [0, 1], found an object");
  EXPECT_EQ(at("[0,\n\"1\"]"), "5: constraints[0].at[1]: expected a number, found a string");
  EXPECT_EQ(at("[0,\n1e999]"), "5: constraints[0].at[1]: 1e999 is too large: numbers end at 1.8e308");
  EXPECT_EQ(at("[-1e999,\n0]"), "4: constraints[0].at[0]: -1e999 is too large: numbers end at 1.8e308");
  EXPECT_EQ(at("[0,\nInfinity]"), "5: constraints[0].at[1]: not JSON: cannot read \"Infinity\"");
}

TEST(DocumentErrors, ANormalHasADirection) {
  const auto normal = [](const std::string& value, const std::string& kind = "boundary") {
    return in_constraints("{\"kind\": \"" + kind + "\", \"at\": [0, 0],\n\"normal\": " + value + "}");
  };
  EXPECT_EQ(normal("[0, -0.0]"),
            "3: constraints[0].normal: the zero vector has no direction: give a vector of any other length");
  EXPECT_EQ(normal("[1e-200, 0]"),
            "3: constraints[0].normal: a vector this short or long has no usable direction: give one of "
            "length about 1");
  EXPECT_EQ(normal("[1e200, 0]"),
            "3: constraints[0].normal: a vector this short or long has no usable direction: give one of "
            "length about 1");
  EXPECT_EQ(normal("[0, 1, 0]"), "3: constraints[0].normal: expected 2 numbers, found 3");
  EXPECT_EQ(normal("[0, 1]", "interior"),
            "3: constraints[0].normal: belongs to a boundary constraint, this one is interior");
  EXPECT_EQ(normal("[1e-100, 1e100]"), "accepted");
}

TEST(DocumentErrors, OffsetAndValueNeedTheNormalTheyBelongTo) {
  const auto boundary = [](const std::string& members) {
    return in_constraints("{\"kind\": \"boundary\", \"at\": [0, 0],\n" + members + "}");
  };
  EXPECT_EQ(boundary("\"offset\": 0.01"),
            "3: constraints[0].offset: belongs to a normal: add a \"normal\" or take the \"offset\" away");
  EXPECT_EQ(
      boundary("\"value\": 1"),
      "3: constraints[0].value: a boundary constraint is 0 by definition: add the \"normal\" that this value "
      "belongs to, or make the kind \"interior\" or \"exterior\"");
  EXPECT_EQ(boundary("\"value\": 0"), "accepted");
  EXPECT_EQ(boundary("\"value\": \"0\""), "3: constraints[0].value: expected a number, found a string");
  EXPECT_EQ(boundary("\"normal\": [0, 1], \"offset\": true"),
            "3: constraints[0].offset: expected a number, found true");
  EXPECT_EQ(in_constraints("{\"kind\": \"exterior\", \"at\": [0, 0],\n\"offset\": 1}"),
            "3: constraints[0].offset: belongs to a boundary constraint, this one is exterior");
}

TEST(DocumentErrors, InsideIsPositiveAndOutsideIsNegative) {
  EXPECT_EQ(in_constraints("{\"kind\": \"interior\", \"at\": [0, 0],\n\"value\": -1}"),
            "3: constraints[0].value: expected a number above 0 inside, found -1");
  EXPECT_EQ(in_constraints("{\"kind\": \"interior\", \"at\": [0, 0],\n\"value\": 0}"),
            "3: constraints[0].value: expected a number above 0 inside, found 0");
  EXPECT_EQ(in_constraints("{\"kind\": \"exterior\", \"at\": [0, 0],\n\"value\": 0.5}"),
            "3: constraints[0].value: expected a number below 0 outside, found 0.5");
  EXPECT_EQ(in_constraints("{\"kind\": \"exterior\", \"at\": [0, 0],\n\"value\": [1]}"),
            "3: constraints[0].value: expected a number, found an array");
}

TEST(DocumentErrors, HighlightAndLabelHaveTheirTypes) {
  EXPECT_EQ(in_constraints("{\"kind\": \"boundary\", \"at\": [0, 0],\n\"highlight\": 1}"),
            "3: constraints[0].highlight: expected true or false, found a number");
  EXPECT_EQ(in_constraints("{\"kind\": \"boundary\", \"at\": [0, 0],\n\"label\": 1}"),
            "3: constraints[0].label: expected a string, found a number");
}

TEST(DocumentErrors, KernelAndSmoothing) {
  EXPECT_EQ(with("\"kernel\": \"gauss\""),
            "2: kernel: expected one of \"thin_plate_spline\", \"cubic\", \"linear\"");
  EXPECT_EQ(with("\"kernel\": 3"), "2: kernel: expected a string, found a number");
  EXPECT_EQ(with("\"smoothing\": -0.5"), "2: smoothing: expected 0 or a positive number, found -0.5");
  EXPECT_EQ(with("\"smoothing\": \"none\""), "2: smoothing: expected a number, found a string");
  EXPECT_EQ(with("\"title\": null"), "2: title: expected a string, found null");
}

TEST(DocumentErrors, Display) {
  EXPECT_EQ(with("\"display\": true"), "2: display: expected an object, found true");
  EXPECT_EQ(with("\"display\": {\n\"field\": 1}"),
            "3: display.field: expected true or false, found a number");
  EXPECT_EQ(with("\"display\": {\n\"view\": {\"min\": [0, 0]}}", 2),
            "3: display.view.max: is missing: expected 2 numbers such as [0, 1]");
  EXPECT_EQ(with("\"display\": {\n\"view\": {\"min\": [0, 0],\n\"max\": [1]}}", 2),
            "4: display.view.max: expected 2 numbers, found 1");
  EXPECT_EQ(with("\"display\": {\n\"view\": {\"min\": [0, 0],\n\"max\": [1, 0]}}", 2),
            "3: display.view: expected \"min\" below \"max\" in every coordinate");
}

TEST(DocumentErrors, Camera) {
  const auto camera = [](const std::string& members) { return with("\"camera\": {\n" + members + "}"); };
  EXPECT_EQ(camera("\"target\": [0, 0, 0]"),
            "2: camera.position: is missing: expected 3 numbers such as [0, 1, 0]");
  EXPECT_EQ(camera("\"position\": [0, 0, 0],\n\"target\": [0, 0, 0]"),
            "4: camera.target: expected another point than the camera's position");
  EXPECT_EQ(camera("\"position\": [0, 0, 1],\n\"target\": [0, 0, 0], \"up\": [0, 0, 0]"),
            "4: camera.up: the zero vector has no direction: give a vector of any other length");
  EXPECT_EQ(camera("\"position\": [0, 0, 1], \"target\": [0, 0, 0],\n\"field_of_view\": 180"),
            "4: camera.field_of_view: expected degrees above 0 and below 180, found 180");
}

TEST(DocumentErrors, AKeyGivenTwiceIsRefusedAtItsSecondLine) {
  EXPECT_EQ(in_constraints("{\"kind\": \"boundary\",\n\"at\": [0, 0],\n\"at\": [0, 1]}"),
            "4: constraints[0].at: the key is given twice");
  EXPECT_EQ(with("\"dimension\": 3"), "2: dimension: the key is given twice");
}

TEST(DocumentErrors, GarbageBehindTheDocument) {
  EXPECT_EQ(refusal("{\"seesaw\": 1, \"dimension\": 2, \"constraints\": []}\n\nmore"),
            "f.json:3: something follows the end of the document");
}

TEST(DocumentErrors, TheOtherDimensionIsRefusedClearly) {
  const std::string flat =
      "{\"seesaw\": 1,\n\"dimension\": 2, \"constraints\": [{\"kind\": \"interior\", \"at\": [0, 0]}]}";
  try {
    parse_document<3>(flat, "f.json");
    FAIL() << "accepted";
  } catch (const FileError& error) {
    EXPECT_STREQ(error.what(), "f.json:2: dimension: this is a 2D document, expected a 3D one");
    EXPECT_EQ(error.line(), 2);
  }
  EXPECT_EQ(parse_document<2>(flat).constraints.size(), 1u);
}

TEST(DocumentErrors, FilesAreNamedByTheirPath) {
  const ScratchFolder folder;
  const auto path = folder / "a.json";
  const auto refusal_of_file = [](const std::filesystem::path& file) -> std::string {
    try {
      read_document(file);
    } catch (const FileError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(refusal_of_file(path), path.string() + ": no such file");
  EXPECT_EQ(refusal_of_file(folder.path()), folder.path().string() + ": is a folder, not a file");
  write_file(path, "");
  EXPECT_EQ(refusal_of_file(path), path.string() + ": is empty");
  write_file(path, "{\n\"seesaw\": 9}");
  EXPECT_EQ(refusal_of_file(path),
            path.string() + ":2: seesaw: was made by a newer Seesaw (version 9; this one reads up to 1)");
}

}  // namespace
}  // namespace seesaw
