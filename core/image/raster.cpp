#include "core/image/raster.h"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/image/sheet.h"

namespace seesaw {

namespace {

using RasterContext = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

struct RasterSize {
  int columns, rows;
};

RasterSize raster_size(const Canvas& canvas, double scale) {
  const double wide = std::round(canvas.width() * scale), high = std::round(canvas.height() * scale);
  if (!(scale > 0) || !(wide <= 32767) || !(high <= 32767))
    throw Error("a picture of " + to_text(canvas.width()) + " x " + to_text(canvas.height()) + " points at " +
                to_text(scale) + " pixels a point cannot be made (1 to 32767 pixels a side)");
  return {std::max(1, static_cast<int>(wide)), std::max(1, static_cast<int>(high))};
}

// n / 255 to the nearest, for n up to 255 * 255; in 16 bits, of which a vector has many.
constexpr std::uint16_t over_255(std::uint16_t n) {
  const auto m = static_cast<std::uint16_t>(n + 128);
  return static_cast<std::uint16_t>(static_cast<std::uint16_t>(m + (m >> 8)) >> 8);
}

// A block of pixels at a time: its parts one after another in 16 bits each are what the compiler makes
// vectors of. Premultiplied, alpha takes the place of 1: that keeps every part within 0 .. alpha.
void negative_of(std::uint32_t* pixels, int count, const std::uint16_t (&black)[3]) {
  constexpr int block = 128;
  std::uint16_t part[3][block], alpha[block], shift[block];
  for (int start = 0; start < count; start += block) {
    std::uint32_t* const at = pixels + start;
    const int size = std::min(block, count - start);
    for (int i = 0; i < size; ++i) {
      part[0][i] = static_cast<std::uint16_t>(at[i] & 0xFF);
      part[1][i] = static_cast<std::uint16_t>(at[i] >> 8 & 0xFF);
      part[2][i] = static_cast<std::uint16_t>(at[i] >> 16 & 0xFF);
      alpha[i] = static_cast<std::uint16_t>(at[i] >> 24);
    }
    for (int i = 0; i < size; ++i) {
      const std::uint16_t most = std::max(std::max(part[0][i], part[1][i]), part[2][i]);
      const std::uint16_t least = std::min(std::min(part[0][i], part[1][i]), part[2][i]);
      shift[i] = static_cast<std::uint16_t>(alpha[i] - most - least);
    }
    for (int c = 0; c < 3; ++c) {
      const std::uint16_t floor = black[c], range = static_cast<std::uint16_t>(255 - floor);
      for (int i = 0; i < size; ++i) {
        const auto inverted = static_cast<std::uint16_t>(part[c][i] + shift[i]);
        part[c][i] = over_255(static_cast<std::uint16_t>(static_cast<std::uint16_t>(floor * alpha[i]) +
                                                         static_cast<std::uint16_t>(range * inverted)));
      }
    }
    for (int i = 0; i < size; ++i)
      at[i] = static_cast<std::uint32_t>(alpha[i]) << 24 | static_cast<std::uint32_t>(part[2][i]) << 16 |
              static_cast<std::uint32_t>(part[1][i]) << 8 | part[0][i];
  }
}

}  // namespace

Raster::~Raster() { clear(); }

void Raster::clear() {
  if (surface_) cairo_surface_destroy(surface_);
  surface_ = nullptr;
}

void Raster::paint(const Canvas& canvas, double scale) {
  try {
    const RasterSize size = raster_size(canvas, scale);
    const bool kept = surface_ && width() == size.columns && height() == size.rows;
    if (!kept) {
      clear();
      surface_ = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, size.columns, size.rows);
      require_cairo(cairo_surface_status(surface_));
    }
    const RasterContext cr(cairo_create(surface_), &cairo_destroy);
    if (kept && !(canvas.marks_->background.a >= 1)) {
      cairo_set_operator(cr.get(), CAIRO_OPERATOR_CLEAR);
      cairo_paint(cr.get());
      cairo_set_operator(cr.get(), CAIRO_OPERATOR_OVER);
    }
    cairo_scale(cr.get(), size.columns / canvas.width(), size.rows / canvas.height());
    replay_marks(*canvas.marks_, {cr.get(), true});
    cairo_surface_flush(surface_);
  } catch (...) {
    clear();
    throw;
  }
}

void Raster::paint_over(const Canvas& canvas) {
  if (empty()) return;
  const RasterContext cr(cairo_create(surface_), &cairo_destroy);
  cairo_scale(cr.get(), width() / canvas.width(), height() / canvas.height());
  replay_marks(*canvas.marks_, {cr.get(), true});
  cairo_surface_flush(surface_);
}

void Raster::copy(const Raster& other) {
  if (&other == this) return;
  if (other.empty()) return clear();
  if (width() != other.width() || height() != other.height()) {
    clear();
    surface_ = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, other.width(), other.height());
    require_cairo(cairo_surface_status(surface_));
  }
  // The rows of two surfaces of one size and format are equally long.
  std::copy_n(other.data(), static_cast<std::ptrdiff_t>(stride()) * height(),
              cairo_image_surface_get_data(surface_));
  cairo_surface_mark_dirty(surface_);
}

void Raster::negative(const Color& black) {
  if (empty()) return;
  const std::uint16_t parts[3] = {byte_of(black.b), byte_of(black.g), byte_of(black.r)};
  unsigned char* const first = cairo_image_surface_get_data(surface_);
  for (int y = 0; y < height(); ++y)
    negative_of(reinterpret_cast<std::uint32_t*>(first + static_cast<std::ptrdiff_t>(y) * stride()), width(),
                parts);
  cairo_surface_mark_dirty(surface_);
}

const std::uint8_t* Raster::data() const {
  return surface_ ? cairo_image_surface_get_data(surface_) : nullptr;
}
int Raster::width() const { return surface_ ? cairo_image_surface_get_width(surface_) : 0; }
int Raster::height() const { return surface_ ? cairo_image_surface_get_height(surface_) : 0; }
int Raster::stride() const { return surface_ ? cairo_image_surface_get_stride(surface_) : 0; }

}  // namespace seesaw
