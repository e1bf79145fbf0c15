#include "core/image/colormap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/image/theme.h"

namespace seesaw {
namespace {

// Lightness, chroma and hue (degrees): Lab in polar coordinates.
struct Lch {
  double L, C, h;
};

Color color_of(const Lch& lch) {
  const double h = lch.h * std::numbers::pi / 180;
  return seesaw::color_of(Lab{lch.L, lch.C * std::cos(h), lch.C * std::sin(h)});
}

constexpr double middle_lightness = 97, end_lightness = 46;

// One side of the diverging map at |value| = t. The chroma rises faster than the lightness falls, so that
// the sign shows already near zero; its ends and hues lie inside what a screen can show (the test checks
// the lightness, which clamping would bend).
Color side(double t, double end_chroma, double near_hue, double far_hue) {
  return color_of(Lch{middle_lightness + (end_lightness - middle_lightness) * t,
                      end_chroma * (1.45 * t - 0.45 * t * t), near_hue + (far_hue - near_hue) * t});
}

constexpr std::array<Lch, 5> sequential_stops = {Lch{97, 10, 100}, Lch{84, 36, 130}, Lch{64, 34, 180},
                                                 Lch{43, 30, 245}, Lch{20, 40, 292}};

constexpr int steps = 512;  // a table: a picture asks for a million colors, and each costs three powers

template <class Make>
std::array<Color, steps + 1> table_of(Make make) {
  std::array<Color, steps + 1> table;
  for (int i = 0; i <= steps; ++i) table[static_cast<std::size_t>(i)] = make(i / static_cast<double>(steps));
  return table;
}

Color look_up(const std::array<Color, steps + 1>& table, double t) {
  const double place = std::clamp(t, 0.0, 1.0) * steps;
  const auto below = std::min(static_cast<std::size_t>(place), static_cast<std::size_t>(steps - 1));
  return mix(table[below], table[below + 1], place - static_cast<double>(below));
}

}  // namespace

Color diverging_color(double value) {
  static const auto table = table_of([](double t) {
    const double v = 2 * t - 1;
    return v < 0 ? side(-v, 46, 252, 274) : side(v, 66, 72, 54);
  });
  return std::isnan(value) ? theme::missing : look_up(table, (value + 1) / 2);
}

Color sequential_color(double value) {
  static const auto table = table_of([](double t) {
    const double place = t * (sequential_stops.size() - 1);
    const auto k = std::min(static_cast<std::size_t>(place), sequential_stops.size() - 2);
    const Lch &p = sequential_stops[k], &q = sequential_stops[k + 1];
    const double s = place - static_cast<double>(k);
    return color_of(Lch{p.L + (q.L - p.L) * s, p.C + (q.C - p.C) * s, p.h + (q.h - p.h) * s});
  });
  return std::isnan(value) ? theme::missing : look_up(table, value);
}

}  // namespace seesaw
