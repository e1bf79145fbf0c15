// A color, and the space in which the eye measures how far apart two colors are.
//
// Screens and files speak sRGB: three numbers that say how hard to drive three lamps, on a bent scale. The
// eye does not: equal steps in sRGB look unequal. CIE Lab (1976) bends the space so that distance is nearly
// what is seen: L is lightness (0 black, 100 white), a runs from green to red, b from blue to yellow, and
// two colors about 2.3 apart are just told apart.
//
// Before it: nothing. After it: theme.h (the house palette), colormap.h (values to colors), canvas.h,
// compare.h.
#pragma once

#include <cstdint>
#include <string_view>

#include "core/base/error.h"

namespace seesaw {

/// An sRGB color with straight (not premultiplied) alpha; every part in 0 .. 1.
struct Color {
  double r = 0, g = 0, b = 0, a = 1;

  /// The same color with another opacity, 0 (invisible) to 1 (opaque).
  constexpr Color with_alpha(double alpha) const { return {r, g, b, alpha}; }
  friend constexpr bool operator==(const Color&, const Color&) = default;
};

/// The color written "#RRGGBB" or "#RRGGBBAA". Throws Error when it is not one; in a constant, that is a
/// compile error instead. Example: hex("#D55E00") is vermilion.
constexpr Color hex(std::string_view text) {
  const auto digit = [text](std::size_t at) {
    const char c = text[at];
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    throw Error("not a color: \"" + std::string(text) + "\" (expected #RRGGBB or #RRGGBBAA)");
  };
  if ((text.size() != 7 && text.size() != 9) || text[0] != '#')
    throw Error("not a color: \"" + std::string(text) + "\" (expected #RRGGBB or #RRGGBBAA)");
  const auto part = [&](std::size_t at) { return (16 * digit(at) + digit(at + 1)) / 255.0; };
  return {part(1), part(3), part(5), text.size() == 9 ? part(7) : 1.0};
}

/// a at t = 0, b at t = 1, straight in sRGB between; t outside 0 .. 1 is clamped.
Color mix(const Color& a, const Color& b, double t);

/// The part 0 .. 1 as a byte: clamped, rounded to nearest; not a number is 0.
std::uint8_t byte_of(double part);

/// CIE 1976 L*a*b* for the white point D65, as doubles: L in 0 .. 100, a and b within about -110 .. 110.
struct Lab {
  double L = 0, a = 0, b = 0;
};

/// Ignores alpha. Inverse of each other within rounding, for colors that a screen can show.
Lab lab_of(const Color& color);
/// Opaque. Colors that no screen can show are clamped part by part to the nearest lamp setting.
Color color_of(const Lab& lab);

/// CIE 1976 color difference: the distance in Lab. 0 alike, 2.3 just noticeable, 100 black to white.
double delta_e(const Lab& a, const Lab& b);

/// How `color` looks to a person without green cones (deuteranopia, the commonest color blindness), after
/// Machado, Oliveira and Fernandes 2009 at full severity. The palettes are tested through this.
Color seen_without_green_cones(const Color& color);

}  // namespace seesaw
