// Documents out and in again: the text to the letter, the numbers to the bit, the unknown keys in their
// order.
#include "core/scene/document_json.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/base/error.h"
#include "core/base/file.h"
#include "tests/support/scratch_folder.h"

namespace seesaw {
namespace {

// The example of document_json.h.
const char* const example = R"({
  "seesaw": 1,
  "dimension": 2,
  "kernel": "thin_plate_spline",
  "smoothing": 0,
  "constraints": [
    {"kind": "boundary", "at": [0, 1], "normal": [0, 1], "offset": 0.01, "value": 1},
    {"kind": "interior", "at": [0, 0], "value": 1},
    {"kind": "exterior", "at": [2, 2], "value": -1}
  ]
}
)";

Document<2> example_document() {
  Document<2> document;
  document.constraints.push_back({boundary<2>({0, 1}, {0, 1})});
  document.constraints.push_back({interior<2>({0, 0})});
  document.constraints.push_back({exterior<2>({2, 2})});
  return document;
}

// Everything that a 3D document can hold, with keys that nobody knows at every level.
const char* const full = R"({
  "seesaw": 1,
  "dimension": 3,
  "title": "A \"torus\" \\ ring",
  "figure": "turk2002-fig07-right",
  "description": "Sculpted, ü.\nIn two lines.",
  "kernel": "linear",
  "smoothing": 0.25,
  "display": {
    "view": {"min": [-1, -2, -3], "max": [1, 2, 3], "locked": true},
    "field": true,
    "constraints": true,
    "normals": false,
    "palette": "rainbow"
  },
  "camera": {"position": [0, 0, 5], "target": [0, 0, 0], "up": [0, 1, 0], "field_of_view": 30, "lens": "thin"},
  "zebra": null,
  "apple": {"b": [1, 2.0, -3], "a": {}},
  "constraints": [
    {"kind": "boundary", "at": [0, 1, 2]},
    {"kind": "boundary", "at": [0, 1, 2], "normal": [0, 0, 2], "offset": -0.5, "value": -1, "highlight": true, "highlight_normal": true, "label": "spike", "z": 1, "a": []},
    {"kind": "exterior", "at": [9, 9, 9], "value": -0.5}
  ]
}
)";

TEST(DocumentJson, TheExampleOfTheHeader) {
  const Document<2> document = parse_document<2>(example);
  EXPECT_EQ(document, example_document());
  EXPECT_EQ(to_json_text(document), example);
  EXPECT_EQ(to_json_text(parse_document(example)), example);
}

TEST(DocumentJson, ADocumentOfEverythingIsWrittenAsItWasRead) {
  EXPECT_EQ(to_json_text(parse_document(full)), full);
}

TEST(DocumentJson, EverythingIsReadWhereItBelongs) {
  const auto document = parse_document<3>(full);
  EXPECT_EQ(document.title, "A \"torus\" \\ ring");
  EXPECT_EQ(document.figure, "turk2002-fig07-right");
  EXPECT_EQ(document.description, "Sculpted, \xC3\xBC.\nIn two lines.");
  EXPECT_EQ(document.kernel, Kernel::linear);
  EXPECT_EQ(document.smoothing, 0.25);
  ASSERT_TRUE(document.display.view);
  EXPECT_EQ(document.display.view->min(), Point<3>(-1, -2, -3));
  EXPECT_EQ(document.display.view->max(), Point<3>(1, 2, 3));
  EXPECT_EQ(document.display.view_extras, (Extras{{"locked", "true"}}));
  EXPECT_TRUE(document.display.field);
  EXPECT_FALSE(document.display.normals);
  EXPECT_TRUE(document.display.constraints);
  EXPECT_EQ(document.display.extras, (Extras{{"palette", "\"rainbow\""}}));
  ASSERT_TRUE(document.camera);
  EXPECT_EQ(document.camera->position, Point<3>(0, 0, 5));
  EXPECT_EQ(document.camera->field_of_view, 30);
  EXPECT_EQ(document.camera->extras, (Extras{{"lens", "\"thin\""}}));
  EXPECT_EQ(document.extras, (Extras{{"zebra", "null"}, {"apple", "{\"b\": [1, 2.0, -3], \"a\": {}}"}}));
  ASSERT_EQ(document.constraints.size(), 3u);
  EXPECT_FALSE(document.constraints[0].constraint.normal);
  const SceneConstraint<3>& spike = document.constraints[1];
  EXPECT_TRUE(spike.highlight);
  EXPECT_TRUE(spike.highlight_normal);
  EXPECT_EQ(spike.label, "spike");
  EXPECT_EQ(spike.extras, (Extras{{"z", "1"}, {"a", "[]"}}));
  ASSERT_TRUE(spike.constraint.normal);
  EXPECT_EQ(spike.constraint.value, 0);
  EXPECT_EQ(spike.constraint.normal->direction, Point<3>(0, 0, 2));
  EXPECT_EQ(spike.constraint.normal->offset, -0.5);
  EXPECT_EQ(spike.constraint.normal->value, -1);
  EXPECT_EQ(document.constraints[2].constraint.kind, ConstraintKind::exterior);
  EXPECT_EQ(constraints_of(document)[2].value, -0.5);
}

TEST(DocumentJson, WhatIsMissingHasThePapersValues) {
  const auto flat = parse_document<2>(R"({"constraints": [
    {"kind": "boundary", "at": [0, 0], "normal": [1, 0]},
    {"at": [0, 0], "kind": "interior"},
    {"at": [0, 0], "kind": "exterior"},
    {"at": [0, 0], "kind": "boundary", "value": 0}], "dimension": 2, "seesaw": 1})");
  EXPECT_EQ(flat.kernel, Kernel::thin_plate_spline);
  EXPECT_EQ(flat.smoothing, 0);
  EXPECT_EQ(flat.display, Display<2>());
  const Constraints<2> c = constraints_of(flat);
  EXPECT_EQ(c[0].normal->offset, 0.01);
  EXPECT_EQ(c[0].normal->value, 1);
  EXPECT_EQ(c[1].value, 1);
  EXPECT_EQ(c[2].value, -1);
  EXPECT_EQ(c[3].value, 0);
  EXPECT_FALSE(c[3].normal);
  const auto solid = parse_document<3>(R"({"seesaw": 1, "dimension": 3, "constraints": [],
    "camera": {"position": [1, 0, 0], "target": [0, 0, 0]}})");
  EXPECT_EQ(solid.kernel, Kernel::cubic);
  EXPECT_EQ(solid.camera->up, Point<3>(0, 1, 0));
  EXPECT_EQ(solid.camera->field_of_view, 40);
}

TEST(DocumentJson, AnEmptyDocument) {
  const char* const text = R"({
  "seesaw": 1,
  "dimension": 3,
  "kernel": "cubic",
  "smoothing": 0,
  "constraints": []
}
)";
  EXPECT_EQ(to_json_text(Document<3>()), text);
  EXPECT_EQ(parse_document<3>(text), Document<3>());
}

TEST(DocumentJson, SwitchesAreWrittenWhereTheyDifferOrWereWritten) {
  Document<2> document;
  document.display.grid = true;
  EXPECT_NE(to_json_text(document).find("\"display\": {\"grid\": true},"), std::string::npos);
  auto spelled = parse_document<2>(
      R"({"seesaw": 1, "dimension": 2, "constraints": [], "display": {"grid": false, "normals": true}})");
  EXPECT_NE(to_json_text(spelled).find("\"display\": {\"normals\": true, \"grid\": false},"),
            std::string::npos);
  spelled.display.grid = true;
  EXPECT_NE(to_json_text(spelled).find("\"display\": {\"normals\": true, \"grid\": true},"),
            std::string::npos);
}

TEST(DocumentJson, ACameraInTwoDimensionsIsAnUnknownKey) {
  const auto document = parse_document<2>(R"({"seesaw": 1, "dimension": 2, "constraints": [], "camera": 5})");
  EXPECT_EQ(document.extras, (Extras{{"camera", "5"}}));
}

TEST(DocumentJson, LongUnknownValuesAreBrokenOverLinesAndStayTheSame) {
  std::string members;
  for (int i = 0; i < 20; ++i)
    members += (i ? ", " : "") + ("\"member, {" + std::to_string(i)) + "\": [1, \"}]\\\"\"]";
  const std::string value = "{\"inner\": {" + members + "}, \"empty\": []}";
  const auto document =
      parse_document<2>("{\"seesaw\": 1, \"dimension\": 2, \"constraints\": [], \"mine\": " + value + "}");
  EXPECT_EQ(document.extras, (Extras{{"mine", value}}));
  const std::string text = to_json_text(document);
  EXPECT_NE(
      text.find(
          "  \"mine\": {\n    \"inner\": {\n      \"member, {0\": [1, \"}]\\\"\"],\n      \"member, {1\""),
      std::string::npos)
      << text;
  EXPECT_NE(text.find("[1, \"}]\\\"\"]\n    },\n    \"empty\": []\n  },\n"), std::string::npos) << text;
  EXPECT_EQ(parse_document<2>(text), document);
}

TEST(DocumentJson, EqualMeansEverywhere) {
  const auto document = parse_document<3>(full);
  const auto changed = [&](const auto& change) {
    Document<3> copy = document;
    change(copy);
    return !(copy == document);
  };
  EXPECT_FALSE(changed([](Document<3>&) {}));
  EXPECT_TRUE(changed([](Document<3>& d) { d.kernel = Kernel::cubic; }));
  EXPECT_TRUE(changed([](Document<3>& d) { d.smoothing = 0; }));
  EXPECT_TRUE(changed([](Document<3>& d) { d.title.clear(); }));
  EXPECT_TRUE(changed([](Document<3>& d) { d.description.clear(); }));
  EXPECT_TRUE(changed([](Document<3>& d) { d.figure.clear(); }));
  EXPECT_TRUE(changed([](Document<3>& d) { d.extras.pop_back(); }));
  EXPECT_TRUE(changed([](Document<3>& d) { d.camera.reset(); }));
  EXPECT_TRUE(changed([](Document<3>& d) { d.camera->up[0] = 1; }));
  EXPECT_TRUE(changed([](Document<3>& d) { d.camera->extras.clear(); }));
  EXPECT_TRUE(changed([](Document<3>& d) { d.display.view.reset(); }));
  EXPECT_TRUE(changed([](Document<3>& d) { d.display.view->max()[2] = 4; }));
  EXPECT_TRUE(changed([](Document<3>& d) { d.display.view_extras.clear(); }));
  for (const auto& each : display_switches<3>)
    EXPECT_TRUE(changed([&](Document<3>& d) { d.display.*each.member = !(d.display.*each.member); }));
  EXPECT_TRUE(changed([](Document<3>& d) { d.constraints.pop_back(); }));
  EXPECT_TRUE(changed([](Document<3>& d) { d.constraints[1].highlight = false; }));
  EXPECT_TRUE(changed([](Document<3>& d) { d.constraints[1].highlight_normal = false; }));
  EXPECT_TRUE(changed([](Document<3>& d) { d.constraints[1].label = "x"; }));
  EXPECT_TRUE(changed([](Document<3>& d) { d.constraints[1].extras.clear(); }));
  EXPECT_TRUE(changed([](Document<3>& d) { d.constraints[1].constraint.normal.reset(); }));
  EXPECT_TRUE(changed([](Document<3>& d) { d.constraints[1].constraint.normal->offset = 1; }));
  EXPECT_TRUE(changed([](Document<3>& d) { d.constraints[1].constraint.at[0] = 1; }));
  EXPECT_TRUE(changed([](Document<3>& d) { d.constraints[2].constraint.value = -1; }));
}

TEST(DocumentJson, FilesKeepDocuments) {
  const ScratchFolder folder;
  const auto path = folder / "a.json";
  write_document(path, example_document());
  EXPECT_EQ(read_file(path), example);
  EXPECT_EQ(read_document<2>(path), example_document());
  EXPECT_EQ(std::get<Document<2>>(read_document(path)), example_document());
  const AnyDocument solid = parse_document(full);
  write_document(path, solid);
  EXPECT_EQ(read_document(path), solid);
  // A document that cannot be written leaves the old file as it was.
  Document<2> broken;
  broken.smoothing = -1;
  EXPECT_THROW(write_document(path, broken), Error);
  EXPECT_EQ(read_document(path), solid);
}

}  // namespace
}  // namespace seesaw
