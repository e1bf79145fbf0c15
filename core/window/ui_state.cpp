#include "core/window/ui_state.h"

#include <imgui.h>

#include "core/base/check.h"

namespace seesaw::detail {

UiState& ui_state() {
  const bool there_is_a_window = ImGui::GetCurrentContext() != nullptr;
  SEESAW_CHECK_EQ(there_is_a_window, true);
  return *static_cast<UiState*>(ImGui::GetIO().UserData);
}

std::string visible_part(const std::string& label) { return label.substr(0, label.find("##")); }

void note_item(const std::string& label) {
  if (!ImGui::IsItemVisible()) return;
  UiState& state = ui_state();
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  state.items.push_back({state.panels.empty() ? std::string() : state.panels.back(), visible_part(label),
                         Rect{low.x, low.y, high.x - low.x, high.y - low.y}});
}

const UiState::Item* UiState::find(const std::string& name) const {
  for (auto item = items.rbegin(); item != items.rend(); ++item)
    if (item->label == name || item->panel + "/" + item->label == name) return &*item;
  return nullptr;
}

std::string UiState::names() const {
  std::string text;
  for (const Item& item : items) {
    if (item.label.empty()) continue;
    text += (text.empty() ? "" : ", ") + item.label;
  }
  return text.empty() ? "nothing" : text;
}

}  // namespace seesaw::detail
