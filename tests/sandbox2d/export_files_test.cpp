#include "sandbox2d/export_files.h"

#include <gmock/gmock.h>

#include <sstream>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/image/png.h"
#include "core/scene/document_json.h"
#include "tests/support/scratch_folder.h"

namespace seesaw {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::vector<std::filesystem::path> plane_scenes() {
  std::vector<std::filesystem::path> scenes;
  for (const auto& each :
       std::filesystem::directory_iterator(std::filesystem::path(SEESAW_SOURCE_DIR) / "figures/scenes"))
    if (std::holds_alternative<Document<2>>(read_document(each.path()))) scenes.push_back(each.path());
  return scenes;
}

Document<2> first_figure() {
  return read_document<2>(std::filesystem::path(SEESAW_SOURCE_DIR) /
                          "figures/scenes/turk2002-fig01-left.json");
}

std::vector<Polyline> polylines_of(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "polyline,closed,x,y");
  std::vector<std::vector<Point<2>>> points;
  std::vector<bool> closed;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    std::string number, is_closed, x, y;
    std::getline(cells, number, ',');
    std::getline(cells, is_closed, ',');
    std::getline(cells, x, ',');
    std::getline(cells, y, ',');
    if (std::stoul(number) == points.size()) {
      points.emplace_back();
      closed.push_back(is_closed == "1");
    }
    points.back().push_back({*parse_number(x), *parse_number(y)});
  }
  std::vector<Polyline> polylines;
  for (std::size_t k = 0; k < points.size(); ++k) {
    Polyline polyline;
    polyline.closed = closed[k];
    polyline.vertices.resize(2, static_cast<Index>(points[k].size()));
    for (Index i = 0; i < polyline.vertices.cols(); ++i)
      polyline.vertices.col(i) = points[k][static_cast<std::size_t>(i)];
    polylines.push_back(polyline);
  }
  return polylines;
}

TEST(ExportFiles, EverySceneIsTheSamePictureAsItsFigure) {
  ScratchFolder folder;
  const auto scenes = plane_scenes();
  EXPECT_GE(scenes.size(), 10u);
  for (const auto& scene : scenes) {
    const auto document = read_document<2>(scene);
    const Fit<2> fitted = fit(document);
    export_document(folder / "a.png", document, fitted.function, {.pixels_per_point = 1});
    EXPECT_EQ(read_png(folder / "a.png"), picture_of(document, fitted.function).image(1)) << scene;
  }
}

TEST(ExportFiles, APictureHasTheProportionsAndThePartThatIsShown) {
  ScratchFolder folder;
  Document<2> document = first_figure();
  const Fit<2> fitted = fit(document);
  document.display.view = Box<2>(Point<2>(0, 0), Point<2>(2, 1));
  export_document(folder / "a.png", document, fitted.function, {.size = 200, .pixels_per_point = 3});
  const Image picture = read_png(folder / "a.png");
  EXPECT_EQ(picture.width(), 600);
  EXPECT_EQ(picture.height(), 300);
  document.display.view = Box<2>(Point<2>(0, 0), Point<2>(1, 1e-9));
  EXPECT_EQ(picture_of(document, fitted.function, 200).height(), 40) << "a sliver";
}

TEST(ExportFiles, EachKindBeginsAsItShould) {
  ScratchFolder folder;
  const Document<2> document = first_figure();
  const Fit<2> fitted = fit(document);
  for (const FileKind& kind : export_kinds())
    export_document(folder / ("a" + kind.ending), document, fitted.function);
  EXPECT_THAT(read_file(folder / "a.png"), StartsWith("\x89PNG"));
  EXPECT_THAT(read_file(folder / "a.svg"), StartsWith("<?xml"));
  EXPECT_THAT(read_file(folder / "a.svg"), HasSubstr("<svg"));
  EXPECT_THAT(read_file(folder / "a.pdf"), StartsWith("%PDF-"));
  EXPECT_EQ(read_document<2>(folder / "a.json"), document);
  export_document(folder / "B.SVG", document, fitted.function);
  EXPECT_EQ(read_file(folder / "B.SVG"), read_file(folder / "a.svg"));
}

TEST(ExportFiles, NumbersReadBackToTheSameCurve) {
  ScratchFolder folder;
  for (const auto& scene : plane_scenes()) {
    const auto document = read_document<2>(scene);
    const Fit<2> fitted = fit(document);
    export_document(folder / "a.csv", document, fitted.function, {.cells = 40});
    const Contour curve =
        contour(document, fitted.function, view_box(document, fitted.function), {.cells = 40});
    const auto read = polylines_of(read_file(folder / "a.csv"));
    ASSERT_EQ(read.size(), curve.polylines.size()) << scene;
    for (std::size_t k = 0; k < read.size(); ++k) {
      EXPECT_EQ(read[k].closed, curve.polylines[k].closed);
      EXPECT_EQ(read[k].vertices, curve.polylines[k].vertices) << "to the bit";
    }
  }
}

TEST(ExportFiles, WhatFailsLeavesNothingBehind) {
  ScratchFolder folder;
  const Document<2> document = first_figure();
  const Fit<2> fitted = fit(document);
  const auto trouble = [&](const std::filesystem::path& path, const ExportOptions& options = {}) {
    try {
      export_document(path, document, fitted.function, options);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  EXPECT_THAT(trouble(folder / "a.gif"), HasSubstr("a.gif: expected a name that ends in .png"));
  EXPECT_THAT(trouble(folder / "a"), HasSubstr("expected a name"));
  EXPECT_THAT(trouble(folder / "none/a.png"), HasSubstr("there is no folder"));
  EXPECT_THAT(trouble(folder / "a.png", {.pixels_per_point = 1000}), HasSubstr("cannot be made"));
  for (const FileKind& kind : export_kinds()) {
    std::filesystem::create_directory(folder / ("b" + kind.ending));
    EXPECT_THAT(trouble(folder / ("b" + kind.ending)), HasSubstr("is a folder"));
    std::filesystem::remove(folder / ("b" + kind.ending));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  folder.with("old.png", "old");
  EXPECT_THAT(trouble(folder / "old.png", {.pixels_per_point = 1000}), HasSubstr("cannot be made"));
  EXPECT_EQ(read_file(folder / "old.png"), "old");
}

}  // namespace
}  // namespace seesaw
