// Windows of all sizes, letters of all sizes, light and dark: everything stays in its place and in reach.
#include "tests/sandbox2d/app_stage.h"

namespace seesaw {
namespace {

// All that is shown is within the window, and nothing lies on anything else.
void expect_in_place(AppStage& stage) {
  const Layout& layout = stage.app().layout();
  const double width = stage.window().width(), height = stage.window().height();
  std::vector<Rect> shown = {layout.scene, layout.status};
  for (const Rect& each : {layout.tools, layout.plate, layout.profile, layout.side})
    if (each.width > 0) shown.push_back(each);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const Rect& a = shown[i];
    EXPECT_GE(a.left(), 0);
    EXPECT_GE(a.top(), 0);
    EXPECT_LE(a.right(), width + 1e-9);
    EXPECT_LE(a.bottom(), height + 1e-9);
    for (std::size_t j = 0; j < i; ++j) {
      const Rect& b = shown[j];
      const bool apart = a.right() <= b.left() + 1e-9 || b.right() <= a.left() + 1e-9 ||
                         a.bottom() <= b.top() + 1e-9 || b.bottom() <= a.top() + 1e-9;
      EXPECT_TRUE(apart) << i << " over " << j;
    }
  }
  EXPECT_GE(layout.scene.width, 0.2 * width - 1) << "the scene is never crowded out";
  EXPECT_EQ(stage.desk().view().width(), layout.scene.width);
  EXPECT_EQ(stage.desk().view().height(), layout.scene.height);
}

// A drag in the scene moves the constraint by as much as the hand.
void expect_draggable(AppStage& stage) {
  stage.play("key f");
  const Point<2> from = stage.at(0);
  const Point<2> by = stage.window().scale() * stage.pixel() * Point<2>(12, 8);
  stage.play(stage.drag(from, from + by, 3));
  EXPECT_LT((stage.at(0) - from - by).norm(), 2 * stage.pixel());
  stage.play("key ctrl+z");
  EXPECT_EQ(stage.at(0), from);
}

struct Look {
  int width, height;
  double scale;
  bool dark;
};

class AppLooks : public ::testing::TestWithParam<Look> {};

TEST_P(AppLooks, EverythingStaysInPlaceAndInReach) {
  const Look look = GetParam();
  SEESAW_WINDOW_OR_SKIP(
      window,
      WindowOptions{.width = look.width, .height = look.height, .scale = look.scale, .dark = look.dark});
  AppStage stage(window);
  expect_in_place(stage);
  expect_draggable(stage);
  stage.play("key t\nkey shift+p\nkey w\nkey 3\nframes 2");
  expect_in_place(stage);
  expect_draggable(stage);
  for (const char* key : {"f1", "f2", "ctrl+o", "ctrl+s", "ctrl+shift+e"}) {
    stage.play(std::string("key ") + key + "\nframes 2");
    EXPECT_TRUE(stage.dialog()) << key;
    stage.play("key escape\nframes 1");
    EXPECT_FALSE(stage.dialog()) << key;
  }
  // The gradient would be unsaved.
  stage.play("key 3\nkey f3\nframes 2");
  EXPECT_TRUE(stage.app().tour().running());
  expect_in_place(stage);
  const Image picture = stage.picture();
  EXPECT_EQ(picture.width(), look.width);
  EXPECT_EQ(picture.height(), look.height);
}

INSTANTIATE_TEST_SUITE_P(Sizes, AppLooks,
                         ::testing::Values(Look{320, 240, 1, false}, Look{320, 240, 4, false},
                                           Look{640, 480, 2, true}, Look{1280, 800, 0.5, false},
                                           Look{1280, 800, 4, true}, Look{1600, 900, 1.5, true}),
                         [](const auto& each) {
                           const Look& look = each.param;
                           return std::to_string(look.width) + "x" + std::to_string(look.height) + "_at_" +
                                  std::to_string(std::lround(100 * look.scale)) + (look.dark ? "_dark" : "");
                         });

TEST(AppLooksAtWill, TheWindowIsResizedWhileItIsUsed) {
  SEESAW_WINDOW_OR_SKIP(window, app_window);
  AppStage stage(window);
  const std::string document = bits_of(stage.document());
  for (const char* size : {"320 240", "1600 300", "300 900", "1280 800", "1 1", "1000 680"}) {
    SCOPED_TRACE(size);
    stage.play(std::string("size ") + size + "\nframes 2");
    if (window.width() >= 300) expect_in_place(stage);
  }
  expect_draggable(stage);
  EXPECT_EQ(bits_of(stage.document()), document);
  // In the middle of a drag.
  const Point<2> from = stage.at(0);
  stage.play("move " + stage.place(from) + "\npress\nmove " + stage.place(from * 1.1) +
             "\nsize 800 600\nmove " + "400 300\nrelease");
  EXPECT_EQ(stage.desk().gesture(), Gesture::none);
  EXPECT_EQ(stage.steps(), 1u);
  EXPECT_TRUE(stage.at(0).allFinite());
}

// Light and dark show the same scene: what is light in one is dark in the other.
TEST(AppLooksAtWill, DarkIsTheNegativeOfLight) {
  SEESAW_WINDOW_OR_SKIP(window, app_window);
  AppStage stage(window);
  const auto brightness = [&](const Image& image) {
    const Rect& scene = stage.app().layout().scene;
    double sum = 0, count = 0;
    for (int y = static_cast<int>(scene.top()); y < scene.bottom(); y += 3)
      for (int x = static_cast<int>(scene.left()); x < scene.right(); x += 3, ++count)
        sum += image.pixel(x, y)[1] / 255.0;
    return sum / count;
  };
  const double light = brightness(stage.picture());
  stage.play("key f10");
  const double dark = brightness(stage.picture());
  EXPECT_GT(light, 0.6);
  EXPECT_LT(dark, 0.45);
}

}  // namespace
}  // namespace seesaw
