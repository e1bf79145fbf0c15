// A hand at a desk: clicks and drags in pixels, as a person's.
#pragma once

#include "core/editing/desk.h"

namespace seesaw {

inline constexpr Held no_keys{}, shift_key{.shift = true}, ctrl_key{.ctrl = true}, alt_key{.alt = true};

struct TestHand {
  Desk& desk;

  void down(const Point<2>& at, Held held = {}, PointerButton button = PointerButton::left, int clicks = 1) {
    desk.handle(PointerMoved{at, held});
    desk.handle(PointerDown{at, button, held, clicks});
  }
  void to(const Point<2>& at, Held held = {}) { desk.handle(PointerMoved{at, held}); }
  std::optional<DeskCommand> up(const Point<2>& at, Held held = {},
                                PointerButton button = PointerButton::left) {
    return desk.handle(PointerUp{at, button, held});
  }
  std::optional<DeskCommand> click(const Point<2>& at, Held held = {}, int clicks = 1) {
    down(at, held, PointerButton::left, clicks);
    return up(at, held);
  }
  /// In some moves, with `held` at the press and `later` from then on.
  void drag(const Point<2>& from, const Point<2>& end, Held held = {}, Held later = {},
            PointerButton button = PointerButton::left) {
    down(from, held, button);
    for (const double t : {0.3, 0.6, 1.0}) to(from + t * (end - from), later);
    up(end, later, button);
  }
  std::optional<DeskCommand> key(DeskKey key, Held held = {}) {
    const auto left = desk.handle(KeyDown{key, held});
    desk.handle(KeyUp{key});
    return left;
  }
};

}  // namespace seesaw
