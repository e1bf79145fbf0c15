// Buttons, sliders, fields: widgets that something can be done to.

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "core/window/imgui_input.h"
#include "core/window/ui.h"
#include "core/window/ui_state.h"

namespace seesaw::ui {

using detail::note_item;

namespace {

ImVec4 button_color(const Color& c) {
  return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b), static_cast<float>(c.a)};
}

bool plain_button(const std::string& label, double width) {
  const bool pressed = ImGui::Button(label.c_str(), {static_cast<float>(width), 0});
  note_item(label);
  return pressed;
}

bool filled_button(const std::string& label, double width) {
  const UiColors c = colors();
  const Color letters = lab_of(c.accent).L > 60 ? hex("#10151A") : hex("#FFFFFF");
  ImGui::PushStyleColor(ImGuiCol_Button, button_color(c.accent));
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, button_color(mix(c.accent, c.ink, 0.15)));
  ImGui::PushStyleColor(ImGuiCol_ButtonActive, button_color(mix(c.accent, c.ink, 0.3)));
  ImGui::PushStyleColor(ImGuiCol_Text, button_color(letters));
  const bool pressed = plain_button(label, width);
  ImGui::PopStyleColor(4);
  return pressed;
}

Edit edit_of_last(const std::string& label, bool changed) {
  note_item(label);
  return {changed, ImGui::IsItemActivated(), ImGui::IsItemDeactivatedAfterEdit()};
}

// A comma is how half the world writes the point; dropped in silence it would make 0,9 a nine. Lives around
// the widget that a number may be typed into.
class PointForComma {
 public:
  explicit PointForComma(const std::string& label) : id_(ImGui::GetID(label.c_str())) {
    if (detail::ui_state().in_hand != id_) return;
    for (ImWchar& letter : ImGui::GetIO().InputQueueCharacters)
      if (letter == ',') letter = '.';
  }
  ~PointForComma() {
    ImGuiID& in_hand = detail::ui_state().in_hand;
    if (ImGui::IsItemActive())
      in_hand = id_;
    else if (in_hand == id_)
      in_hand = 0;
  }
  PointForComma(const PointForComma&) = delete;
  PointForComma& operator=(const PointForComma&) = delete;

 private:
  ImGuiID id_;
};

}  // namespace

bool button(const std::string& label, double width) { return plain_button(label, width); }
bool main_button(const std::string& label, double width) {
  const bool pressed = filled_button(label, width);
  // A text field lets go of Enter in the frame in which it is pressed.
  return pressed || (detail::ui_state().dialogs > 0 && foremost() && detail::pressed_now(Key::enter) &&
                     !ImGui::IsAnyItemActive());
}
bool tool_button(const std::string& label, bool on, double width) {
  return on ? filled_button(label, width) : plain_button(label, width);
}

bool checkbox(const std::string& label, bool& on) {
  const bool changed = ImGui::Checkbox(label.c_str(), &on);
  note_item(label);
  return changed;
}

bool radio(const std::string& label, bool on) {
  const bool pressed = ImGui::RadioButton(label.c_str(), on);
  note_item(label);
  return pressed;
}

bool list_item(const std::string& label, bool chosen) {
  const bool pressed = ImGui::Selectable(label.c_str(), chosen, ImGuiSelectableFlags_DontClosePopups);
  note_item(label);
  return pressed;
}

Edit slider(const std::string& label, double& value, double least, double most,
            const SliderOptions& options) {
  // What is typed (ctrl-click) stays within; what the program gave stays as it is until it is touched.
  const int flags = (options.typed_beyond ? 0 : ImGuiSliderFlags_AlwaysClamp) |
                    (options.logarithmic ? ImGuiSliderFlags_Logarithmic : 0) |
                    ImGuiSliderFlags_NoRoundToFormat;
  const PointForComma typed(label);
  const bool changed =
      ImGui::SliderScalar(label.c_str(), ImGuiDataType_Double, &value, &least, &most, options.format, flags);
  return edit_of_last(label, changed);
}

Edit slider(const std::string& label, int& value, int least, int most) {
  const bool changed =
      ImGui::SliderInt(label.c_str(), &value, least, most, "%d", ImGuiSliderFlags_AlwaysClamp);
  return edit_of_last(label, changed);
}

Edit number(const std::string& label, double& value, double step, const char* format) {
  // Dear ImGui changes the value with every letter that is typed; half a number is none.
  double typed = value;
  auto& all_typed = detail::ui_state().typed;
  const ImGuiID id = ImGui::GetID(label.c_str());
  const PointForComma point(label);
  ImGui::InputScalar(label.c_str(), ImGuiDataType_Double, &typed, step > 0 ? &step : nullptr, nullptr, format,
                     ImGuiInputTextFlags_CharsScientific);
  Edit edit = edit_of_last(label, false);
  // Where Tab or a press takes the caret to another field, this one forgets what was typed before it says so.
  if (ImGui::IsItemActive()) {
    all_typed[id] = typed;
  } else if (const auto had = all_typed.extract(id)) {
    if (edit.ended && typed == value && !detail::pressed_now(Key::escape)) typed = had.mapped();
  }
  if (typed != value && (edit.ended || (step > 0 && !ImGui::GetIO().WantTextInput))) {
    value = typed;
    edit.changed = true;
  }
  return edit;
}

Edit drag_number(const std::string& label, double& value, double speed, const char* format) {
  const PointForComma typed(label);
  const bool changed =
      ImGui::DragScalar(label.c_str(), ImGuiDataType_Double, &value, static_cast<float>(speed), nullptr,
                        nullptr, format, ImGuiSliderFlags_NoRoundToFormat);
  return edit_of_last(label, changed);
}

Edit text_field(const std::string& label, std::string& text, const std::string& hint) {
  const bool changed = ImGui::InputTextWithHint(label.c_str(), hint.c_str(), &text);
  return edit_of_last(detail::visible_part(label).empty() ? hint : label, changed);
}

Edit text_area(const std::string& label, std::string& text, double width, double height) {
  const bool changed = ImGui::InputTextMultiline(label.c_str(), &text,
                                                 {static_cast<float>(width), static_cast<float>(height)});
  return edit_of_last(label, changed);
}

Edit choice(const std::string& label, int& chosen, const std::vector<std::string>& names) {
  const bool known = chosen >= 0 && chosen < static_cast<int>(names.size());
  const std::string shown = known ? names[static_cast<std::size_t>(chosen)] : "";
  const bool open = ImGui::BeginCombo(label.c_str(), shown.c_str());
  Edit edit;
  if (!open) {
    note_item(detail::visible_part(label).empty() ? shown : label);
    return edit;
  }
  if (detail::pressed_now(Key::escape)) ImGui::CloseCurrentPopup();
  for (int i = 0; i < static_cast<int>(names.size()); ++i) {
    const std::string& name = names[static_cast<std::size_t>(i)];
    ImGui::PushID(i);
    if (ImGui::Selectable(name.c_str(), i == chosen)) {
      edit.began = edit.changed = edit.ended = i != chosen;
      chosen = i;
    }
    note_item(name);
    if (i == chosen) ImGui::SetItemDefaultFocus();
    ImGui::PopID();
  }
  ImGui::EndCombo();
  return edit;
}

}  // namespace seesaw::ui
