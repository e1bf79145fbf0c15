// What a hand does to a desk, as plain data: the pointer, its buttons and wheel, the keys.
//
// Before it: a window, which turns its pixels into scene units by the desk's own view; a script; a test.
// After it: core/editing/desk.h.
//
// Positions are in scene units, so an event means the same in a window of any size. Each is to be made with
// the view as it is when the event is handled: one that is handled before it may have moved the view.
#pragma once

#include <string>
#include <variant>

#include "core/base/types.h"

namespace seesaw {

enum class PointerButton { left, middle, right };

/// The modifier keys that are held down.
struct Held {
  bool shift = false, ctrl = false, alt = false;
  bool operator==(const Held&) const = default;
  /// All of `others` are held, and perhaps more.
  bool hold(const Held& others) const {
    return (shift || !others.shift) && (ctrl || !others.ctrl) && (alt || !others.alt);
  }
};

/// By what is printed on them. `plus` is also the unshifted "=" that shares its key on many keyboards.
enum class DeskKey {
  a,
  b,
  c,
  d,
  e,
  f,
  g,
  h,
  i,
  j,
  k,
  l,
  m,
  n,
  o,
  p,
  q,
  r,
  s,
  t,
  u,
  v,
  w,
  x,
  y,
  z,  // clang-format off
  digit0, digit1, digit2, digit3, digit4, digit5, digit6, digit7, digit8, digit9,
  f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12,
  escape, enter, tab, space, backspace, del, home, end, left, right, up, down,
  plus, minus, left_bracket, right_bracket, comma, period  // clang-format on
};
inline constexpr int desk_keys = static_cast<int>(DeskKey::period) + 1;

/// "B", "F1", "Delete": what a list of keys says.
std::string name_of(DeskKey key);
/// "Ctrl+Shift+"; empty for none.
std::string name_of(const Held& held);

struct PointerDown {
  Point<2> at = Point<2>::Zero();  ///< scene units
  PointerButton button = PointerButton::left;
  Held held = {};
  int clicks = 1;  ///< 2 for the second press of a double click
};
struct PointerMoved {
  Point<2> at = Point<2>::Zero();
  Held held = {};
};
struct PointerUp {
  Point<2> at = Point<2>::Zero();
  PointerButton button = PointerButton::left;
  Held held = {};
};
struct WheelTurned {
  Point<2> at = Point<2>::Zero();
  double up = 0;     ///< notches away from the user; touchpads give fractions
  double right = 0;  ///< notches to the right
  Held held = {};
};
struct KeyDown {
  DeskKey key = DeskKey::escape;
  Held held = {};
  bool repeat = false;  ///< it has been down for a while
};
struct KeyUp {
  DeskKey key = DeskKey::escape;
};
/// The window no longer hears of the pointer and the keys. What is in hand is let go where it is.
struct FocusLost {};

using DeskEvent = std::variant<PointerDown, PointerMoved, PointerUp, WheelTurned, KeyDown, KeyUp, FocusLost>;

}  // namespace seesaw
