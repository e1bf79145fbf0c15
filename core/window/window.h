// A window with panels: SDL2, OpenGL 3.3 and Dear ImGui, started, fed and stopped in one place.
//
//     Window window({.title = "sandbox2d"});
//     if (!script.empty()) window.play(read_script(script));
//     while (!app.done() && !window.script_over()) {
//       for (const Input& input : window.begin_frame()) app.handle(input);
//       app.frame();         // canvases into textures, panels by core/window/ui.h
//       window.end_frame();
//     }
//
// Events come twice: first the panels see a frame's events, then the program does, each marked with whose it
// is (core/window/input.h). While nothing happens begin_frame sleeps, so an open window costs nothing.
//
// SDL falls back in silence to a driver without a screen where there is none. For a person that would be a
// program that runs and is nowhere, so a Window for a person refuses it in words. Scripts and tests ask for
// it: Screen::none draws into a picture of OpenGL's (the same pixels), which can be of any size and changes
// it like a window; SDL's own picture would keep its first size.
//
// One Window at a time, on the thread that made it.
//
// Before it: nothing. After it: core/window/ui.h for panels, texture.h for canvases, view_3d.h for meshes.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/image/image.h"
#include "core/window/frame_clock.h"
#include "core/window/input.h"
#include "core/window/script.h"
#include "core/window/ui_style.h"

namespace seesaw {

/// `real`: a person's, refused where there is none. `none`: no screen is needed; the driver that the
/// environment variable SDL_VIDEODRIVER names is used all the same, so a script can be watched.
enum class Screen { real, none };

struct WindowOptions {
  std::string title = "Seesaw";
  int width = 1280, height = 800;  ///< logical pixels
  double scale = 1;                ///< of letters and panels, 0.5 to 4: about 2 for a hall
  bool dark = false;
  Screen screen = Screen::real;
  bool visible = true;
  bool vsync = true;  ///< frames wait for the screen
  int samples = 0;    ///< a pixel, for smooth edges of what OpenGL draws; ten times slower without a card
  /// Seconds a frame whatever the time, for the same pictures in every run; nothing for real time.
  std::optional<double> fixed_step = {};
};

class Window {
 public:
  /// Throws Error, with what to do, where there is no screen or no OpenGL 3.3.
  explicit Window(const WindowOptions& options = {});
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  // The loop.

  /// Waits for something to do, then begins a frame and returns its events, valid until the next. Throws
  /// FileError where a script's next command cannot be done.
  const std::vector<Input>& begin_frame();
  /// Draws the panels over the background and shows the frame. Throws FileError where a screenshot cannot be
  /// written.
  void end_frame();
  /// As end_frame, and returns what is shown, in real pixels.
  Image end_frame_with_picture();
  /// As end_frame_with_picture, for who does not end the frame: `use` has the picture at this frame's end.
  void hand_over(std::function<void(const Image&)> use);
  /// The next begin_frame does not wait: something is moving.
  void stay_awake();
  /// Ends a wait; from any thread. The frame then has a Woken.
  void wake();
  const FrameClock& clock() const;

  // Scripts.

  /// From the next frame on the script's commands are done, one after another.
  void play(Script script);
  /// Whether a script was played and is at its end. A program then ends, or plays the next.
  bool script_over() const;

  // Looks.

  int width() const;   ///< logical pixels, the unit of events and panels
  int height() const;  ///< likewise
  /// Real pixels of a logical one; 1 except on dense screens.
  double pixel_ratio() const;
  void set_size(int width, int height);
  void set_title(const std::string& title);
  void set_full_screen(bool on);
  bool full_screen() const;
  /// Of letters and panels; from the next frame on. Clamped to 0.5 .. 4.
  void set_scale(double scale);
  double scale() const;
  void set_dark(bool dark);
  bool dark() const;
  UiColors colors() const { return ui_colors(dark()); }

  // The system.

  /// The clipboard's text; empty where it has none.
  std::string clipboard() const;
  void set_clipboard(const std::string& text);
  /// 33 for OpenGL 3.3, which is the least.
  int opengl_version() const;
  /// "OpenGL 4.5 (llvmpipe ...), SDL driver x11": for an about box.
  std::string description() const;
  /// SDL's name for what shows the window: "x11", "wayland", "offscreen".
  std::string driver() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace seesaw
