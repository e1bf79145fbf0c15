#include "core/image/symbols.h"

#include <algorithm>
#include <cmath>

namespace seesaw {
namespace {

double pen_width(double size) { return std::max(1.0, 0.19 * size); }
double rim_width(double size) { return std::max(0.8, 0.11 * size); }

}  // namespace

void draw_symbol(Canvas& canvas, Symbol symbol, const Point<2>& at, double size, const Color& color) {
  if (!(size > 0) || !std::isfinite(size)) return;
  const double pen = pen_width(size), rim = rim_width(size), half = size / 2;
  if (symbol == Symbol::circle) {
    const double ring = 0.8 * pen;  // a closed shape looks heavier than a bar of the same width
    canvas.fill_circle(at, half + rim, theme::paper);
    canvas.circle(at, half - ring / 2, {.color = color, .width = ring});
    return;
  }
  const double reach = half - pen / 2;  // round caps add half a pen at each end
  for (const bool under : {true, false}) {
    const Stroke stroke{.color = under ? theme::paper : color, .width = under ? pen + 2 * rim : pen};
    canvas.line(at - Point<2>(reach, 0), at + Point<2>(reach, 0), stroke);
    if (symbol == Symbol::plus) canvas.line(at - Point<2>(0, reach), at + Point<2>(0, reach), stroke);
  }
}

void draw_spike(Canvas& canvas, const Point<2>& from, const Point<2>& direction, double length,
                const Color& color) {
  const double norm = direction.norm();
  if (!(norm > 0) || !std::isfinite(norm) || !(length > 0)) return;
  const Point<2> along = direction / norm, to = from + length * along, across(-along.y(), along.x());
  const double head = std::clamp(0.38 * length, 3.0, 7.0);
  Points<2> tip(2, 3);
  tip << to, to - head * along + 0.36 * head * across, to - head * along - 0.36 * head * across;
  const Stroke shaft{.color = color, .width = 1.3, .cap = Cap::butt};
  const Point<2> neck = to - 0.9 * head * along;
  canvas.line(from, neck, {.color = theme::paper, .width = shaft.width + 1.6});
  canvas.polygon(tip, {.color = theme::paper, .width = 1.6});
  canvas.line(from, neck, shaft);
  canvas.fill_polygon(tip, color);
}

}  // namespace seesaw
