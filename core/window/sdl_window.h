// Inside core/window: SDL's window and OpenGL's context, owned, and the words for when they cannot be had.
//
// Before it: WindowOptions. After it: window.cpp.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/window/framebuffer.h"
#include "core/window/window.h"

struct SDL_Window;

namespace seesaw::detail {

class SdlWindow {
 public:
  explicit SdlWindow(const WindowOptions& options);
  ~SdlWindow();
  SdlWindow(const SdlWindow&) = delete;
  SdlWindow& operator=(const SdlWindow&) = delete;

  SDL_Window* get() const { return window_; }
  std::uint32_t id() const;
  int width() const;
  int height() const;
  int pixel_width() const;
  int pixel_height() const;
  bool has_screen() const { return !picture_; }

  /// What is drawn from now on is the frame.
  void begin_drawing();
  /// Shows it; returns it too, where wanted.
  std::optional<Image> show(bool with_picture);

 private:
  void stop();

  SDL_Window* window_ = nullptr;
  void* context_ = nullptr;
  /// Stands in for the screen where there is none.
  std::unique_ptr<Framebuffer> picture_;
};

}  // namespace seesaw::detail
