#include "core/scene/constraint_layer.h"

#include "core/image/symbols.h"
#include "core/scene/picture.h"

namespace seesaw {

namespace {

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

Color color_of(bool highlight) { return highlight ? theme::moved : theme::constraint; }

}  // namespace

void draw_constraints(Canvas& canvas, const PlanView& view, const Document<2>& document,
                      const PictureOptions& options) {
  if (!document.display.constraints) return;
  if (document.display.normals)
    for (const auto& each : document.constraints) {
      if (!each.constraint.normal) continue;
      const Point<2> n = each.constraint.normal->direction;
      draw_spike(canvas, view.page_from_scene(each.constraint.at), {n.x(), -n.y()}, options.spike_length,
                 color_of(each.highlight || each.highlight_normal));
    }
  // Highlighted ones last, so that nothing hides them.
  for (const bool highlighted : {false, true})
    for (const auto& each : document.constraints) {
      if (each.highlight != highlighted) continue;
      const Point<2> at = view.page_from_scene(each.constraint.at);
      draw_symbol(canvas, symbol_of(each.constraint.kind), at, options.symbol_size, color_of(highlighted));
      if (!each.label.empty())
        canvas.text(at + Point<2>(0.8, -0.8) * options.symbol_size, each.label,
                    {.size = options.text_size + 1, .color = color_of(highlighted), .halo = 2.5});
    }
}

std::vector<Point<2>> symbol_places(const PlanView& view, const Document<2>& document) {
  std::vector<Point<2>> places;
  if (document.display.constraints)
    for (const auto& each : document.constraints) places.push_back(view.page_from_scene(each.constraint.at));
  return places;
}

}  // namespace seesaw
