// The letters of a Canvas: measuring, placing, halos, and breaking into lines.
#include <cairo.h>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "core/image/canvas.h"
#include "core/image/sheet.h"
#include "core/image/text_style.h"

namespace seesaw {
namespace {

// DejaVu Sans, from its own tables (2048 units an em): tops of capitals 1493, bottoms of g and p -483 and
// the like.
constexpr double capital_height = 0.729;
constexpr double descender_depth = 0.236;

// The four faces are kept for as long as the program runs: looking one up by name takes a while.
cairo_font_face_t* face(bool bold, bool italic) {
  static const auto faces = [] {
    std::array<cairo_font_face_t*, 4> all{};
    for (std::size_t i = 0; i < all.size(); ++i)
      all[i] =
          cairo_toy_font_face_create("DejaVu Sans", i & 1 ? CAIRO_FONT_SLANT_ITALIC : CAIRO_FONT_SLANT_NORMAL,
                                     i & 2 ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    return all;
  }();
  return faces[(bold ? 2u : 0u) + (italic ? 1u : 0u)];
}

void select_font(cairo_t* cr, const TextStyle& style, double size) {
  cairo_set_font_face(cr, face(style.bold, style.italic));
  cairo_set_font_size(cr, size);
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(cr, options);
  cairo_font_options_destroy(options);
}

bool drawable(const TextStyle& style) {
  return style.size > 0 && std::isfinite(style.size) && std::isfinite(style.rotation);
}

// One letter of UTF-8 starting at text[at]: its length in bytes, or 0 when the bytes there are not well
// formed.
std::size_t letter_length(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned>(static_cast<unsigned char>(text[i])) : 0u;
  };
  const unsigned lead = byte(at);
  if (lead < 0x80) return lead >= 0x20 && lead != 0x7F ? 1 : 0;
  const std::size_t length = lead >= 0xC2 && lead < 0xE0   ? 2
                             : (lead & 0xF0) == 0xE0       ? 3
                             : lead >= 0xF0 && lead < 0xF5 ? 4
                                                           : 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(at + i) & 0xC0) != 0x80) return 0;
  const unsigned second = byte(at + 1);
  const bool overlong = (lead == 0xE0 && second < 0xA0) || (lead == 0xF0 && second < 0x90);
  const bool beyond = (lead == 0xED && second >= 0xA0) || (lead == 0xF4 && second >= 0x90);
  return overlong || beyond ? 0 : length;
}

}  // namespace

std::string clean_utf8(std::string_view text) {
  std::string clean;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = letter_length(text, at);
    clean += length > 0 ? text.substr(at, length) : std::string_view("\xEF\xBF\xBD");
    at += length > 0 ? length : 1;
  }
  return clean;
}

TextSize measure_text(std::string_view text, const TextStyle& style) {
  if (!drawable(style)) return {};
  // Measured large, then scaled: the font library rounds small sizes to 1/64.
  constexpr double large = 256;
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1), &cairo_surface_destroy);
  const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cr(cairo_create(surface.get()), &cairo_destroy);
  select_font(cr.get(), style, large);
  cairo_text_extents_t extents;
  cairo_text_extents(cr.get(), clean_utf8(text).c_str(), &extents);
  return {extents.x_advance / large * style.size, capital_height * style.size, descender_depth * style.size};
}

void Canvas::text(const Point<2>& at, std::string_view text, const TextStyle& style) {
  if (!at.allFinite() || !marks_->reach().contains(at) || !drawable(style) || text.empty()) return;
  std::string words = clean_utf8(text);
  const TextSize size = measure_text(words, style);
  const double right = style.align == Align::left     ? 0
                       : style.align == Align::center ? -size.width / 2
                                                      : -size.width;
  const double down = style.vertical == VerticalAlign::baseline ? 0
                      : style.vertical == VerticalAlign::middle ? size.ascent / 2
                                                                : size.ascent;
  marks_->words.push_back(words);
  marks_->list.push_back([at, words = std::move(words), style, right, down](const Brush& brush) {
    cairo_t* cr = brush.cairo;
    cairo_save(cr);
    cairo_translate(cr, at.x(), at.y());
    cairo_rotate(cr, -style.rotation * std::numbers::pi / 180);
    select_font(cr, style, style.size);
    if (style.halo > 0 && std::isfinite(style.halo)) {
      const Color c = safe(style.halo_color);
      cairo_move_to(cr, right, down);
      cairo_text_path(cr, words.c_str());
      cairo_set_source_rgba(cr, c.r, c.g, c.b, c.a);
      cairo_set_line_width(cr, 2 * style.halo);
      cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
      cairo_set_dash(cr, nullptr, 0, 0);
      cairo_stroke(cr);
    }
    const Color c = safe(style.color);
    cairo_set_source_rgba(cr, c.r, c.g, c.b, c.a);
    cairo_move_to(cr, right, down);
    if (brush.pixels) {
      cairo_text_path(cr, words.c_str());
      cairo_set_fill_rule(cr, CAIRO_FILL_RULE_WINDING);
      cairo_fill(cr);
    } else {
      cairo_show_text(cr, words.c_str());
    }
    cairo_new_path(cr);  // the pen that text leaves behind would start the next mark
    cairo_restore(cr);
  });
}

double Canvas::text_block(const Point<2>& top_left, double width, std::string_view text,
                          const TextStyle& style, double line_spacing) {
  if (!drawable(style) || text.empty()) return 0;
  std::vector<std::string> lines(1);
  std::string word;
  const auto finish_word = [&] {
    if (word.empty()) return;
    const std::string longer = lines.back().empty() ? word : lines.back() + ' ' + word;
    if (!lines.back().empty() && measure_text(longer, style).width > width)
      lines.push_back(word);
    else
      lines.back() = longer;
    word.clear();
  };
  for (const char c : text) {
    if (c == ' ' || c == '\n') {
      finish_word();
      if (c == '\n') lines.emplace_back();
    } else {
      word += c;
    }
  }
  finish_word();

  TextStyle upright = style;
  upright.vertical = VerticalAlign::top;
  upright.rotation = 0;
  const double indent = style.align == Align::left ? 0 : style.align == Align::center ? width / 2 : width;
  const double step = line_spacing * style.size;
  for (std::size_t i = 0; i < lines.size(); ++i)
    this->text(top_left + Point<2>(indent, static_cast<double>(i) * step), lines[i], upright);
  return static_cast<double>(lines.size() - 1) * step + measure_text("x", style).height();
}

}  // namespace seesaw
