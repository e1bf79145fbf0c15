// Pixels in memory: 8 bits each of red, green, blue and straight alpha; rows one after another, the top one
// first.
//
// Before it: a Canvas that was drawn on, a ray tracer, or read_png.
// After it: png.h (to a file), compare.h (against another), Canvas::picture (into a larger picture).
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/check.h"
#include "core/image/color.h"

namespace seesaw {

/// width x height pixels, sRGB. Pixel (x, y) counts from the top left; its bytes R, G, B, A start at 4 * (y
/// * width + x).
class Image {
 public:
  /// No pixels.
  Image() = default;

  /// All pixels `fill`. Sizes in pixels, 0 or more.
  Image(int width, int height, const Color& fill = Color{0, 0, 0, 0}) : width_(width), height_(height) {
    SEESAW_CHECK_GE(width, 0);
    SEESAW_CHECK_GE(height, 0);
    bytes_.resize(std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) set(x, y, fill);
  }

  int width() const { return width_; }
  int height() const { return height_; }
  bool empty() const { return bytes_.empty(); }

  /// The four bytes R, G, B, A of pixel (x, y), 0 <= x < width, 0 <= y < height (unchecked: inner loops).
  std::uint8_t* pixel(int x, int y) { return bytes_.data() + offset(x, y); }
  const std::uint8_t* pixel(int x, int y) const { return bytes_.data() + offset(x, y); }

  /// The pixel as a color; checked.
  Color at(int x, int y) const {
    check(x, y);
    const std::uint8_t* p = pixel(x, y);
    return {p[0] / 255.0, p[1] / 255.0, p[2] / 255.0, p[3] / 255.0};
  }

  void set(int x, int y, const Color& color) {
    check(x, y);
    std::uint8_t* p = pixel(x, y);
    p[0] = byte_of(color.r);
    p[1] = byte_of(color.g);
    p[2] = byte_of(color.b);
    p[3] = byte_of(color.a);
  }

  /// All bytes, 4 * width * height.
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }
  std::vector<std::uint8_t>& bytes() { return bytes_; }

  friend bool operator==(const Image&, const Image&) = default;

 private:
  std::size_t offset(int x, int y) const {
    return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x));
  }
  void check(int x, int y) const {
    SEESAW_CHECK_LE(0, x);
    SEESAW_CHECK_LT(x, width_);
    SEESAW_CHECK_LE(0, y);
    SEESAW_CHECK_LT(y, height_);
  }

  int width_ = 0, height_ = 0;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace seesaw
