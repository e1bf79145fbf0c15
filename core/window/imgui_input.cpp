#include "core/window/imgui_input.h"

#include <imgui.h>

#include <algorithm>
#include <cfloat>

namespace seesaw::detail {

namespace {

constexpr std::pair<Key, int> imgui_keys[] = {
    {Key::tab, ImGuiKey_Tab},
    {Key::left, ImGuiKey_LeftArrow},
    {Key::right, ImGuiKey_RightArrow},
    {Key::up, ImGuiKey_UpArrow},
    {Key::down, ImGuiKey_DownArrow},
    {Key::page_up, ImGuiKey_PageUp},
    {Key::page_down, ImGuiKey_PageDown},
    {Key::home, ImGuiKey_Home},
    {Key::end, ImGuiKey_End},
    {Key::insert, ImGuiKey_Insert},
    {Key::del, ImGuiKey_Delete},
    {Key::backspace, ImGuiKey_Backspace},
    {Key::space, ImGuiKey_Space},
    {Key::enter, ImGuiKey_Enter},
    {Key::escape, ImGuiKey_Escape},
    {Key::a, ImGuiKey_A},
    {Key::c, ImGuiKey_C},
    {Key::v, ImGuiKey_V},
    {Key::x, ImGuiKey_X},
    {Key::y, ImGuiKey_Y},
    {Key::z, ImGuiKey_Z},
};

int imgui_button(MouseButton button) {
  return button == MouseButton::left    ? ImGuiMouseButton_Left
         : button == MouseButton::right ? ImGuiMouseButton_Right
                                        : ImGuiMouseButton_Middle;
}

#if IMGUI_VERSION_NUM >= 18700

void mouse_at(float x, float y) { ImGui::GetIO().AddMousePosEvent(x, y); }
void mouse_button(int button, bool down) { ImGui::GetIO().AddMouseButtonEvent(button, down); }
void mouse_wheel(float right, float up) { ImGui::GetIO().AddMouseWheelEvent(right, up); }
void key(Key which, bool down) {
  for (const auto& [ours, theirs] : imgui_keys)
    if (ours == which) ImGui::GetIO().AddKeyEvent(static_cast<ImGuiKey>(theirs), down);
}
void held(const Modifiers& m) {
  ImGui::GetIO().AddKeyEvent(ImGuiMod_Ctrl, m.ctrl);
  ImGui::GetIO().AddKeyEvent(ImGuiMod_Shift, m.shift);
  ImGui::GetIO().AddKeyEvent(ImGuiMod_Alt, m.alt);
}
void start() {
  // Our frames are already cut so that none needs to be cut further (input_queue.h).
  ImGui::GetIO().ConfigInputTrickleEventQueue = false;
}

#else

void mouse_at(float x, float y) { ImGui::GetIO().MousePos = {x, y}; }
void mouse_button(int button, bool down) { ImGui::GetIO().MouseDown[button] = down; }
void mouse_wheel(float right, float up) {
  ImGui::GetIO().MouseWheelH += right;
  ImGui::GetIO().MouseWheel += up;
}
void key(Key which, bool down) { ImGui::GetIO().KeysDown[static_cast<int>(which)] = down; }
void held(const Modifiers& m) {
  ImGuiIO& io = ImGui::GetIO();
  io.KeyCtrl = m.ctrl;
  io.KeyShift = m.shift;
  io.KeyAlt = m.alt;
}
void start() {
  for (const auto& [ours, theirs] : imgui_keys) ImGui::GetIO().KeyMap[theirs] = static_cast<int>(ours);
}

#endif

void mouse_at(const Point<2>& at, const Modifiers& modifiers) {
  mouse_at(static_cast<float>(at.x()), static_cast<float>(at.y()));
  held(modifiers);
}

struct Tell {
  void operator()(const MouseMoved& e) const { mouse_at(e.at, e.modifiers); }
  void operator()(const MousePressed& e) const {
    mouse_at(e.at, e.modifiers);
    mouse_button(imgui_button(e.button), true);
  }
  void operator()(const MouseReleased& e) const {
    mouse_at(e.at, e.modifiers);
    mouse_button(imgui_button(e.button), false);
  }
  void operator()(const WheelMoved& e) const {
    mouse_wheel(static_cast<float>(e.right), static_cast<float>(e.up));
    held(e.modifiers);
  }
  void operator()(const KeyPressed& e) const {
    held(e.modifiers);
    key(e.key, true);
  }
  void operator()(const KeyReleased& e) const {
    held(e.modifiers);
    key(e.key, false);
  }
  void operator()(const TextTyped& e) const { ImGui::GetIO().AddInputCharactersUTF8(e.text.c_str()); }
  void operator()(const MouseLeft&) const { mouse_at(-FLT_MAX, -FLT_MAX); }
  void operator()(const WindowLeft&) const {
    ImGui::GetIO().AddFocusEvent(false);
    for (int button = 0; button < 3; ++button) mouse_button(button, false);
    for (int k = 0; k < key_count; ++k) key(static_cast<Key>(k), false);
    held({});
  }
  template <class Other>
  void operator()(const Other&) const {}
};

}  // namespace

bool pressed_now(Key which, bool repeat) {
#if IMGUI_VERSION_NUM >= 18700
  for (const auto& [ours, theirs] : imgui_keys)
    if (ours == which) return ImGui::IsKeyPressed(static_cast<ImGuiKey>(theirs), repeat);
  return false;
#else
  return ImGui::IsKeyPressed(static_cast<int>(which), repeat);
#endif
}

void start_imgui_input() { start(); }

void tell_imgui(const InputEvent& event) { std::visit(Tell{}, event); }

bool InputRouter::any(Owner owner) const {
  return std::find(owners_.begin(), owners_.end(), owner) != owners_.end();
}

bool InputRouter::for_ui(const InputEvent& event) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool over_ui = any(Owner::program) ? false : any(Owner::ui) ? true : io.WantCaptureMouse;
  if (const auto* pressed = std::get_if<MousePressed>(&event)) {
    owners_[static_cast<std::size_t>(pressed->button)] = over_ui ? Owner::ui : Owner::program;
    return over_ui;
  }
  if (const auto* released = std::get_if<MouseReleased>(&event)) {
    Owner& owner = owners_[static_cast<std::size_t>(released->button)];
    const bool to_ui = owner == Owner::ui;
    owner = Owner::nobody;
    return to_ui;
  }
  if (std::holds_alternative<MouseMoved>(event) || std::holds_alternative<WheelMoved>(event)) return over_ui;
  if (std::holds_alternative<KeyPressed>(event) || std::holds_alternative<TextTyped>(event))
    return io.WantCaptureKeyboard || io.WantTextInput;
  if (std::holds_alternative<WindowLeft>(event)) owners_ = {};
  return false;
}

}  // namespace seesaw::detail
