// How a line of text looks and how large it will be, so that a drawing can make room for it.
//
// The font is DejaVu Sans, by name: it has the Greek, the signs and the superscripts that mathematics
// needs. Letters are drawn unhinted, so that a text has the same shape and length at every scale and in
// every format.
//
// Before it: theme.h. After it: canvas.h, which draws it; chart.h, which makes room for it.
#pragma once

#include <string>
#include <string_view>

#include "core/image/theme.h"

namespace seesaw {

/// Which part of the text stands at the anchor, horizontally ...
enum class Align { left, center, right };
/// ... and vertically: the line it is written on, half the height of its capitals, or their tops.
enum class VerticalAlign { baseline, middle, top };

struct TextStyle {
  double size = 10;  ///< of the font, points; nothing is drawn unless > 0
  Color color = theme::ink;
  bool bold = false;
  bool italic = false;
  Align align = Align::left;
  VerticalAlign vertical = VerticalAlign::baseline;
  double rotation = 0;  ///< degrees, counterclockwise as seen, about the anchor
  double halo = 0;  ///< width of the rim around each letter, points; keeps labels legible on lines and colors
  Color halo_color = theme::paper;
};

/// Lengths in points.
struct TextSize {
  double width = 0;    ///< how far the pen moves; spaces at the ends count
  double ascent = 0;   ///< height of capitals above the baseline: the same for every text of one size
  double descent = 0;  ///< depth of letters like g below it: likewise
  double height() const { return ascent + descent; }
};

/// The size of one line of UTF-8 text, before rotation.
TextSize measure_text(std::string_view text, const TextStyle& style = {});

/// `text` with every byte that is not part of well-formed UTF-8, and every control character, replaced by
/// U+FFFD.
std::string clean_utf8(std::string_view text);

}  // namespace seesaw
