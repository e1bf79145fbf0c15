// The curve editor as main() runs it, in a window that nobody sees, with a hand that is written down.
//
//     SEESAW_WINDOW_OR_SKIP(window, app_window);
//     AppStage stage(window);
//     stage.play(stage.drag(stage.at(0), stage.at(0) + Point<2>(0.3, 0.1)));
//     stage.play("key ctrl+z");
//
// Places are in scene units; the script has them in the window's pixels, so a hand misses by up to half of
// one.
#pragma once

#include <gmock/gmock.h>

#include <limits>

#include "core/window/ui.h"
#include "sandbox2d/app.h"
#include "tests/core/editing/documents.h"
#include "tests/core/window/stage.h"
#include "tests/support/scratch_folder.h"

namespace seesaw {

inline const WindowOptions app_window = {.width = 1000, .height = 680};

class AppStage {
 public:
  explicit AppStage(Window& window, AppOptions options = {})
      : window_(window), app_(window, without_tour(std::move(options))) {
    play("frames 4");
  }

  /// To the script's end, and two frames more, in which what was done is seen.
  void play(const std::string& text) { play(parse_script(text + "\nframes 2\n", "test.script")); }
  void play(Script script) {
    window_.play(std::move(script));
    while (!window_.script_over()) {
      step();
      window_.end_frame();
    }
  }
  /// As play, until the scene is drawn as fine as it will be; what is then shown.
  Image picture() {
    for (int i = 0; i < 200 && (i < 2 || !app_.settled()); ++i) play("frames 1");
    EXPECT_TRUE(app_.settled());
    window_.play({});
    step();
    return window_.end_frame_with_picture();
  }

  App& app() { return app_; }
  Desk& desk() { return app_.desk(); }
  Window& window() { return window_; }
  const Document<2>& document() { return desk().document(); }
  std::size_t steps() { return desk().editor().undo_size(); }
  Point<2> at(Index constraint) { return desk().constraint(constraint).at; }
  double pixel() { return desk().view().pixel(); }
  /// f as it is shown; NaN where there is no function.
  double f(const Point<2>& at) {
    const auto& function = desk().shape().function;
    return function ? function->value(at) : std::numeric_limits<double>::quiet_NaN();
  }
  const Contour& curve() const { return app_.painter().picture().curve; }

  // Lines of a script.

  /// "X Y" in the window.
  std::string place(const Point<2>& in_scene) {
    const Point<2> p = desk().view().pixel_from_scene(in_scene);
    return std::to_string(app_.layout().scene.left() + p.x()) + " " +
           std::to_string(app_.layout().scene.top() + p.y());
  }
  std::string click(const Point<2>& at) { return "click " + place(at) + "\n"; }
  std::string drag(const Point<2>& from, const Point<2>& to, int steps = 6) {
    return "drag " + place(from) + " " + place(to) + " " + std::to_string(steps) + "\n";
  }

  /// Whether a dialog, a menu or a question was open in the last frame.
  bool dialog() const { return dialog_; }
  /// Whether a widget of that name, or "Panel/Name", is shown.
  bool has(const std::string& widget) {
    try {
      play("move \"" + widget + "\"");
      return true;
    } catch (const FileError&) {
      window_.play({});
      return false;
    }
  }

 private:
  static AppOptions without_tour(AppOptions options) {
    options.offer_tour = false;
    return options;
  }
  void step() {
    for (const Input& input : window_.begin_frame()) app_.handle(input);
    app_.frame();
    dialog_ = ui::any_dialog();
  }

  Window& window_;
  App app_;
  bool dialog_ = false;
};

/// Adds what is shown to a failure.
#define EXPECT_SAID(stage, words) EXPECT_THAT((stage).desk().message().text, ::testing::HasSubstr(words))

}  // namespace seesaw
