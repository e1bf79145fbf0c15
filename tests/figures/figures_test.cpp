// Every figure of the catalog: its checks hold, its facts have the agreed names, its picture looks like its
// reference.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "core/image/compare.h"
#include "core/image/png.h"
#include "core/raytrace/camera.h"
#include "core/raytrace/heuristic_tracer.h"
#include "core/raytrace/rigorous_tracer.h"
#include "core/rbf/fit.h"
#include "core/scene/document_json.h"
#include "figures/catalog.h"
#include "figures/compose.h"
#include "figures/gallery.h"
#include "figures/output.h"
#include "figures/paths.h"
#include "tests/support/scratch_folder.h"

namespace seesaw {
namespace {

namespace fs = std::filesystem;

// Ray-traced pictures at the references' size.
FigureContext quick_context() {
  FigureContext context = figure_context();
  context.pixels_per_point = 1;
  return context;
}

class FigureTest : public testing::TestWithParam<FigureEntry> {
 protected:
  static const Figure& figure() {
    static std::map<std::string, Figure> made;
    const auto& entry = GetParam();
    if (!made.count(entry.id)) made.emplace(entry.id, entry.make(quick_context()));
    return made.at(entry.id);
  }
  void SetUp() override {
    try {
      figure();
    } catch (const MissingPackage& missing) {
      GTEST_SKIP() << missing.what();
    }
  }
};

TEST_P(FigureTest, ItsChecksHold) {
  EXPECT_EQ(figure().id, GetParam().id);
  EXPECT_FALSE(figure().checks.empty());
  for (const Check& check : figure().checks)
    EXPECT_TRUE(check.holds()) << check.name << ": " << check.value << ", bound " << check.bound;
  EXPECT_TRUE(figure().holds());
}

TEST_P(FigureTest, ItSaysWhatItShows) {
  EXPECT_FALSE(figure().paper.empty());
  EXPECT_FALSE(figure().shows.empty());
  EXPECT_FALSE(figure().caption.empty());
  std::set<std::string> names;
  for (const Panel& panel : figure().panels) {
    EXPECT_TRUE(names.insert(panel.name).second) << "two panels are called " << panel.name;
    EXPECT_FALSE(panel.facts.empty()) << panel.name;
  }
}

// The names of figures/facts.h, on which whoever reads a figure's JSON relies.
const std::vector<std::string> names_of_constraints = {"boundary", "interior", "exterior", "normal", "total"};
const std::vector<std::string> names_of_fit = {"constraints",          "kernel", "max_residual",
                                               "reciprocal_condition", "energy", "fit_seconds"};
const std::vector<std::string> names_of_curve = {
    "components", "closed", "euler_characteristic", "genus", "boundary_edges", "area", "length"};

/// Every number under its name, none of them missing where any is there. False where there is none at all.
bool reports_fit(const Facts& facts) {
  if (std::ranges::none_of(names_of_fit, [&](const auto& name) { return facts.contains(name); }))
    return false;
  for (const std::string& name : names_of_fit) EXPECT_TRUE(facts.contains(name)) << name;
  const Facts constraints = facts.value("constraints", Facts::object());
  for (const std::string& name : names_of_constraints)
    EXPECT_TRUE(constraints.contains(name) && constraints[name].is_number_integer()) << name;
  EXPECT_GT(constraints.value("total", 0), 0);
  for (const char* name : {"max_residual", "reciprocal_condition", "energy", "fit_seconds"})
    EXPECT_GE(facts.value(name, -1.0), 0) << name;
  return true;
}

/// The same of a curve: only curves have a length, or count those that are closed.
bool reports_curve(const Facts& facts) {
  if (!facts.contains("length") && !facts.contains("closed")) return false;
  for (const std::string& name : names_of_curve)
    EXPECT_TRUE(facts.contains(name) && facts[name].is_number()) << name;
  EXPECT_GT(facts.value("components", 0), 0);
  EXPECT_GT(facts.value("length", 0.0), 0);
  return true;
}

TEST_P(FigureTest, ItsFactsHaveTheAgreedNames) {
  for (const Panel& panel : figure().panels) {
    SCOPED_TRACE(panel.name);
    reports_fit(panel.facts);
    reports_curve(panel.facts);
    if (figure().id == "turk2002-fig01") {
      EXPECT_TRUE(reports_fit(panel.facts) && reports_curve(panel.facts));
      EXPECT_EQ(panel.facts["constraints"]["total"], panel.name == "left" ? 5 : 8);
    }
  }
}

TEST_P(FigureTest, ItsFilesAreAsDescribed) {
  const ScratchFolder scratch;
  const fs::path folder = scratch / "made by it";
  write_figure(figure(), folder, 0.5);
  EXPECT_TRUE(fs::exists(folder / (figure().id + ".png")));
  const Facts description = Facts::parse(std::ifstream(folder / (figure().id + ".json")));
  EXPECT_EQ(description["figure"], figure().id);
  EXPECT_EQ(description["holds"], true);
  ASSERT_EQ(description["panels"].size(), figure().panels.size());
  for (const auto& panel : description["panels"]) {
    EXPECT_FALSE(read_png(folder / panel["png"].get<std::string>()).empty());
    EXPECT_TRUE(panel["facts"].is_object());
  }
  for (const auto& check : description["checks"])
    for (const char* key : {"name", "value", "bound", "holds"}) EXPECT_TRUE(check.contains(key)) << key;
}

TEST_P(FigureTest, ItLooksLikeItsReference) {
  const Image picture = compose(figure()).image(1);
  const fs::path path = reference_folder() / (GetParam().id + ".png");
  ASSERT_TRUE(fs::exists(path)) << "make it: figures make " << GetParam().id
                                << " --update-references, and look at it";
  const Image reference = read_png(path);
  const Comparison comparison = compare_images(picture, reference);
  // A line moved by a pixel reaches about 16 and a missing symbol more than 25; the mean catches a change of
  // color.
  const bool alike =
      comparison.same_size &&
      (figure().shows_times ? comparison.mean < 3 : comparison.worst < 18 && comparison.mean < 0.5);
  EXPECT_TRUE(alike) << "worst " << comparison.worst << ", mean " << comparison.mean << ", noticeable "
                     << comparison.noticeable;
  if (!alike) {
    const fs::path shown = picture_to_look_at(GetParam().id + "-difference.png");
    write_png(shown, difference_picture(picture, reference));
    std::cout << "ours, reference and difference: " << shown << '\n';
  }
}

std::string name_of_case(const testing::TestParamInfo<FigureEntry>& info) {
  std::string name = info.param.id;
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
}
INSTANTIATE_TEST_SUITE_P(All, FigureTest, testing::ValuesIn(catalog()), name_of_case);

TEST(Figures, EverySceneFileBelongsToAFigureAndOpens) {
  std::size_t count = 0;
  for (const auto& file : fs::directory_iterator(scenes_folder())) {
    std::visit(
        [&](const auto& document) {
          EXPECT_NE(figure_named(document.figure), nullptr) << file.path();
          EXPECT_FALSE(document.title.empty()) << file.path();
          EXPECT_FALSE(document.description.empty()) << file.path();
        },
        read_document(file.path()));
    ++count;
  }
  EXPECT_GE(count, 9u);
}

// The blade of sphere-tracing in its own wide box, seen from where one ray once slipped through by proof: it
// grazed the rim on a chord of 70 resolutions.
TEST(Figures, ProofStopsEveryRayOfTheBladesRimThatSamplesStop) {
  const auto document = read_document<3>(scenes_folder() / "sphere-tracing-blade.json");
  const auto field =
      std::make_shared<Interpolant<3>>(fit(constraints_of(document), {.kernel = document.kernel}).function);
  const PinholeCamera camera =
      frame(bounding_box_of<3>(boundary_points(document)), {.direction = {0.5, -0.35, 0.8}, .margin = 0.12});
  constexpr int n = 300;
  std::vector<Ray> rays;
  for (int y = 20; y < 40; ++y)
    for (int x = 0; x < n; ++x) rays.push_back(ray_through(camera, (x + 0.5) / n, (y + 0.5) / n, 1));
  std::vector<RayCrossings> by_proof(rays.size()), by_samples(rays.size());
  RigorousTracer(field).trace(rays, HowMany::all, by_proof);
  HeuristicTracer(field).trace(rays, HowMany::all, by_samples);
  Index stopped = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (by_samples[i].crossings.empty()) continue;
    ++stopped;
    EXPECT_FALSE(by_proof[i].crossings.empty()) << "ray " << i;
  }
  const double promised = RigorousOptions().resolution * field->bounding_box().sizes().norm();
  for (const RayCrossings& ray : by_proof) EXPECT_LE(ray.unproven, promised * (1 + 1e-9));
  EXPECT_GT(stopped, 100);
}

TEST(Figures, AFailedCheckFailsTheFigure) {
  Figure figure;
  figure.checks = {at_most("small", 1, 2), at_least("large", 3, 2), equal("same", 2, 2)};
  EXPECT_TRUE(figure.holds());
  figure.checks.push_back(at_most("not a number", std::nan(""), 1));
  EXPECT_FALSE(figure.holds());
  EXPECT_FALSE(at_most("", 3, 2).holds());
  EXPECT_FALSE(at_least("", 1, 2).holds());
  EXPECT_FALSE(equal("", 1, 2).holds());
}

TEST(Figures, AMissingPackageIsNamedAndNothingElseSuffers) {
  const MissingPackage missing("glmark2-data", "/usr/share/glmark2/models/bunny.obj");
  EXPECT_NE(std::string(missing.what()).find("glmark2-data"), std::string::npos);
  Figure other{.id = "other", .paper = "p", .title = "Other", .shows = "s", .caption = "c"};
  const std::string page = gallery_page(
      {description_of_missing({"x", "a bunny", nullptr}, missing.what()), description_of(other)});
  EXPECT_NE(page.find("Not made: needs the Debian package glmark2-data"), std::string::npos);
  EXPECT_NE(page.find("Other"), std::string::npos);
}

TEST(Figures, TheGalleryShowsFailuresAndEscapesWords) {
  Figure figure{.id = "x", .paper = "A & B", .title = "<title>", .shows = "s", .caption = "c"};
  figure.checks = {at_most("a check", 3, 2)};
  const std::string page = gallery_page({description_of(figure)});
  EXPECT_NE(page.find("FAILS"), std::string::npos);
  EXPECT_NE(page.find("A &amp; B"), std::string::npos);
  EXPECT_NE(page.find("&lt;title&gt;"), std::string::npos);
  EXPECT_EQ(page.find("<title>\n"), std::string::npos);
}

}  // namespace
}  // namespace seesaw
