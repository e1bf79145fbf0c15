// Words, layout and pictures: what is only looked at, or not a value.

#include <imgui.h>

#include <algorithm>

#include "core/window/imgui_input.h"
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

std::string shortened(const std::string& words, double width) {
  if (text_width(words) <= width) return words;
  // Where letters begin, and the end.
  std::vector<std::size_t> letters;
  for (std::size_t i = 0; i < words.size(); ++i)
    if ((static_cast<unsigned char>(words[i]) & 0xC0) != 0x80) letters.push_back(i);
  const std::size_t count = letters.size();
  letters.push_back(words.size());
  // A third of what is left is the end: it tells names of one family apart, and has a file's ending.
  const auto with = [&](std::size_t kept) {
    const std::size_t tail = kept / 3, head = kept - tail;
    return words.substr(0, letters[head]) + "…" + words.substr(letters[count - tail]);
  };
  std::size_t fits = 0, too_many = count;
  while (too_many - fits > 1) {
    const std::size_t middle = (fits + too_many) / 2;
    (text_width(with(middle)) <= width ? fits : too_many) = middle;
  }
  return with(fits);
}

void same_line(double gap) { ImGui::SameLine(0, static_cast<float>(gap)); }
void separator() { ImGui::Separator(); }
void gap(double height) { ImGui::Dummy({0, static_cast<float>(height)}); }
double width_left() { return static_cast<double>(ImGui::GetContentRegionAvail().x); }
double height_left() { return static_cast<double>(ImGui::GetContentRegionAvail().y); }
double line_height() { return static_cast<double>(ImGui::GetFrameHeightWithSpacing()); }
double scale() { return ui_state().scale; }
void flush_right(double width) {
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + static_cast<float>(std::max(0.0, width_left() - width)));
}
double button_width(const std::string& label) {
  return text_width(detail::visible_part(label)) + 2 * static_cast<double>(ImGui::GetStyle().FramePadding.x);
}
double buttons_width(const std::vector<std::string>& labels) {
  double sum = 0;
  for (const std::string& label : labels)
    sum += button_width(label) + (sum > 0 ? static_cast<double>(ImGui::GetStyle().ItemSpacing.x) : 0);
  return sum;
}
double window_width() { return static_cast<double>(ImGui::GetIO().DisplaySize.x); }
double window_height() { return static_cast<double>(ImGui::GetIO().DisplaySize.y); }

Rect last_place() {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  return {low.x, low.y, high.x - low.x, high.y - low.y};
}
bool last_hovered() { return ImGui::IsItemHovered(); }
void focus_next() { ImGui::SetKeyboardFocusHere(); }
bool key_pressed(Key key, bool repeat) { return detail::pressed_now(key, repeat); }

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
