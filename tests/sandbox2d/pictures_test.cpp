// What the program shows at the end of each script in tests/sandbox2d/scripts, against
// tests/sandbox2d/reference.
//
// Not byte for byte: other versions of FreeType and Cairo draw letters and lines a little differently, other
// versions of Mesa the rims of triangles, and other processors round the last digit. The bound is that of the
// figures (core/image/compare.h): a symbol, word or line that is missing exceeds it, a shift of a fraction of
// a pixel does not. Numbers that are rounding itself (residuals) are folded away by the scripts.
//
// After a change that is meant: SEESAW_UPDATE_REFERENCES=1 build/release/bin/test_sandbox2d
// --gtest_filter='*Pictures*', and look at every one. One by hand: sandbox2d --size 1280x800 --script
// X.script --screenshot X.png
#include <cstdlib>

#include "core/image/compare.h"
#include "core/image/png.h"
#include "tests/sandbox2d/app_stage.h"
#include "tests/support/scratch_folder.h"

namespace seesaw {
namespace {

const std::filesystem::path pictures_home = std::filesystem::path(SEESAW_SOURCE_DIR) / "tests/sandbox2d";

class AppPictures : public ::testing::TestWithParam<const char*> {};

TEST_P(AppPictures, AreThoseOfTheReference) {
  const std::string name = GetParam();
  SEESAW_WINDOW_OR_SKIP(window, WindowOptions{.width = 1280, .height = 800});
  AppStage stage(window);
  stage.play(read_script(pictures_home / "scripts" / (name + ".script")));
  const Image picture = stage.picture();
  const std::filesystem::path file = pictures_home / "reference" / (name + ".png");
  if (std::getenv("SEESAW_UPDATE_REFERENCES")) return write_png(file, picture);
  const Image reference = read_png(file);
  const Comparison comparison = compare_images(picture, reference);
  const bool alike = comparison.same_size && comparison.worst < 18 && comparison.mean < 0.5;
  EXPECT_TRUE(alike) << "worst " << comparison.worst << ", mean " << comparison.mean << ", noticeable "
                     << comparison.noticeable;
  if (alike) return;
  const auto shown = picture_to_look_at("sandbox2d-" + name + "-difference.png");
  write_png(shown, difference_picture(picture, reference));
  ADD_FAILURE() << "ours, reference and difference: " << shown;
}

INSTANTIATE_TEST_SUITE_P(Scripts, AppPictures,
                         ::testing::Values("figure", "seesaw", "weights", "contradiction", "dark", "gallery",
                                           "tour"),
                         [](const auto& name) { return std::string(name.param); });

// The bound is worth something: one constraint less is seen.
TEST(AppPicturesBound, OneMarkLessIsSeen) {
  SEESAW_WINDOW_OR_SKIP(window, WindowOptions{.width = 1280, .height = 800});
  AppStage stage(window);
  const Image with = stage.picture();
  EXPECT_EQ(compare_images(with, stage.picture()).worst, 0);
  stage.play("key 6");  // the scale bar
  EXPECT_GT(compare_images(with, stage.picture()).worst, 18);
}

}  // namespace
}  // namespace seesaw
