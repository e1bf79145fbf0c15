// The names of keys.

#include <algorithm>
#include <array>
#include <cctype>

#include "core/base/check.h"
#include "core/window/input.h"

namespace seesaw {

namespace {

struct KeyNames {
  std::string_view script;  // lower case
  std::string_view label;   // as printed on it
};

constexpr std::array<KeyNames, key_count> key_names = {{
    {"a", "A"},
    {"b", "B"},
    {"c", "C"},
    {"d", "D"},
    {"e", "E"},
    {"f", "F"},
    {"g", "G"},
    {"h", "H"},
    {"i", "I"},
    {"j", "J"},
    {"k", "K"},
    {"l", "L"},
    {"m", "M"},
    {"n", "N"},
    {"o", "O"},
    {"p", "P"},
    {"q", "Q"},
    {"r", "R"},
    {"s", "S"},
    {"t", "T"},
    {"u", "U"},
    {"v", "V"},
    {"w", "W"},
    {"x", "X"},
    {"y", "Y"},
    {"z", "Z"},
    {"0", "0"},
    {"1", "1"},
    {"2", "2"},
    {"3", "3"},
    {"4", "4"},
    {"5", "5"},
    {"6", "6"},
    {"7", "7"},
    {"8", "8"},
    {"9", "9"},
    {"f1", "F1"},
    {"f2", "F2"},
    {"f3", "F3"},
    {"f4", "F4"},
    {"f5", "F5"},
    {"f6", "F6"},
    {"f7", "F7"},
    {"f8", "F8"},
    {"f9", "F9"},
    {"f10", "F10"},
    {"f11", "F11"},
    {"f12", "F12"},
    {"escape", "Esc"},
    {"enter", "Enter"},
    {"tab", "Tab"},
    {"space", "Space"},
    {"backspace", "Backspace"},
    {"del", "Delete"},
    {"home", "Home"},
    {"end", "End"},
    {"left", "Left"},
    {"right", "Right"},
    {"up", "Up"},
    {"down", "Down"},
    {"plus", "+"},
    {"minus", "-"},
    {"left_bracket", "["},
    {"right_bracket", "]"},
    {"comma", ","},
    {"period", "."},
    {"page_up", "Page Up"},
    {"page_down", "Page Down"},
    {"insert", "Insert"},
    {"slash", "/"},
    {"semicolon", ";"},
    {"apostrophe", "'"},
    {"backslash", "\\"},
    {"grave", "`"},
    {"shift", "Shift"},
    {"ctrl", "Ctrl"},
    {"alt", "Alt"},
}};

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

const KeyNames& names_of(Key key) {
  const auto index = static_cast<std::size_t>(key);
  SEESAW_CHECK_LT(index, key_names.size());
  return key_names[index];
}

}  // namespace

std::string_view name_of(Key key) { return names_of(key).script; }

std::optional<Key> key_named(std::string_view name) {
  const std::string wanted = lower_case(name);
  if (wanted == "=") return Key::plus;
  if (wanted == "return") return Key::enter;
  for (std::size_t i = 0; i < key_names.size(); ++i)
    if (wanted == key_names[i].script || wanted == lower_case(key_names[i].label)) return static_cast<Key>(i);
  return std::nullopt;
}

std::optional<KeyChord> chord_named(std::string_view text) {
  KeyChord chord;
  for (;;) {
    // The last character may itself be the plus key's.
    const std::size_t plus = text.find('+');
    if (plus == std::string_view::npos || plus + 1 >= text.size()) break;
    const std::string part = lower_case(text.substr(0, plus));
    bool* const held = part == "shift"  ? &chord.modifiers.shift
                       : part == "ctrl" ? &chord.modifiers.ctrl
                       : part == "alt"  ? &chord.modifiers.alt
                                        : nullptr;
    if (!held || *held) return std::nullopt;
    *held = true;
    text.remove_prefix(plus + 1);
  }
  const auto key = key_named(text);
  if (!key) return std::nullopt;
  chord.key = *key;
  return chord;
}

std::string label_of(const KeyChord& chord) {
  std::string text;
  if (chord.modifiers.ctrl) text += "Ctrl+";
  if (chord.modifiers.shift) text += "Shift+";
  if (chord.modifiers.alt) text += "Alt+";
  return text.append(names_of(chord.key).label);
}

}  // namespace seesaw
