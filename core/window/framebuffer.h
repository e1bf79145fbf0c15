// A picture that is drawn into by OpenGL instead of the screen.
//
// It has a color texture and a depth buffer. With `samples` > 1 edges are drawn smooth: each pixel is sampled
// several times, and `finish` averages. That is free on most graphics cards and ten times slower on none.
//
// Before it: a Window, whose context it lives in. After it: its texture, in a panel; or readback.h.
#pragma once

#include "core/image/image.h"
#include "core/window/texture.h"

namespace seesaw {

class Framebuffer {
 public:
  /// `samples` a pixel, 0 or 1 for no smoothing; the card's most where it has fewer.
  explicit Framebuffer(int samples = 0);
  ~Framebuffer();
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;

  /// Makes it width x height pixels, >= 1, and what is drawn from now on goes into it. What it held is kept
  /// only where the size stays the same. Throws Error where the graphics card refuses.
  void begin(int width, int height);
  /// Ends drawing; the texture then holds the picture.
  void finish();

  const Texture& texture() const { return texture_; }
  int width() const { return texture_.width(); }
  int height() const { return texture_.height(); }
  /// The finished picture, opaque.
  Image image() const;

 private:
  int samples_;
  Texture texture_;
  unsigned target_ = 0;         // where the texture is drawn to
  unsigned depth_ = 0;          // its depth
  unsigned smooth_target_ = 0;  // with several samples: drawn to first
  unsigned smooth_color_ = 0;
};

}  // namespace seesaw
