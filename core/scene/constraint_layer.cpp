#include "core/scene/constraint_layer.h"

#include <cmath>
#include <set>
#include <utility>

#include "core/image/symbols.h"
#include "core/scene/picture.h"

namespace seesaw {

namespace {

// Thousands of small symbols, as two marks: a rim of paper under all of them, then the ink.
void draw_small_symbols(Canvas& canvas, const std::vector<std::pair<Symbol, Point<2>>>& symbols, double size,
                        const Color& color) {
  const auto bar = [](const Point<2>& at, double half_width, double half_height) {
    Points<2> ring(2, 4);
    ring << at.x() - half_width, at.x() + half_width, at.x() + half_width, at.x() - half_width,
        at.y() - half_height, at.y() - half_height, at.y() + half_height, at.y() + half_height;
    return ring;
  };
  const auto disc = [](const Point<2>& at, double radius) {
    Points<2> ring(2, 8);
    for (Index i = 0; i < 8; ++i)
      ring.col(i) = at + radius * Point<2>(std::cos(M_PI / 4 * static_cast<double>(i)),
                                           std::sin(M_PI / 4 * static_cast<double>(i)));
    return ring;
  };
  for (const double rim : {0.6, 0.0}) {
    std::vector<Points<2>> rings;
    for (const auto& [symbol, at] : symbols) {
      const double half = size / 2 + rim, pen = 0.14 * size + rim;
      if (symbol == Symbol::circle) {
        rings.push_back(disc(at, 0.8 * size / 2 + rim));
        continue;
      }
      rings.push_back(bar(at, half, pen));
      if (symbol == Symbol::plus) rings.push_back(bar(at, pen, half));
    }
    if (!rings.empty()) canvas.fill_rings(rings, rim > 0 ? theme::paper : color, FillRule::winding);
  }
}

// Spikes of a crowd, likewise: arrows of seven corners.
void draw_many_spikes(Canvas& canvas, const std::vector<std::pair<Point<2>, Point<2>>>& spikes, double length,
                      const Color& color) {
  const double head = std::clamp(0.38 * length, 3.0, 7.0);
  for (const double rim : {0.8, 0.0}) {
    std::vector<Points<2>> rings;
    rings.reserve(spikes.size());
    const double shaft = 0.65 + rim, wing = 0.36 * head + rim, neck = length - head - rim;
    for (const auto& [at, along] : spikes) {
      const Point<2> across(-along.y(), along.x());
      Points<2> ring(2, 7);
      ring << at + shaft * across, at + neck * along + shaft * across, at + neck * along + wing * across,
          at + (length + rim) * along, at + neck * along - wing * across, at + neck * along - shaft * across,
          at - shaft * across;
      rings.push_back(std::move(ring));
    }
    if (!rings.empty()) canvas.fill_rings(rings, rim > 0 ? theme::paper : color, FillRule::winding);
  }
}

Color color_of(bool highlight) { return highlight ? theme::moved : theme::constraint; }

// A mark each, so that a spike's rim lies over its neighbor; but not of thousands.
void draw_spikes(Canvas& canvas, const PlanView& view, const Document<2>& document,
                 const PictureOptions& options) {
  const bool crowd = document.constraints.size() > 200;
  for (const bool highlighted : {false, true}) {
    std::vector<std::pair<Point<2>, Point<2>>> many;
    for (const auto& each : document.constraints) {
      if (!each.constraint.normal || (crowd && (each.highlight || each.highlight_normal) != highlighted))
        continue;
      const Point<2> n = each.constraint.normal->direction, at = view.page_from_scene(each.constraint.at);
      const Point<2> along(n.x(), -n.y());
      if (crowd)
        many.emplace_back(at, along.stableNormalized());
      else
        draw_spike(canvas, at, along, options.spike_length,
                   color_of(each.highlight || each.highlight_normal));
    }
    draw_many_spikes(canvas, many, options.spike_length, color_of(highlighted));
    if (!crowd) return;
  }
}

}  // namespace

Symbol symbol_of(ConstraintKind kind) {
  switch (kind) {
    case ConstraintKind::boundary:
      return Symbol::circle;
    case ConstraintKind::interior:
      return Symbol::plus;
    case ConstraintKind::exterior:
      return Symbol::minus;
  }
  return Symbol::circle;
}

void draw_constraints(Canvas& canvas, const PlanView& view, const Document<2>& document,
                      const PictureOptions& options) {
  if (!document.display.constraints) return;
  if (document.display.normals) draw_spikes(canvas, view, document, options);
  // Highlighted ones last, so that nothing hides them.
  constexpr double small = 7;
  for (const bool highlighted : {false, true}) {
    std::vector<std::pair<Symbol, Point<2>>> dots;
    for (const auto& each : document.constraints) {
      if (each.highlight != highlighted) continue;
      const Point<2> at = view.page_from_scene(each.constraint.at);
      if (options.symbol_size < small)
        dots.push_back({symbol_of(each.constraint.kind), at});
      else
        draw_symbol(canvas, symbol_of(each.constraint.kind), at, options.symbol_size, color_of(highlighted));
      if (!each.label.empty())
        canvas.text(at + Point<2>(0.8, -0.8) * options.symbol_size, each.label,
                    {.size = options.text_size + 1, .color = color_of(highlighted), .halo = 2.5});
    }
    draw_small_symbols(canvas, dots, options.symbol_size, color_of(highlighted));
  }
}

std::vector<Point<2>> symbol_places(const PlanView& view, const Document<2>& document) {
  std::vector<Point<2>> places;
  if (!document.display.constraints) return places;
  // Of thousands that crowd a curve one in a cell says as much to a label, and is a tenth of the work.
  constexpr std::size_t crowd = 200;
  constexpr double cell = 6;
  std::set<std::pair<double, double>> taken;
  for (const auto& each : document.constraints) {
    const Point<2> at = view.page_from_scene(each.constraint.at);
    if (document.constraints.size() <= crowd ||
        taken.emplace(std::floor(at.x() / cell), std::floor(at.y() / cell)).second)
      places.push_back(at);
  }
  return places;
}

}  // namespace seesaw
