// What a person does to a window, as plain data: the pointer, the keys, text, files that are dropped.
//
// Nothing here knows SDL or Dear ImGui, so what understands gestures can be tested with events that are
// written down. Positions are in logical pixels of the window, x to the right, y down from its top left
// corner; on a dense screen one logical pixel is several real ones (Window::pixel_ratio).
//
// Before it: the event loop (core/window/window.h). After it: a program, which turns positions into scene
// units and hands them to core/editing.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "core/base/types.h"

namespace seesaw {

enum class MouseButton { left, middle, right };

/// The modifier keys that are held down. The command key of a Mac counts as ctrl.
struct Modifiers {
  bool shift = false, ctrl = false, alt = false;
  friend bool operator==(const Modifiers&, const Modifiers&) = default;
};

/// Keys by what is printed on them, whatever the keyboard's layout. `plus` is also the "=" that shares its
/// key, `enter` also the one of the number block. The first lines stand in the order of core/editing's keys.
enum class Key {  // clang-format off
  a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z,
  digit0, digit1, digit2, digit3, digit4, digit5, digit6, digit7, digit8, digit9,
  f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12,
  escape, enter, tab, space, backspace, del, home, end, left, right, up, down,
  plus, minus, left_bracket, right_bracket, comma, period,
  page_up, page_down, insert, slash, semicolon, apostrophe, backslash, grave,
  shift, ctrl, alt  // clang-format on
};
inline constexpr int key_count = static_cast<int>(Key::alt) + 1;

/// A key with its modifiers, as a shortcut is written: "ctrl+shift+z".
struct KeyChord {
  Key key = Key::escape;
  Modifiers modifiers = {};
  friend bool operator==(const KeyChord&, const KeyChord&) = default;
};

/// The name by which scripts call a key: "z", "7", "f1", "escape", "page_up", "left_bracket".
std::string_view name_of(Key key);
/// The key of that name, in letters of any case; also "esc", "delete", "return", "[", "]", "+", "-" and the
/// other signs by themselves. Nothing for a name that is no key's.
std::optional<Key> key_named(std::string_view name);
/// "ctrl+shift+z", parts in any order and case, the key last; nothing where it is not one. "ctrl++" is plus.
std::optional<KeyChord> chord_named(std::string_view text);
/// As menus write it: "Ctrl+Shift+Z", "F1", "Delete", "Ctrl++".
std::string label_of(const KeyChord& chord);

struct MouseMoved {
  Point<2> at = Point<2>::Zero();
  Modifiers modifiers = {};
};
struct MousePressed {
  Point<2> at = Point<2>::Zero();
  MouseButton button = MouseButton::left;
  Modifiers modifiers = {};
  int clicks = 1;  ///< 2 for the second press of a double click
};
struct MouseReleased {
  Point<2> at = Point<2>::Zero();
  MouseButton button = MouseButton::left;
  Modifiers modifiers = {};
};
struct WheelMoved {
  Point<2> at = Point<2>::Zero();
  double right = 0;  ///< notches to the right; touchpads give fractions
  double up = 0;     ///< notches away from the user
  Modifiers modifiers = {};
};
struct KeyPressed {
  Key key = Key::escape;
  Modifiers modifiers = {};
  bool repeat = false;  ///< it has been down for a while
  bool is(const KeyChord& chord) const { return key == chord.key && modifiers == chord.modifiers; }
};
struct KeyReleased {
  Key key = Key::escape;
  Modifiers modifiers = {};
};
/// Letters as the keyboard's layout and input method make them, UTF-8.
struct TextTyped {
  std::string text;
};
/// One for each file of a drop.
struct FileDropped {
  std::filesystem::path path;
};
/// The new size in logical pixels.
struct WindowResized {
  int width = 0, height = 0;
};
/// The pointer is outside, with no button held.
struct MouseLeft {};
/// The pointer and the keys are heard no longer: what is in hand should be let go.
struct WindowLeft {};
/// The window's closing button, or the system shuts down. The program decides.
struct CloseAsked {};
/// Nothing happened in the window; another thread called Window::wake.
struct Woken {};

using InputEvent =
    std::variant<MouseMoved, MousePressed, MouseReleased, WheelMoved, KeyPressed, KeyReleased, TextTyped,
                 FileDropped, WindowResized, MouseLeft, WindowLeft, CloseAsked, Woken>;

/// An event, and who should act on it.
struct Input {
  InputEvent event;
  /// A panel, menu or text field takes it: the program should not. A drag belongs to whoever got its press.
  bool for_ui = false;
};

}  // namespace seesaw
