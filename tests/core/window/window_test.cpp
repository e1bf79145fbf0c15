#include "core/window/window.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <thread>

#include "core/image/png.h"
#include "core/window/texture.h"
#include "core/window/ui.h"
#include "tests/core/window/stage.h"
#include "tests/support/scratch_folder.h"

namespace seesaw {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<Point<2>> positions(const std::vector<MouseMoved>& moves) {
  std::vector<Point<2>> result;
  for (const MouseMoved& move : moves) result.push_back(move.at);
  return result;
}

Image patterned(int width, int height) {
  Image image(width, height);
  unsigned state = 7;
  for (std::size_t i = 0; i < image.bytes().size(); ++i)
    image.bytes()[i] =
        i % 4 == 3 ? 255 : static_cast<std::uint8_t>((state = state * 1664525u + 1013904223u) >> 24);
  return image;
}

TEST(Window, IsOpenGL33CoreAndSaysSo) {
  SEESAW_WINDOW_OR_SKIP(window);
  EXPECT_GE(window.opengl_version(), 33);
  EXPECT_THAT(window.description(), HasSubstr("OpenGL "));
  EXPECT_THAT(window.description(), HasSubstr(", core profile"));
  EXPECT_THAT(window.description(), HasSubstr(window.driver()));
  EXPECT_EQ(window.width(), 320);
  EXPECT_EQ(window.pixel_ratio(), 1);
}

TEST(Window, ForAPersonRefusesToBeNowhere) {
  if (std::getenv("DISPLAY") || std::getenv("WAYLAND_DISPLAY") || std::getenv("SDL_VIDEODRIVER"))
    GTEST_SKIP() << "there is a screen";
  try {
    const Window window;
    // A console's own graphics may be a screen, too.
    EXPECT_THAT(window.driver(), ::testing::Not(HasSubstr("offscreen")));
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("there is no screen to open a window on"));
    EXPECT_THAT(error.what(), HasSubstr("DISPLAY"));
  }
}

TEST(Window, ShowsATextureByteForByte) {
  SEESAW_WINDOW_OR_SKIP(window);
  const Image image = patterned(100, 60);
  Texture texture, swapped;
  texture.upload(image);
  // The same pixels as Cairo has them, with rows that are longer than the picture is wide.
  std::vector<std::uint8_t> bgra(4 * 128 * 60);
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 100; ++x)
      for (int c = 0; c < 4; ++c)
        bgra[static_cast<std::size_t>(4 * (128 * y + x) + c)] = image.pixel(x, y)[c == 3 ? 3 : 2 - c];
  swapped.upload({bgra.data(), 100, 60, 4 * 128, PixelOrder::bgra});
  const Image picture = play(window, "frames 1", [&] {
                          ui::background(texture, {20, 30, 100, 60});
                          ui::background(swapped, {160, 30, 100, 60});
                          ui::background(Texture(), {0, 0, 320, 200});
                        }).picture;
  int wrong = 0;
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 100; ++x)
      for (int c = 0; c < 4; ++c) {
        wrong += picture.pixel(20 + x, 30 + y)[c] != image.pixel(x, y)[c];
        wrong += picture.pixel(160 + x, 30 + y)[c] != image.pixel(x, y)[c];
      }
  EXPECT_EQ(wrong, 0);
  const UiColors colors = window.colors();
  for (const auto& [x, y] : {std::pair(19, 30), {120, 89}, {20, 29}, {119, 90}, {0, 0}, {319, 199}})
    EXPECT_EQ(picture.at(x, y), colors.background) << x << ' ' << y;
}

TEST(Window, ATextureIsReplacedResizedAndEmptied) {
  SEESAW_WINDOW_OR_SKIP(window);
  Texture texture;
  EXPECT_TRUE(texture.empty());
  texture.upload(patterned(10, 10));
  const Image larger = patterned(33, 7);
  texture.upload(larger);
  const Texture moved = std::move(texture);
  const Image picture = play(window, "frames 1", [&] { ui::background(moved, {0, 0, 33, 7}); }).picture;
  EXPECT_EQ(picture.at(32, 6), larger.at(32, 6));
  Texture emptied;
  emptied.upload(larger);
  emptied.upload(Image());
  EXPECT_TRUE(emptied.empty());
  EXPECT_THROW(emptied.reserve(1 << 30, 1, false), Error);
}

TEST(Window, GrowsAndShrinksWithoutAScreen) {
  SEESAW_WINDOW_OR_SKIP(window);
  const Played played = play(window, "size 500 410\nframes 1");
  EXPECT_EQ(played.picture.width(), 500);
  EXPECT_EQ(played.picture.height(), 410);
  EXPECT_EQ(played.picture.at(499, 0), window.colors().background);
  EXPECT_EQ(played.picture.at(0, 409), window.colors().background);
  const auto resized = played.only<WindowResized>();
  ASSERT_FALSE(resized.empty());
  EXPECT_EQ(resized.back().width, 500);
  EXPECT_EQ(resized.back().height, 410);
  window.set_size(330, 220);
  EXPECT_EQ(play(window, "frames 2").picture.width(), 330);
}

TEST(Window, AScriptsHandMovesPressesAndDrags) {
  SEESAW_WINDOW_OR_SKIP(window);
  const Played played = play(window, "drag 10 20 50 40 4 right\nwheel 1 -2\nclick 5 6\n");
  EXPECT_THAT(positions(played.only<MouseMoved>()),
              ElementsAre(Point<2>(10, 20), Point<2>(20, 25), Point<2>(30, 30), Point<2>(40, 35),
                          Point<2>(50, 40), Point<2>(5, 6)));
  const auto pressed = played.only<MousePressed>();
  ASSERT_EQ(pressed.size(), 2u);
  EXPECT_EQ(pressed[0].button, MouseButton::right);
  EXPECT_EQ(pressed[0].at, Point<2>(10, 20));
  EXPECT_EQ(pressed[1].button, MouseButton::left);
  const auto released = played.only<MouseReleased>();
  ASSERT_EQ(released.size(), 2u);
  EXPECT_EQ(released[0].at, Point<2>(50, 40));
  const auto wheel = played.only<WheelMoved>();
  ASSERT_EQ(wheel.size(), 1u);
  EXPECT_EQ(wheel[0].at, Point<2>(50, 40));
  EXPECT_EQ(wheel[0].right, 1);
  EXPECT_EQ(wheel[0].up, -2);
  for (const Input& input : played.inputs) EXPECT_FALSE(input.for_ui);
  // A move, a press and a release are three frames; so is the drag's end.
  EXPECT_EQ(played.frames, 1 + 1 + 4 + 1 + 1 + 3);
}

TEST(Window, EveryKeyComesBackAsItWasPressed) {
  SEESAW_WINDOW_OR_SKIP(window);
  std::string text;
  std::vector<Key> wanted;
  for (int i = 0; i < key_count; ++i) {
    wanted.push_back(static_cast<Key>(i));
    text += "keydown " + std::string(name_of(wanted.back())) + "\nkeyup " +
            std::string(name_of(wanted.back())) + "\n";
  }
  const Played played = play(window, text);
  std::vector<Key> pressed, released;
  for (const KeyPressed& event : played.only<KeyPressed>()) pressed.push_back(event.key);
  for (const KeyReleased& event : played.only<KeyReleased>()) released.push_back(event.key);
  EXPECT_EQ(pressed, wanted);
  EXPECT_EQ(released, wanted);
}

TEST(Window, ModifiersAreHeldWithKeysAndPointer) {
  SEESAW_WINDOW_OR_SKIP(window);
  const Played played =
      play(window, "key ctrl+shift+z\nkeydown shift\nmove 3 4\nkey f1\nkeyup shift\nmove 5 6\n");
  const auto keys = played.only<KeyPressed>();
  ASSERT_EQ(keys.size(), 5u);
  EXPECT_EQ(keys[0].key, Key::ctrl);
  EXPECT_EQ(keys[1].key, Key::shift);
  EXPECT_TRUE(keys[2].is(*chord_named("ctrl+shift+z")));
  EXPECT_FALSE(keys[2].is(*chord_named("ctrl+z")));
  EXPECT_EQ(keys[4].key, Key::f1);
  EXPECT_EQ(keys[4].modifiers, (Modifiers{.shift = true}));
  const auto moves = played.only<MouseMoved>();
  ASSERT_EQ(moves.size(), 2u);
  EXPECT_EQ(moves[0].modifiers, (Modifiers{.shift = true}));
  EXPECT_EQ(moves[1].modifiers, Modifiers{});
}

TEST(Window, TextDropsAndTheClosingButtonArrive) {
  SEESAW_WINDOW_OR_SKIP(window);
  const std::string words = "r² log r — ein Größenvergleich über mehr als einunddreißig Bytes: ∇f·n ≤ 0";
  const Played played = play(window, "text \"" + words + "\"\ndrop \"a file.json\"\nquit\n");
  std::string typed;
  for (const TextTyped& event : played.only<TextTyped>()) typed += event.text;
  EXPECT_EQ(typed, words);
  const auto dropped = played.only<FileDropped>();
  ASSERT_EQ(dropped.size(), 1u);
  EXPECT_EQ(dropped[0].path, std::filesystem::path(::testing::TempDir()) / "a file.json");
  EXPECT_EQ(played.only<CloseAsked>().size(), 1u);
}

TEST(Window, TimeGoesByFrames) {
  SEESAW_WINDOW_OR_SKIP(window);
  play(window, "frames 33");
  EXPECT_EQ(window.clock().frames(), 33);
  EXPECT_EQ(window.clock().time(), 0.5);
  EXPECT_EQ(window.clock().step(), 1.0 / 64);
}

TEST(Window, AnotherThreadEndsAWait) {
  SEESAW_WINDOW_OR_SKIP(window);
  window.begin_frame();
  window.end_frame();
  std::thread([&] { window.wake(); }).join();
  EXPECT_TRUE(std::holds_alternative<Woken>(window.begin_frame().at(0).event));
  window.end_frame();
}

TEST(Window, TheClipboardIsTheSystems) {
  SEESAW_WINDOW_OR_SKIP(window);
  window.set_clipboard("{\"seesaw\": 1} ≤");
  EXPECT_EQ(window.clipboard(), "{\"seesaw\": 1} ≤");
}

TEST(Window, AScreenshotIsTheFrameThatWasShown) {
  SEESAW_WINDOW_OR_SKIP(window);
  const ScratchFolder folder;
  const auto path = folder / "made by it" / "shot.png";
  Texture texture;
  texture.upload(patterned(320, 200));
  const Played played = play(window, "screenshot \"" + path.string() + "\"", [&] {
    ui::background(texture, {0, 0, 320, 200});
  });
  EXPECT_EQ(read_png(path), played.picture);
  EXPECT_EQ(played.picture, patterned(320, 200));
}

TEST(Window, AScriptThatCannotBeDoneNamesItsLine) {
  SEESAW_WINDOW_OR_SKIP(window);
  const auto draw = [] {
    if (const auto panel = ui::panel("Tools", {10, 10, 200, 100})) {
      ui::button("Undo");
      ui::button("Redo##2");
    }
  };
  try {
    play(window, "frames 2\nclick \"Undo\"\nclick \"Save\"\n", draw);
    FAIL() << "not refused";
  } catch (const FileError& error) {
    EXPECT_THAT(
        error.what(),
        HasSubstr("test.script:3: there is nothing called \"Save\" in the window; there is Undo, Redo"));
  }
  // The window lives on.
  EXPECT_EQ(play(window, "click \"Undo\"", draw).only<MousePressed>().size(), 1u);
}

}  // namespace
}  // namespace seesaw
