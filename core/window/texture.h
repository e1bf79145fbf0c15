// Pixels on the graphics card, to be shown in a window.
//
// A canvas costs milliseconds to draw and a tenth of one to show, so a program draws it when something has
// changed, uploads it, and shows the same texture every frame until the next change:
//
//     if (changed) texture.upload(canvas.image(window.pixel_ratio()));
//     ui::background(texture, rect);
//
// Where the texture has as many pixels as its place on the screen they arrive there exactly, byte for byte.
//
// Before it: core/image, or a Framebuffer that was drawn into. After it: core/window/ui.h shows it.
#pragma once

#include <cstdint>
#include <utility>

#include "core/image/image.h"

namespace seesaw {

/// The order of a pixel's bytes in memory. Cairo's are B, G, R, A.
enum class PixelOrder { rgba, bgra };

/// Somebody else's pixels, top row first, `stride` bytes from row to row.
struct Pixels {
  const std::uint8_t* data = nullptr;
  int width = 0, height = 0;
  int stride = 0;
  PixelOrder order = PixelOrder::rgba;
};

class Texture {
 public:
  /// Without pixels: shown, it is nothing. Needs no window yet.
  Texture() = default;
  ~Texture();
  Texture(Texture&& other) noexcept { swap(other); }
  Texture& operator=(Texture&& other) noexcept {
    swap(other);
    return *this;
  }

  /// Replaces all pixels; a Window must exist, now and when the texture goes. Storage is kept while the size
  /// stays the same. Throws Error for more pixels a side than the graphics card takes.
  void upload(const Image& image);
  void upload(const Pixels& pixels);
  /// Room for width x height pixels (0 for none), whatever they are. `bottom_up`: row 0 will be the lowest.
  void reserve(int width, int height, bool bottom_up);
  /// Shows enlarged pixels as sharp squares.
  void set_sharp(bool sharp);

  int width() const { return width_; }
  int height() const { return height_; }
  bool empty() const { return width_ == 0 || height_ == 0; }
  /// Whether row 0 is the lowest, as OpenGL draws, or the top one, as images are stored.
  bool bottom_up() const { return bottom_up_; }
  /// OpenGL's name of it, 0 while empty.
  unsigned name() const { return name_; }

 private:
  void swap(Texture& other) {
    std::swap(name_, other.name_);
    std::swap(width_, other.width_);
    std::swap(height_, other.height_);
    std::swap(bottom_up_, other.bottom_up_);
  }

  unsigned name_ = 0;
  int width_ = 0, height_ = 0;
  bool bottom_up_ = false;
};

}  // namespace seesaw
