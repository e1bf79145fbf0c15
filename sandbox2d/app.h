// sandbox2d without its main(): a window in which one drags the constraints of an implicit curve.
//
//     Window window({.title = "Seesaw"});
//     App app(window, {.file = "figures/scenes/seesaw.json"});
//     while (!app.done()) {
//       for (const Input& input : window.begin_frame()) app.handle(input);
//       app.frame();
//       window.end_frame();
//     }
//
// It owns what a person sees and decides nothing about constraints: core/editing/desk.h does, and is tested
// without a window. A frame is: events to the desk; the scene's picture where something changed
// (scene_painter.h), what is in hand over it (overlay.h); plate and profile (plate.h, profile_chart.h); the
// panels around (menus.h, side_panel.h, tool_strip.h); dialogs over all.
//
// Before it: core/window/window.h, core/editing/desk.h. After it: main.cpp.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "core/editing/autosave.h"
#include "core/editing/background_solver.h"
#include "core/editing/desk.h"
#include "core/window/window.h"
#include "sandbox2d/export_files.h"
#include "sandbox2d/file_dialog.h"
#include "sandbox2d/gallery.h"
#include "sandbox2d/help_dialog.h"
#include "sandbox2d/layout.h"
#include "sandbox2d/menus.h"
#include "sandbox2d/message_boxes.h"
#include "sandbox2d/plate.h"
#include "sandbox2d/playback.h"
#include "sandbox2d/profile_chart.h"
#include "sandbox2d/scene_painter.h"
#include "sandbox2d/settings.h"
#include "sandbox2d/side_panel.h"
#include "sandbox2d/tour.h"
#include "sandbox2d/values_dialog.h"

namespace seesaw {

struct AppOptions {
  /// Opened at the start; a scene or a recorded session. Empty for the gallery's first scene.
  std::filesystem::path file = {};
  /// Where settings, recent files and autosaves are; empty for nowhere.
  std::filesystem::path state = {};
  /// Shown at the start. Otherwise as the settings have it.
  std::optional<bool> plate = {};
  /// The tour is offered to who has never seen it.
  bool offer_tour = true;
};

class App {
 public:
  App(Window& window, const AppOptions& options);
  ~App();
  App(const App&) = delete;
  App& operator=(const App&) = delete;

  void handle(const Input& input);
  /// Draws everything between Window::begin_frame and end_frame.
  void frame();
  /// The person wants to go, and nothing is unsaved or it may be lost.
  bool done() const { return done_; }
  /// Nothing is still to be drawn finer or solved.
  bool settled() const;

  Desk& desk() { return desk_; }
  const ScenePainter& painter() const { return painter_; }
  /// Where everything is, as of the last frame.
  const Layout& layout() const { return layout_; }
  const Shown& shown() const { return shown_; }
  const Tour& tour() const { return tour_; }
  const FileDialog& file_dialog() const { return files_; }
  /// A question waits for its answer.
  bool asks() const { return questions_.open(); }

 private:
  // app.cpp
  void place_everything();
  void resize_view();
  void draw_status();
  void look_after_settings();
  void look_after_autosave();
  /// Whether the view is the one that the document asks for.
  bool shows_as_saved() const;

  // app_pictures.cpp
  void draw_scene();
  void draw_plate();
  void draw_profile_chart();
  /// The document is changing under a hand.
  bool moving() const;
  bool scripted() const { return window_.clock().is_fixed(); }

  // app_commands.cpp
  void act(DeskCommand command);
  void act_on(std::optional<DeskCommand> command);
  void open(const std::filesystem::path& path);
  void ask_open();
  void ask_replay();
  void ask_save(std::function<void()> then = {});
  void save(std::function<void()> then = {});
  void ask_export();
  void ask_export_window();
  /// Of the frame in hand, once it is one to be exported.
  void export_window(bool dialog);
  FilePlaces places() const;
  void toggle_recording();
  void ask_save_recording(std::function<void()> then = {});
  /// Does `then` when no recording would be lost, or it may be.
  void when_recorded(std::function<void()> then);
  /// Does `then` when neither a recording nor anything unsaved would be lost, or they may be.
  void when_kept(std::function<void()> then);
  void show_entry(const GalleryEntry& entry);
  void tour_to(int step);
  void offer_recovered();
  void new_document_shown();

  Window& window_;
  BackgroundSolver<2> solver_, other_solver_;
  Desk desk_;
  ScenePainter painter_;
  Plate plate_;
  ProfileRange profile_range_;

  Layout layout_;
  Shown shown_;
  bool panels_ = true;
  SidePanel side_panel_;
  HelpDialog help_;
  ValuesDialog values_;
  GalleryDialog gallery_;
  FileDialog files_;
  Questions questions_;
  Tour tour_;
  Playback playback_;

  SettingsFile settings_;
  RecentFiles recent_;
  Autosave autosave_;
  std::filesystem::path autosave_folder_;
  std::vector<Recovered> recovered_;
  /// The copy that was recovered goes when its document is saved.
  std::optional<Recovered> discard_when_saved_;

  // What the scene's texture was made for, besides what events may have changed.
  struct SceneLook {
    std::uint64_t picture = 0;
    double scale = 0;
    bool dark = false, weights = false, pointer = false;
    bool operator==(const SceneLook&) const = default;
  };
  SceneLook look_;
  bool changed_ = true;
  Raster shown_raster_;
  Texture scene_texture_;
  Raster chart_raster_;
  Texture chart_texture_;

  std::optional<ProfileLine> profile_line_;
  // What the chart's texture was made for.
  struct ChartLook {
    std::uint64_t revision = 0;
    std::shared_ptr<const Interpolant<2>> function, other;
    ProfileLine line;
    double width = 0, height = 0, scale = 0, near = 0;
    bool dark = false, moving = false;
    bool operator==(const ChartLook&) const = default;
  };
  ChartLook chart_look_;

  bool line_to_be_seen_ = false;  // the profile line, in the view that its chart leaves
  bool pointer_in_scene_ = false, shift_ = false;
  std::uint64_t message_seen_ = 0;
  double message_since_ = -100;
  std::pair<std::uint64_t, Tool> message_of_;  // what the desk was like when it came
  /// The view as it was when all was shown, until a hand moves it.
  std::optional<View2D> shown_view_;
  std::string title_;
  double export_scale_ = 2;
  std::filesystem::path window_picture_;  // where the window is to be exported to, until it is
  bool tour_seen_ = false;
  bool done_ = false;
};

}  // namespace seesaw
