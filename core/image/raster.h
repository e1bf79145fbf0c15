// Pixels of a canvas for a program that draws often: painted into memory that is kept, and handed out as they
// lie there.
//
// Canvas::image makes new pixels every time and turns them into straight R, G, B, A. A window needs neither:
// graphics cards take Cairo's own order, and the next picture has the size of the last.
//
//     Raster raster;                                        // kept from frame to frame
//     raster.paint(canvas, window.pixel_ratio());
//     if (dark) raster.negative(hex("#15181D"));
//     texture.upload(Pixels{raster.data(), raster.width(), raster.height(), raster.stride(),
//                           PixelOrder::bgra});
//
// In memory a pixel is the bytes B, G, R, A (on a big-endian machine A, R, G, B), the top row first. Color is
// premultiplied: B, G and R are already multiplied by A / 255. So they are the color itself where the canvas
// is opaque, as one with the usual paper is everywhere.
//
// Before it: canvas.h. After it: core/window/texture.h.
#pragma once

#include <cstdint>

#include "core/image/canvas.h"

struct _cairo_surface;  // cairo_surface_t, by Cairo's own name for it: its headers stay out of ours

namespace seesaw {

class Raster {
 public:
  /// No pixels.
  Raster() = default;
  ~Raster();
  Raster(Raster&& other) noexcept : surface_(std::exchange(other.surface_, nullptr)) {}
  Raster& operator=(Raster&& other) noexcept {
    std::swap(surface_, other.surface_);
    return *this;
  }

  /// The pixels that canvas.image(scale) has, in place of those of before. The memory is the same while the
  /// size stays the same. Throws Error as Canvas::image does; there are then no pixels.
  void paint(const Canvas& canvas, double scale = 1);

  /// The pixels of `canvas`, which usually has no background, laid over those that are there: what is under
  /// the pointer over a picture that took longer to paint. The sizes must agree; does nothing without pixels.
  void paint_over(const Canvas& canvas);

  /// Makes the pixels those of `other`, in the memory that is there if the sizes agree.
  void copy(const Raster& other);

  /// Turns the picture into its negative in lightness, but not in hue, for a window that is dark: what was
  /// white becomes `black` to the byte, what was black becomes white, what was light blue a dark blue. Alpha
  /// stays, that of `black` does not count.
  ///
  /// HSL calls (max + min) / 2 of a pixel's r, g, b its lightness, and r + (1 - max - min), and likewise g
  /// and b, turns that upside down: the differences of the parts, so the hue, are what they were. Then 0 .. 1
  /// is drawn together to black .. 1, part by part: neutral colors take on the tint of `black`.
  void negative(const Color& black);

  /// Null where there are no pixels. Lasts until the next paint().
  const std::uint8_t* data() const;
  int width() const;
  int height() const;
  /// Bytes from one row to the next: 4 * width or more, a multiple of 4.
  int stride() const;
  bool empty() const { return surface_ == nullptr; }

 private:
  void clear();

  _cairo_surface* surface_ = nullptr;
};

}  // namespace seesaw
