// Lists with many lines.

#include <imgui.h>

#include <algorithm>

#include "core/window/ui.h"
#include "core/window/ui_state.h"

namespace seesaw::ui {

namespace {

ImU32 ink_of(const Color& c) {
  return ImGui::ColorConvertFloat4ToU32(
      {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b), static_cast<float>(c.a)});
}

void words_at(double x, double y, const Color& color, const std::string& words) {
  ImGui::GetWindowDrawList()->AddText({static_cast<float>(x), static_cast<float>(y)}, ink_of(color),
                                      words.data(), words.data() + words.size());
}

}  // namespace

RowUse list_row(const std::string& label, bool chosen, const std::vector<RowFact>& facts,
                const std::string& mark) {
  constexpr int flags = ImGuiSelectableFlags_DontClosePopups | ImGuiSelectableFlags_AllowDoubleClick;
  RowUse use;
  use.clicked = ImGui::Selectable("##row", chosen, flags);
  use.double_clicked = use.clicked && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
  // Not by note_item, which takes "##" for the end of what is shown.
  const Rect place = last_place();
  detail::UiState& state = detail::ui_state();
  if (ImGui::IsItemVisible())
    state.items.push_back({state.panels.empty() ? std::string() : state.panels.back(), label, place});

  const UiColors c = colors();
  const ImGuiStyle& style = ImGui::GetStyle();
  const double space = static_cast<double>(style.ItemSpacing.x);
  const double y = place.top() + (place.height - static_cast<double>(ImGui::GetTextLineHeight())) / 2;
  double right = place.right() - space / 2;
  for (auto fact = facts.rbegin(); fact != facts.rend(); ++fact) {
    words_at(right - text_width(fact->words), y, c.soft_ink, fact->words);
    right -= fact->width + space;
  }
  double left = place.left() + space / 2;
  if (!mark.empty()) {
    words_at(left, y, c.accent, mark);
    // Marks differ in width, labels stand below one another.
    left += 1.3 * static_cast<double>(ImGui::GetFontSize());
  }
  words_at(left, y, c.ink, shortened(label, right - left));
  return use;
}

void long_list(Index count, const std::function<void(Index)>& draw_row, Index show) {
  const float top = ImGui::GetCursorPosY();
  const float height = ImGui::GetTextLineHeightWithSpacing();
  if (show >= 0 && show < count) {
    const float low = top + height * static_cast<float>(show), room = ImGui::GetWindowHeight();
    const float margin = ImGui::GetStyle().WindowPadding.y;
    const float scroll = ImGui::GetScrollY();
    if (low - margin < scroll) ImGui::SetScrollY(low - margin);
    if (low + height + margin > scroll + room) ImGui::SetScrollY(low + height + margin - room);
  }
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(std::min<Index>(count, 1'000'000)), height);
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      ImGui::PushID(i);
      draw_row(i);
      ImGui::PopID();
    }
}

}  // namespace seesaw::ui
