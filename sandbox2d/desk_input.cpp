#include "sandbox2d/desk_input.h"

namespace seesaw {

namespace {

Held held_of(const Modifiers& m) { return {.shift = m.shift, .ctrl = m.ctrl, .alt = m.alt}; }

PointerButton button_of(MouseButton button) {
  switch (button) {
    case MouseButton::middle:
      return PointerButton::middle;
    case MouseButton::right:
      return PointerButton::right;
    case MouseButton::left:
      break;
  }
  return PointerButton::left;
}

// The first keys of a window are those of a desk, in its order.
std::optional<DeskKey> desk_key(Key key) {
  static_assert(static_cast<int>(Key::z) == static_cast<int>(DeskKey::z));
  static_assert(static_cast<int>(Key::f12) == static_cast<int>(DeskKey::f12));
  static_assert(static_cast<int>(Key::down) == static_cast<int>(DeskKey::down));
  static_assert(static_cast<int>(Key::period) == static_cast<int>(DeskKey::period));
  if (static_cast<int>(key) >= desk_keys) return std::nullopt;
  return static_cast<DeskKey>(key);
}

}  // namespace

std::optional<DeskEvent> desk_event(const InputEvent& input, const View2D& view, const Point<2>& origin) {
  const auto scene = [&](const Point<2>& at) { return view.scene_from_pixel(at - origin); };
  if (const auto* moved = std::get_if<MouseMoved>(&input))
    return PointerMoved{scene(moved->at), held_of(moved->modifiers)};
  if (const auto* down = std::get_if<MousePressed>(&input))
    return PointerDown{scene(down->at), button_of(down->button), held_of(down->modifiers), down->clicks};
  if (const auto* up = std::get_if<MouseReleased>(&input))
    return PointerUp{scene(up->at), button_of(up->button), held_of(up->modifiers)};
  if (const auto* wheel = std::get_if<WheelMoved>(&input))
    return WheelTurned{scene(wheel->at), wheel->up, wheel->right, held_of(wheel->modifiers)};
  if (const auto* key = std::get_if<KeyPressed>(&input)) {
    if (const auto known = desk_key(key->key)) return KeyDown{*known, held_of(key->modifiers), key->repeat};
    return std::nullopt;
  }
  if (const auto* key = std::get_if<KeyReleased>(&input)) {
    if (const auto known = desk_key(key->key)) return KeyUp{*known};
    return std::nullopt;
  }
  if (std::holds_alternative<WindowLeft>(input)) return FocusLost{};
  return std::nullopt;
}

}  // namespace seesaw
