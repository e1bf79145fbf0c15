// What a Canvas turns into: pixels, SVG, PDF. Each replays the marks on a Cairo surface of its own.
#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/image/canvas.h"
#include "core/image/png.h"
#include "core/image/raster.h"
#include "core/image/sheet.h"
#include "core/image/svg_text.h"

namespace seesaw {
namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

// Cairo's 32-bit pixels are native-endian ARGB with the color multiplied by alpha; ours are bytes R, G, B,
// A with straight color.
Image straight(const Raster& raster) {
  Image image(raster.width(), raster.height());
  for (int y = 0; y < image.height(); ++y) {
    const auto* row = reinterpret_cast<const std::uint32_t*>(raster.data() + static_cast<std::ptrdiff_t>(y) *
                                                                                 raster.stride());
    for (int x = 0; x < image.width(); ++x) {
      const std::uint32_t argb = row[x], alpha = argb >> 24;
      const auto part = [&](int shift) {
        const std::uint32_t premultiplied = argb >> shift & 0xFF;
        return static_cast<std::uint8_t>(alpha == 255 ? premultiplied
                                         : alpha == 0
                                             ? 0
                                             : std::min(255u, (premultiplied * 255 + alpha / 2) / alpha));
      };
      std::uint8_t* p = image.pixel(x, y);
      p[0] = part(16);
      p[1] = part(8);
      p[2] = part(0);
      p[3] = static_cast<std::uint8_t>(alpha);
    }
  }
  return image;
}

}  // namespace

void require_cairo(int status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw Error(std::string("Cairo cannot draw this: ") +
                cairo_status_to_string(static_cast<cairo_status_t>(status)));
}

void replay_marks(const Canvas::Marks& marks, const Brush& brush) {
  cairo_set_antialias(brush.cairo, CAIRO_ANTIALIAS_GRAY);
  const Color c = safe(marks.background);
  if (c.a > 0) {
    cairo_set_source_rgba(brush.cairo, c.r, c.g, c.b, c.a);
    cairo_paint(brush.cairo);
  }
  for (const auto& mark : marks.list) mark(brush);
  for (auto scope = marks.open.rbegin(); scope != marks.open.rend(); ++scope) (*scope)(brush);
  require_cairo(cairo_status(brush.cairo));
}

void Canvas::picture(const Image& image, const Rect& rect, Sampling sampling) {
  const double sizes = rect.x + rect.y + rect.width + rect.height;
  if (image.empty() || !std::isfinite(sizes) || !(rect.width > 0 && rect.height > 0)) return;
  const int stride = cairo_format_stride_for_width(CAIRO_FORMAT_ARGB32, image.width());
  auto pixels = std::make_shared<std::vector<std::uint32_t>>(static_cast<std::size_t>(stride / 4) *
                                                             static_cast<std::size_t>(image.height()));
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const std::uint8_t* p = image.pixel(x, y);
      const auto part = [&](int i) { return (p[i] * static_cast<std::uint32_t>(p[3]) + 127) / 255; };
      (*pixels)[static_cast<std::size_t>(y) * static_cast<std::size_t>(stride / 4) +
                static_cast<std::size_t>(x)] =
          static_cast<std::uint32_t>(p[3]) << 24 | part(0) << 16 | part(1) << 8 | part(2);
    }
  marks_->list.push_back(
      [pixels, stride, rect, sampling, width = image.width(), height = image.height()](const Brush& brush) {
        cairo_t* cr = brush.cairo;
        const Surface surface(
            cairo_image_surface_create_for_data(reinterpret_cast<unsigned char*>(pixels->data()),
                                                CAIRO_FORMAT_ARGB32, width, height, stride),
            &cairo_surface_destroy);
        cairo_save(cr);
        cairo_rectangle(cr, rect.x, rect.y, rect.width, rect.height);
        cairo_clip(cr);
        cairo_translate(cr, rect.x, rect.y);
        cairo_scale(cr, rect.width / width, rect.height / height);
        cairo_set_source_surface(cr, surface.get(), 0, 0);
        cairo_pattern_set_filter(cairo_get_source(cr),
                                 sampling == Sampling::nearest ? CAIRO_FILTER_NEAREST : CAIRO_FILTER_GOOD);
        // Smoothing at the rim would fade into nothing; vector formats let the viewer do the smoothing.
        if (brush.pixels) cairo_pattern_set_extend(cairo_get_source(cr), CAIRO_EXTEND_PAD);
        cairo_paint(cr);
        cairo_restore(cr);
        cairo_surface_finish(surface.get());
      });
}

Image Canvas::image(double scale) const {
  Raster raster;
  raster.paint(*this, scale);
  return straight(raster);
}

std::string Canvas::svg() const {
  std::string bytes;
  {
    const Surface surface(cairo_svg_surface_create_for_stream(append, &bytes, width(), height()),
                          &cairo_surface_destroy);
    require_cairo(cairo_surface_status(surface.get()));
    const Context cr(cairo_create(surface.get()), &cairo_destroy);
    replay_marks(*marks_, {cr.get(), false});
    cairo_surface_finish(surface.get());
    require_cairo(cairo_surface_status(surface.get()));
  }
  return tidied_svg(bytes, marks_->words);
}

std::string Canvas::pdf() const {
  std::string bytes;
  const Surface surface(cairo_pdf_surface_create_for_stream(append, &bytes, width(), height()),
                        &cairo_surface_destroy);
  require_cairo(cairo_surface_status(surface.get()));
  // Without this Cairo writes today's date, and no two files would be alike.
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
  {
    const Context cr(cairo_create(surface.get()), &cairo_destroy);
    replay_marks(*marks_, {cr.get(), false});
    cairo_show_page(cr.get());
  }
  cairo_surface_finish(surface.get());
  require_cairo(cairo_surface_status(surface.get()));
  return bytes;
}

void Canvas::save(const std::filesystem::path& path, double png_scale) const {
  const std::string ending = ending_of(path);
  if (ending == ".png") return write_png(path, image(png_scale));
  if (ending == ".svg") return write_file(path, svg());
  if (ending == ".pdf") return write_file(path, pdf());
  throw Error(path.string() + ": a picture is saved as .png, .svg or .pdf, not as " +
              (ending.empty() ? "a file without an ending" : ending));
}

}  // namespace seesaw
