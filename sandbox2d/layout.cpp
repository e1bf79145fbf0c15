#include "sandbox2d/layout.h"

#include <algorithm>
#include <cmath>

namespace seesaw {

Layout layout_of(const LayoutWish& wish) {
  Layout layout;
  const double s = wish.scale, top = std::ceil(wish.menu), status = std::round(30 * s);
  double height = std::max(1.0, wish.height - top - status);
  layout.status = {0, top + height, wish.width, status};
  const double least = std::max(1.0, 0.2 * wish.width);
  double left = 0, right = wish.width;
  const auto room = [&](double wanted) { return right - left - wanted >= least; };
  const double tools = std::round(132 * s);
  if (wish.panels && room(tools)) {
    layout.tools = {0, top, tools, height};
    left = tools;
  }
  // Letters for a hall leave the scene its place: the panel is then as narrow as can be read.
  const double side = std::round(std::clamp(0.31 * wish.width, 236 * s, 292 * s));
  if (wish.panels && room(side)) {
    layout.side = {right - side, top, side, height};
    right = layout.side.x;
  }
  if (wish.tour) {
    const double words = std::min(std::round(178 * s), 0.5 * height);
    height -= words;
    layout.tour = {left, top + height, right - left, words};
  }
  const bool beside = wish.plate || wish.profile;
  const double half = std::round(0.46 * (right - left));
  if (beside && room(half)) {
    const Rect column{right - half, top, half, height};
    right = column.x;
    // The chart needs little height, the plate all it can get.
    double chart = !wish.profile ? 0 : height;
    if (wish.profile && wish.plate) chart = std::round(std::clamp(130 * s, 0.36 * height, 0.5 * height));
    if (chart < 100 * s) chart = 0;  // nothing could be read
    if (wish.plate) layout.plate = {column.x, top, half, height - chart};
    if (chart > 0) layout.profile = {column.x, top + height - chart, half, chart};
  }
  layout.scene = {left, top, right - left, height};
  return layout;
}

}  // namespace seesaw
