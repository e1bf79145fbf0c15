#include "core/window/ui.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

#include "core/image/canvas.h"
#include "core/window/texture.h"
#include "tests/core/window/stage.h"
#include "tests/support/scratch_folder.h"

namespace seesaw {
namespace {

/// A panel with one of everything, and what was done to it.
struct Board {
  int pressed = 0, undone = 0;
  bool ticked = false, switched = false;
  double value = 0, exact = 1;
  int whole = 3, chosen = 0;
  std::string words = "start";
  int began = 0, changed = 0, ended = 0;
  ui::PictureUse use;
  double dx = 0, dy = 0, wheel = 0;
  Texture texture;

  void count(const ui::Edit& edit) {
    began += edit.began;
    changed += edit.changed;
    ended += edit.ended;
  }
  void draw() {
    if (const auto bar = ui::menu_bar()) {
      if (const auto menu = ui::menu("File")) {
        if (ui::menu_item("Undo", "Ctrl+Z")) ++undone;
        ui::menu_switch("Dark", switched);
      }
    }
    if (const auto panel = ui::panel("Board", {10, 30, 300, 360})) {
      if (ui::button("Press me")) ++pressed;
      {
        const auto off = ui::disabled(true);
        if (ui::button("Not me")) pressed += 100;
      }
      ui::checkbox("Tick", ticked);
      count(ui::slider("Value", value, -1, 1));
      count(ui::slider("Whole", whole, 0, 10));
      count(ui::number("Exact", exact));
      count(ui::text_field("Words", words));
      count(ui::choice("Choice", chosen, {"Zero", "One", "Two"}));
      use = ui::picture("Plate", texture, 100, 60);
      dx += use.dx;
      dy += use.dy;
      wheel += use.wheel;
      ui::fact("Residual", "3e-13");
    }
  }
  Played play(Window& window, const std::string& text) {
    return seesaw::play(window, text, [this] { draw(); });
  }
};

#define SEESAW_BOARD_OR_SKIP(window, board)                                  \
  SEESAW_WINDOW_OR_SKIP(window, WindowOptions{.width = 480, .height = 400}); \
  Board board;                                                               \
  board.play(window, "frames 2")

TEST(Ui, AClickPressesTheButtonUnderIt) {
  SEESAW_BOARD_OR_SKIP(window, board);
  const Played played = board.play(window, "click \"Press me\"\nclick \"Board/Press me\" +3 -2\n");
  EXPECT_EQ(board.pressed, 2);
  for (const Input& input : played.inputs) EXPECT_TRUE(input.for_ui);
  board.play(window, "click \"Not me\"\nclick \"Tick\"\nclick 400 300\n");
  EXPECT_EQ(board.pressed, 2);
  EXPECT_TRUE(board.ticked);
}

TEST(Ui, AMenuOpensAndItsItemIsChosen) {
  SEESAW_BOARD_OR_SKIP(window, board);
  board.play(window, "click \"File\"\nframes 1\nclick \"Undo\"\nframes 2\n");
  EXPECT_EQ(board.undone, 1);
  board.play(window, "click \"File\"\nframes 1\nclick \"Dark\"\nframes 2\n");
  EXPECT_TRUE(board.switched);
}

// The knob follows the pointer: Dear ImGui's own SDL backend would ignore a scripted drag.
TEST(Ui, ASliderIsDraggedAndSaysWhenItBeganAndEnded) {
  SEESAW_BOARD_OR_SKIP(window, board);
  // The widget's place has its label; its middle is somewhat right of the slider's.
  board.play(window, "press left\nrelease left\ndrag \"Value\" -100 +0 \"Value\" +20 +0 8\n");
  EXPECT_GT(board.value, 0.1);
  EXPECT_LE(board.value, 1);
  EXPECT_EQ(board.began, 1);
  EXPECT_EQ(board.ended, 1);
  EXPECT_GE(board.changed, 6);
  const double before = board.value;
  board.play(window, "drag \"Value\" +20 +0 \"Value\" -1000 +0 8\n");
  EXPECT_LT(board.value, before);
  EXPECT_EQ(board.value, -1);
  EXPECT_EQ(board.ended, 2);
}

TEST(Ui, WordsAndNumbersAreTyped) {
  SEESAW_BOARD_OR_SKIP(window, board);
  board.play(window, "click \"Words\" -60 +0\nkey ctrl+a\ntext \"grün ≤ 3\"\n");
  EXPECT_EQ(board.words, "grün ≤ 3");
  const Played typing = board.play(window, "key ctrl+a\nkey ctrl+c\nkey end\nkey ctrl+v\nkey backspace\n");
  EXPECT_EQ(board.words, "grün ≤ 3grün ≤ ");
  EXPECT_EQ(window.clipboard(), "grün ≤ 3");
  for (const KeyPressed& key : typing.only<KeyPressed>()) EXPECT_FALSE(key.repeat);
  for (const Input& input : typing.inputs)
    EXPECT_EQ(input.for_ui, !std::holds_alternative<KeyReleased>(input.event));
  board.play(window, "key enter\nframes 1\n");
  // The caret has gone: keys are the program's again.
  const Played after = board.play(window, "key a\n");
  EXPECT_FALSE(after.inputs.at(0).for_ui);

  board.changed = board.ended = 0;
  board.play(window, "click \"Exact\" -60 +0\nkey ctrl+a\ntext \"-2.5e-3\"\n");
  EXPECT_EQ(board.exact, 1) << "half a number is none";
  EXPECT_EQ(board.changed, 0);
  board.play(window, "key enter\nframes 1\n");
  EXPECT_EQ(board.exact, -2.5e-3);
  EXPECT_EQ(board.changed, 1);
}

TEST(Ui, APanelMayAppearWhileADialogOpens) {
  SEESAW_WINDOW_OR_SKIP(window, WindowOptions{.width = 480, .height = 400});
  int pressed = 0;
  for (const int appears : {0, 1, 5}) {
    const std::string name = "Panel " + std::to_string(appears), title = "Dialog " + std::to_string(appears);
    int frame = 0;
    const auto draw = [&] {
      if (frame == 0) ui::open_dialog(title);
      if (const auto dialog = ui::dialog(title, 200)) {
        if (ui::main_button("Done")) ++pressed, ui::close_dialog();
      }
      if (frame++ >= appears)
        if (const auto panel = ui::panel(name, {0, 0, 480, 400}, {.title = false})) ui::text("here");
    };
    play(window, "frames 8\nclick \"Done\"\nframes 2\n", draw);
    EXPECT_EQ(pressed, 1) << "the dialog stays before it";
    pressed = 0;
  }
}

TEST(Ui, ANumberIsTakenHoweverItsFieldIsLeft) {
  SEESAW_BOARD_OR_SKIP(window, board);
  double expected = 2;
  // Fields before and after it, a button, nothing at all.
  for (const char* way : {"key enter", "key tab", "key shift+tab", "click \"Words\" -60 +0",
                          "click \"Value\" -60 +0", "click \"Press me\"", "click 400 380"}) {
    board.exact = 1;
    board.changed = 0;
    board.play(window, "click \"Exact\" -60 +0\nkey ctrl+a\ntext \"" + std::to_string(++expected) + "\"\n" +
                           way + "\nframes 2\nclick 400 380\nframes 2\n");
    EXPECT_EQ(board.exact, expected) << way;
  }
  board.exact = 1;
  board.play(
      window,
      "click \"Exact\" -60 +0\nkey ctrl+a\ntext \"7\"\nkey escape\nframes 2\nclick 400 380\nframes 2\n");
  EXPECT_EQ(board.exact, 1) << "Escape takes it back";
}

TEST(Ui, AChoiceIsChosen) {
  SEESAW_BOARD_OR_SKIP(window, board);
  board.play(window, "click \"Choice\"\nframes 1\nclick \"Two\"\nframes 1\n");
  EXPECT_EQ(board.chosen, 2);
  EXPECT_EQ(board.changed, 1);
}

TEST(Ui, APictureIsDraggedAndTurnedByTheWheel) {
  SEESAW_BOARD_OR_SKIP(window, board);
  board.play(window, "drag \"Plate\" \"Plate\" +200 -30 5 right\nmove \"Plate\" -10 -5\nwheel 0 2\n");
  EXPECT_EQ(board.dx, 200);
  EXPECT_EQ(board.dy, -30);
  EXPECT_EQ(board.wheel, 2);
  EXPECT_TRUE(board.use.hovered);
  EXPECT_FALSE(board.use.held);
  EXPECT_EQ(board.use.x, 40);
  EXPECT_EQ(board.use.y, 25);
}

// From a menu to a dialog, into its field, and out by each of its doors.
TEST(Ui, ADialogIsOpenedByAMenuAndClosedByEnterEscapeOrItsButtons) {
  SEESAW_WINDOW_OR_SKIP(window, WindowOptions{.width = 480, .height = 400});
  int saved = 0, below = 0;
  bool open = false;
  std::string name;
  const auto draw = [&] {
    if (const auto bar = ui::menu_bar())
      if (const auto menu = ui::menu("File"))
        if (ui::menu_item("Save as ...")) ui::open_dialog("Save");
    if (const auto panel = ui::panel("P", {0, 40, 480, 360}))
      if (ui::main_button("Below", 400)) ++below;
    open = false;
    if (const auto dialog = ui::dialog("Save", 300)) {
      open = true;
      ui::text_field("Name", name);
      if (ui::main_button("Save")) {
        ++saved;
        ui::close_dialog();
      }
      ui::same_line();
      if (ui::button("Cancel")) ui::close_dialog();
    }
  };
  const std::string open_it = "frames 1\nclick \"File\"\nframes 1\nclick \"Save as ...\"\nframes 3\n";
  play(window, open_it + "click \"Name\" -60 +0\ntext \"torus\"\nframes 1\n", draw);
  EXPECT_TRUE(open);
  const Played blocked = play(window, "click \"Below\"\nmove 470 390\npress\nrelease\n", draw);
  for (const Input& input : blocked.inputs) EXPECT_TRUE(input.for_ui);
  EXPECT_EQ(below, 0);
  play(window, "click \"Name\" -60 +0\nkey end\ntext \".json\"\nkey enter\nframes 2\n", draw);
  EXPECT_EQ(name, "torus.json");
  EXPECT_EQ(saved, 1);
  EXPECT_FALSE(open);
  for (const char* way : {"key escape\nframes 2\n", "click \"Cancel\"\nframes 2\n"}) {
    play(window, open_it, draw);
    EXPECT_TRUE(open);
    play(window, way, draw);
    EXPECT_FALSE(open) << way;
  }
  play(window, open_it + "click \"Save/Save\"\nframes 2\nkey enter\n", draw);
  EXPECT_EQ(saved, 2);
  EXPECT_FALSE(open);
  EXPECT_EQ(below, 0) << "Enter is for dialogs";
}

TEST(Ui, ANumberIsSteppedByItsButtons) {
  SEESAW_WINDOW_OR_SKIP(window);
  double value = 1;
  int changed = 0;
  const auto draw = [&] {
    if (const auto panel = ui::panel("P", {0, 0, 320, 200})) {
      const auto width = ui::item_width(150);
      if (ui::number("n", value, 0.25)) ++changed;
    }
  };
  // The plus button ends 150 pixels from the left, the label is some ten pixels more.
  play(window, "frames 2\nclick \"n\" +56 +0\nframes 1\nclick \"n\" +56 +0\nframes 2\n", draw);
  EXPECT_EQ(value, 1.5);
  EXPECT_EQ(changed, 2);
}

// Whoever got the press gets the drag, wherever it leads.
TEST(Ui, ADragBelongsToWhoeverGotItsPress) {
  SEESAW_BOARD_OR_SKIP(window, board);
  const Played canvas = board.play(window, "move 400 300\ndrag 400 300 \"Press me\" 5\n");
  EXPECT_EQ(board.pressed, 0);
  for (const Input& input : canvas.inputs) EXPECT_FALSE(input.for_ui);
  const Played panel = board.play(window, "frames 1\ndrag \"Press me\" 400 300 5\n");
  EXPECT_EQ(board.pressed, 0);
  for (const Input& input : panel.inputs) EXPECT_TRUE(input.for_ui);
  EXPECT_FALSE(board.play(window, "move 401 300\n").inputs.at(0).for_ui);
}

TEST(Ui, TheScaleMakesLettersLargerAtOnce) {
  SEESAW_WINDOW_OR_SKIP(window);
  double width = 0, height = 0;
  const auto draw = [&] {
    if (const auto panel = ui::panel("P", {0, 0, 320, 200})) {
      width = ui::text_width("Interior value ∇f ≤ ½ σ");
      height = ui::line_height();
      ui::text("Interior value ∇f ≤ ½ σ");
    }
  };
  play(window, "frames 2", draw);
  const double width_1 = width, height_1 = height;
  window.set_scale(2);
  const Image at_2 = play(window, "frames 1", draw).picture;
  EXPECT_EQ(window.scale(), 2);
  EXPECT_NEAR(width / width_1, 2, 0.05);
  EXPECT_NEAR(height / height_1, 2, 0.05);
  window.set_scale(1);
  EXPECT_NE(play(window, "frames 1", draw).picture, at_2);
  EXPECT_EQ(width, width_1);
  window.set_scale(100);
  EXPECT_EQ(window.scale(), 4);
  window.set_scale(-1);
  EXPECT_EQ(window.scale(), 0.5);
}

double lightness(const Color& color) { return lab_of(color).L; }

TEST(Ui, LightAndDarkAreLegible) {
  for (const bool dark : {false, true}) {
    const UiColors c = ui_colors(dark);
    EXPECT_EQ(lightness(c.background) < 50, dark);
    for (const Color& ground : {c.background, c.panel, c.field}) {
      EXPECT_GT(std::abs(lightness(c.ink) - lightness(ground)), 65);
      EXPECT_GT(std::abs(lightness(c.soft_ink) - lightness(ground)), 38);
      EXPECT_GT(delta_e(lab_of(c.accent), lab_of(ground)), 35);
    }
  }
  SEESAW_BOARD_OR_SKIP(window, board);
  window.set_dark(true);
  const Image picture = board.play(window, "frames 1").picture;
  EXPECT_EQ(picture.at(470, 390), ui_colors(true).background);
  EXPECT_EQ(picture.at(300, 385), ui_colors(true).panel);
}

// What a program looks like: a canvas behind, panels over it. SEESAW_KEEP=1 leaves the picture.
TEST(Ui, ACanvasAndPanelsTogether) {
  SEESAW_WINDOW_OR_SKIP(window, WindowOptions{.width = 640, .height = 400, .scale = 1.2});
  Canvas canvas(640, 400);
  for (int i = 0; i < 8; ++i)
    canvas.circle({480, 210}, 15.0 * (i + 1), {.color = theme::series_color(0), .width = 2});
  canvas.text({480, 215}, "f = 0", {.size = 14, .align = Align::center});
  Texture texture;
  texture.upload(canvas.image(1));
  Board board;
  const ScratchFolder folder;
  const auto path = folder / "panels.png";
  const Played played = play(
      window,
      "frames 2\nclick \"File\"\nframes 1\nmove \"Undo\"\nframes 2\nscreenshot \"" + path.string() + "\"",
      [&] {
        ui::background(texture, {0, 0, 640, 400});
        board.draw();
      });
  EXPECT_TRUE(std::filesystem::exists(path));
  // The canvas is there to the bit, right of the panel.
  const Image drawn = canvas.image(1);
  for (int x = 400; x < 640; ++x) EXPECT_EQ(played.picture.at(x, 215), drawn.at(x, 215));
}

TEST(Ui, TheSameScriptGivesTheSamePicture) {
  Image first;
  for (int run = 0; run < 2; ++run) {
    SEESAW_WINDOW_OR_SKIP(window, WindowOptions{.width = 480, .height = 400, .scale = 1.25});
    Board board;
    const Image picture =
        board.play(window, "frames 2\nclick \"Words\" -60 +0\ntext \"abc\"\nframes 40\n").picture;
    if (run == 0)
      first = picture;
    else
      EXPECT_EQ(picture, first);
  }
}

}  // namespace
}  // namespace seesaw
