#include "core/window/sdl_window.h"

#include <SDL.h>
#include <epoxy/gl.h>

#include <clocale>
#include <cstdlib>
#include <cstring>

#include "core/base/error.h"
#include "core/window/readback.h"

namespace seesaw::detail {

namespace {

bool is_screenless(const char* driver) {
  return !driver || std::strcmp(driver, "offscreen") == 0 || std::strcmp(driver, "dummy") == 0 ||
         std::strcmp(driver, "evdev") == 0;
}

// Signals stay the program's: Ctrl+C in a terminal ends it.
void start_video(Screen screen) {
  // X11 asks the locale which letters there are. In that of a program's start, "C", it takes no title with
  // others than ASCII, and keeps the old one without a word. Letters alone: numbers keep their decimal point.
  if (std::strcmp(std::setlocale(LC_CTYPE, nullptr), "C") == 0) std::setlocale(LC_CTYPE, "C.UTF-8");
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
  SDL_SetHint(SDL_HINT_MOUSE_FOCUS_CLICKTHROUGH, "1");
  SDL_SetHint(SDL_HINT_VIDEO_ALLOW_SCREENSAVER, "1");
  const char* const asked = std::getenv("SDL_VIDEODRIVER");
  const bool was_asked = asked && *asked;
  // Null for a window after one without a screen.
  SDL_SetHint(SDL_HINT_VIDEODRIVER, screen == Screen::none && !was_asked ? "offscreen" : nullptr);
  if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0)
    throw Error(std::string("SDL cannot open a window") +
                (was_asked ? std::string(" by its driver \"") + asked + '"' : "") + ": " + SDL_GetError());
  if (screen == Screen::real && !was_asked && is_screenless(SDL_GetCurrentVideoDriver())) {
    SDL_QuitSubSystem(SDL_INIT_VIDEO);
    throw Error(
        "there is no screen to open a window on: start it in a graphical session, set DISPLAY or "
        "WAYLAND_DISPLAY to one, or give it a script to run without");
  }
}

}  // namespace

SdlWindow::SdlWindow(const WindowOptions& options) {
  start_video(options.screen);
  const bool screenless = is_screenless(SDL_GetCurrentVideoDriver());
  SDL_GL_ResetAttributes();
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 3);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
  SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
  if (options.samples > 1 && !screenless) {
    SDL_GL_SetAttribute(SDL_GL_MULTISAMPLEBUFFERS, 1);
    SDL_GL_SetAttribute(SDL_GL_MULTISAMPLESAMPLES, options.samples);
  }
  const std::uint32_t flags =
      SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI |
      static_cast<std::uint32_t>(options.visible ? SDL_WINDOW_SHOWN : SDL_WINDOW_HIDDEN);
  const auto open = [&] {
    window_ = SDL_CreateWindow(options.title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                               options.width, options.height, flags);
    if (window_) context_ = SDL_GL_CreateContext(window_);
    if (window_ && !context_) SDL_DestroyWindow(std::exchange(window_, nullptr));
  };
  open();
  if (!context_ && options.samples > 1) {
    SDL_GL_SetAttribute(SDL_GL_MULTISAMPLEBUFFERS, 0);
    SDL_GL_SetAttribute(SDL_GL_MULTISAMPLESAMPLES, 0);
    open();
  }
  if (!context_) {
    const std::string why = SDL_GetError();
    stop();
    throw Error(
        "there is no OpenGL 3.3 to draw with (" + why +
        "): install the graphics card's driver, or Mesa's software one (Debian: libegl1, libgl1-mesa-dri)");
  }
  SDL_GL_SetSwapInterval(options.vsync && !options.fixed_step ? 1 : 0);
  SDL_SetWindowMinimumSize(window_, 320, 200);
  SDL_StartTextInput();
  if (screenless) picture_ = std::make_unique<Framebuffer>(options.samples);
}

SdlWindow::~SdlWindow() { stop(); }

void SdlWindow::stop() {
  picture_.reset();
  if (context_) SDL_GL_DeleteContext(context_);
  if (window_) SDL_DestroyWindow(window_);
  SDL_QuitSubSystem(SDL_INIT_VIDEO);
}

std::uint32_t SdlWindow::id() const { return SDL_GetWindowID(window_); }

int SdlWindow::width() const {
  int width = 0;
  SDL_GetWindowSize(window_, &width, nullptr);
  return width;
}
int SdlWindow::height() const {
  int height = 0;
  SDL_GetWindowSize(window_, nullptr, &height);
  return height;
}
int SdlWindow::pixel_width() const {
  int width = 0;
  SDL_GL_GetDrawableSize(window_, &width, nullptr);
  return width;
}
int SdlWindow::pixel_height() const {
  int height = 0;
  SDL_GL_GetDrawableSize(window_, nullptr, &height);
  return height;
}

void SdlWindow::begin_drawing() {
  if (picture_) {
    picture_->begin(pixel_width(), pixel_height());
  } else {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, pixel_width(), pixel_height());
  }
}

std::optional<Image> SdlWindow::show(bool with_picture) {
  std::optional<Image> image;
  if (picture_) {
    picture_->finish();
    if (with_picture) image = picture_->image();
  } else {
    // Before it is shown: what the hidden buffer holds afterwards is anybody's guess.
    if (with_picture) image = read_pixels(pixel_width(), pixel_height());
    SDL_GL_SwapWindow(window_);
  }
  return image;
}

}  // namespace seesaw::detail
