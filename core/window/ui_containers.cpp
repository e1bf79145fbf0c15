// Panels, menus, dialogs and what else holds widgets.

#include <imgui.h>

#include "core/window/imgui_input.h"
#include "core/window/ui.h"
#include "core/window/ui_state.h"

namespace seesaw::ui {

using detail::note_item;
using detail::ui_state;

namespace {

ImVec2 vec(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

void enter(const std::string& title) { ui_state().panels.push_back(detail::visible_part(title)); }
void leave() { ui_state().panels.pop_back(); }

Scope open_if(bool open, void (*end)()) { return {open, open ? end : nullptr}; }

}  // namespace

Scope panel(const std::string& title, const Rect& rect, const PanelOptions& options) {
  // One that first appears beside a dialog leaves the keys to it; Dear ImGui 1.86 stops in the very frame in
  // which the dialog opens, if it may take them.
  int flags =
      ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing;
  if (!options.title) flags |= ImGuiWindowFlags_NoTitleBar;
  if (!options.movable)
    flags |= ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoBringToFrontOnFocus;
  if (!options.scrolls) flags |= ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
  const ImGuiCond when = options.movable ? ImGuiCond_Appearing : ImGuiCond_Always;
  ImGui::SetNextWindowPos(vec(rect.x, rect.y), when);
  ImGui::SetNextWindowSize(vec(rect.width, rect.height), when);
  if (!options.padded) ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, vec(0, 0));
  const bool open = ImGui::Begin(title.c_str(), options.open, flags);
  if (!options.padded) ImGui::PopStyleVar();
  enter(title);
  return {open, [] {
            ImGui::End();
            leave();
          }};
}

Scope menu_bar() { return open_if(ImGui::BeginMainMenuBar(), ImGui::EndMainMenuBar); }
double menu_height() { return ImGui::GetFrameHeight(); }

Scope menu(const std::string& label, bool enabled) {
  const bool open = ImGui::BeginMenu(label.c_str(), enabled);
  // While a menu is open its own window is the present one, and the entry in the bar is not the last item.
  if (!open) note_item(label);
  return open_if(open, ImGui::EndMenu);
}

bool menu_item(const std::string& label, const std::string& keys, bool enabled) {
  const bool chosen = ImGui::MenuItem(label.c_str(), keys.empty() ? nullptr : keys.c_str(), false, enabled);
  note_item(label);
  return chosen;
}

bool menu_switch(const std::string& label, bool& on, const std::string& keys) {
  const bool chosen = ImGui::MenuItem(label.c_str(), keys.empty() ? nullptr : keys.c_str(), &on);
  note_item(label);
  return chosen;
}

Scope section(const std::string& label, bool open_at_first) {
  ImGui::PushFont(ui_state().fonts.bold);
  ImGui::PushStyleColor(ImGuiCol_Header, ImGui::GetStyleColorVec4(ImGuiCol_FrameBg));
  const bool open =
      ImGui::CollapsingHeader(label.c_str(), open_at_first ? ImGuiTreeNodeFlags_DefaultOpen : 0);
  ImGui::PopStyleColor();
  ImGui::PopFont();
  note_item(label);
  return {open, nullptr};
}

Scope tabs(const std::string& id) { return open_if(ImGui::BeginTabBar(id.c_str()), ImGui::EndTabBar); }

Scope tab(const std::string& label) {
  const bool open = ImGui::BeginTabItem(label.c_str());
  note_item(label);
  return open_if(open, ImGui::EndTabItem);
}

Scope scroll_area(const std::string& id, double width, double height, bool framed) {
  const bool open = ImGui::BeginChild(id.c_str(), vec(width, height), framed);
  return {open, ImGui::EndChild};
}

Scope table(const std::string& id, const std::vector<std::string>& headers, bool striped,
            const std::vector<double>& weights) {
  const int columns = static_cast<int>(headers.size());
  if (columns == 0) return {false, nullptr};
  const int flags = ImGuiTableFlags_SizingStretchProp | (striped ? ImGuiTableFlags_RowBg : 0);
  if (!ImGui::BeginTable(id.c_str(), columns, flags)) return {false, nullptr};
  bool any = false;
  for (std::size_t i = 0; i < headers.size(); ++i) {
    if (i < weights.size())
      ImGui::TableSetupColumn(headers[i].c_str(), ImGuiTableColumnFlags_WidthStretch,
                              static_cast<float>(weights[i]));
    else
      ImGui::TableSetupColumn(headers[i].c_str());
    any = any || !headers[i].empty();
  }
  if (any) ImGui::TableHeadersRow();
  return {true, ImGui::EndTable};
}

void next_cell() { ImGui::TableNextColumn(); }

Scope disabled(bool off) {
  ImGui::BeginDisabled(off);
  return {true, ImGui::EndDisabled};
}

Scope id(const std::string& name) {
  ImGui::PushID(name.c_str());
  return {true, ImGui::PopID};
}
Scope id(long number) {
  ImGui::PushID(static_cast<int>(number));
  return {true, ImGui::PopID};
}

Scope item_width(double width) {
  ImGui::PushItemWidth(static_cast<float>(width));
  return {true, ImGui::PopItemWidth};
}

// Dear ImGui opens a popup only where it is drawn; a menu's item is elsewhere. So the wish waits for its
// dialog.
void open_dialog(const std::string& title) { ui_state().to_open.push_back(title); }

Scope dialog(const std::string& title, double width, bool escape) {
  if (ui_state().take_to_open(title)) ImGui::OpenPopup(title.c_str());
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(vec(0.5 * static_cast<double>(window.x), 0.45 * static_cast<double>(window.y)),
                          ImGuiCond_Always, vec(0.5, 0.5));
  if (width > 0) ImGui::SetNextWindowSize(vec(width, 0));
  const int flags =
      ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
  if (!ImGui::BeginPopupModal(title.c_str(), nullptr, flags)) return {false, nullptr};
  enter(title);
  ++ui_state().dialogs;
  // Out of a text field first.
  if (escape && detail::pressed_now(Key::escape) && foremost() && !ImGui::IsAnyItemActive())
    ImGui::CloseCurrentPopup();
  return {true, [] {
            ImGui::EndPopup();
            leave();
            --ui_state().dialogs;
          }};
}

void close_dialog() { ImGui::CloseCurrentPopup(); }
bool any_dialog() { return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup); }
// Asks for those above the present one only.
bool foremost() { return !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId); }

void open_popup(const std::string& id) { ui_state().to_open.push_back(id); }
Scope popup(const std::string& id) {
  if (ui_state().take_to_open(id)) ImGui::OpenPopup(id.c_str());
  return open_if(ImGui::BeginPopup(id.c_str()), ImGui::EndPopup);
}

}  // namespace seesaw::ui
