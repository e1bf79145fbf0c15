// Words, layout and pictures: what is only looked at, or not a value.

#include <imgui.h>

#include <algorithm>

#include "core/window/ui.h"
#include "core/window/ui_state.h"

namespace seesaw::ui {

using detail::ui_state;

namespace {

ImVec4 word_color(const Color& c) {
  return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b), static_cast<float>(c.a)};
}

void words_of(const std::string& words) { ImGui::TextUnformatted(words.data(), words.data() + words.size()); }

void words_in(ImFont* font, const std::string& words) {
  ImGui::PushFont(font);
  words_of(words);
  ImGui::PopFont();
}

#if IMGUI_VERSION_NUM >= 19000
ImTextureID id_of(const Texture& texture) { return (ImTextureID)(intptr_t)texture.name(); }
#else
ImTextureID id_of(const Texture& texture) {
  return reinterpret_cast<void*>(static_cast<std::uintptr_t>(texture.name()));
}
#endif

ImVec2 first_corner(const Texture& texture) { return {0, texture.bottom_up() ? 1.0f : 0.0f}; }
ImVec2 last_corner(const Texture& texture) { return {1, texture.bottom_up() ? 0.0f : 1.0f}; }

}  // namespace

void text(const std::string& words) { words_of(words); }
void paragraph(const std::string& words) {
  ImGui::PushTextWrapPos(0);
  words_of(words);
  ImGui::PopTextWrapPos();
}
void soft_text(const std::string& words) { colored_text(words, colors().soft_ink); }
void bold_text(const std::string& words) { words_in(ui_state().fonts.bold, words); }
void heading(const std::string& words) { words_in(ui_state().fonts.heading, words); }
void colored_text(const std::string& words, const Color& color) {
  ImGui::PushStyleColor(ImGuiCol_Text, word_color(color));
  paragraph(words);
  ImGui::PopStyleColor();
}

void fact(const std::string& name, const std::string& value) {
  ImGui::PushStyleColor(ImGuiCol_Text, word_color(colors().soft_ink));
  words_of(name);
  ImGui::PopStyleColor();
  const double width = text_width(value);
  ImGui::SameLine();
  const double free = width_left();
  if (free > width) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + static_cast<float>(free - width));
  words_of(value);
}

void progress(double fraction, const std::string& words) {
  ImGui::ProgressBar(static_cast<float>(std::clamp(fraction, 0.0, 1.0)), {-1, 0}, words.c_str());
}

void tooltip(const std::string& words) {
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(static_cast<float>(340 * scale()));
  words_of(words);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

double text_width(const std::string& words) {
  return static_cast<double>(ImGui::CalcTextSize(words.data(), words.data() + words.size()).x);
}

void same_line(double gap) { ImGui::SameLine(0, static_cast<float>(gap)); }
void separator() { ImGui::Separator(); }
void gap(double height) { ImGui::Dummy({0, static_cast<float>(height)}); }
double width_left() { return static_cast<double>(ImGui::GetContentRegionAvail().x); }
double height_left() { return static_cast<double>(ImGui::GetContentRegionAvail().y); }
double line_height() { return static_cast<double>(ImGui::GetFrameHeightWithSpacing()); }
double scale() { return ui_state().scale; }

Rect last_place() {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  return {low.x, low.y, high.x - low.x, high.y - low.y};
}
bool last_hovered() { return ImGui::IsItemHovered(); }
void focus_next() { ImGui::SetKeyboardFocusHere(); }

void background(const Texture& texture, const Rect& rect) {
  if (texture.empty()) return;
  ImGui::GetBackgroundDrawList()->AddImage(
      id_of(texture), {static_cast<float>(rect.left()), static_cast<float>(rect.top())},
      {static_cast<float>(rect.right()), static_cast<float>(rect.bottom())}, first_corner(texture),
      last_corner(texture));
}

PictureUse picture(const std::string& label, const Texture& texture, double width, double height) {
  const ImVec2 size(static_cast<float>(std::max(1.0, width)), static_cast<float>(std::max(1.0, height)));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton(label.c_str(), size,
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  detail::note_item(label);
  if (!texture.empty())
    ImGui::GetWindowDrawList()->AddImage(id_of(texture), at, {at.x + size.x, at.y + size.y},
                                         first_corner(texture), last_corner(texture));
  const ImGuiIO& io = ImGui::GetIO();
  PictureUse use;
  use.place = last_place();
  use.hovered = ImGui::IsItemHovered();
  use.held = ImGui::IsItemActive();
  if (use.held) {
    while (use.button < 2 && !ImGui::IsMouseDown(use.button)) ++use.button;
    // The frame of the press comes with the way to it.
    if (!ImGui::IsItemActivated()) {
      use.dx = static_cast<double>(io.MouseDelta.x);
      use.dy = static_cast<double>(io.MouseDelta.y);
    }
  }
  if (use.hovered) {
    use.wheel = static_cast<double>(io.MouseWheel);
    use.double_clicked = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
  }
  use.x = static_cast<double>(io.MousePos.x - at.x);
  use.y = static_cast<double>(io.MousePos.y - at.y);
  return use;
}

void pointer(Pointer look) {
  const ImGuiMouseCursor cursor = look == Pointer::hand        ? ImGuiMouseCursor_Hand
                                  : look == Pointer::move      ? ImGuiMouseCursor_ResizeAll
                                  : look == Pointer::text      ? ImGuiMouseCursor_TextInput
                                  : look == Pointer::forbidden ? ImGuiMouseCursor_NotAllowed
                                  : look == Pointer::across    ? ImGuiMouseCursor_ResizeEW
                                  : look == Pointer::down      ? ImGuiMouseCursor_ResizeNS
                                                               : ImGuiMouseCursor_Arrow;
  ImGui::SetMouseCursor(cursor);
}

UiColors colors() { return ui_colors(ui_state().dark); }

}  // namespace seesaw::ui
