#include "sandbox2d/menus.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/window/ui.h"

namespace seesaw {

namespace {

using C = DeskCommand;

class Menus {
 public:
  Menus(Desk& desk, const MenuState& state, const MenuActions& actions)
      : desk_(desk), state_(state), actions_(actions) {}

  void draw() {
    const auto bar = ui::menu_bar();
    if (!bar) return;
    file();
    edit();
    constraints();
    view();
    help();
  }

 private:
  void item(const char* label, C command, bool enabled = true) {
    if (ui::menu_item(label, keys_of(command), enabled)) actions_.act(command);
  }
  void item_switch(const char* label, C command, bool on) {
    if (ui::menu_switch(label, on, keys_of(command))) actions_.act(command);
  }

  void file() {
    const auto menu = ui::menu("File");
    if (!menu) return;
    item("New", C::new_document);
    item("Open\u2026", C::open);
    if (const auto recent = ui::menu("Open recent", !state_.recent.list().empty())) {
      const auto paths = state_.recent.list();  // opening one changes the list
      for (const auto& path : paths)
        if (ui::menu_item(path.string())) actions_.open(path);
    }
    item("Figures\u2026", C::gallery);
    ui::separator();
    item("Save", C::save);
    item("Save as\u2026", C::save_as);
    item("Export\u2026", C::export_picture);
    item("Export the window\u2026", C::export_window);
    ui::separator();
    item(desk_.recording() ? "Stop recording\u2026" : "Record a session", C::record);
    item("Replay a session\u2026", C::replay);
    ui::separator();
    item("Quit", C::quit);
  }

  void edit() {
    const auto menu = ui::menu("Edit");
    if (!menu) return;
    item("Undo", C::undo, desk_.editor().undo_size() > 0);
    item("Redo", C::redo, desk_.editor().redo_size() > 0);
    ui::separator();
    const bool any = !desk_.selection().empty();
    item("Cut", C::cut, any);
    item("Copy", C::copy);
    item("Paste", C::paste);
    item("Duplicate", C::duplicate, any);
    item("Delete", C::delete_selection, any);
    ui::separator();
    item("Copy the scene", C::copy_scene);
    item("Paste a scene", C::paste_scene);
    ui::separator();
    item("Type numbers\u2026", C::edit_values, any);
    ui::separator();
    item("Select all", C::select_all);
    item("Select none", C::select_none);
    item("Select boundary", C::select_boundary);
    item("Select interior", C::select_interior);
    item("Select exterior", C::select_exterior);
    item("Select those with a normal", C::select_normals);
    item("Select the culprits", C::select_culprits, desk_.shape().impossible.has_value());
  }

  void constraints() {
    const auto menu = ui::menu("Constraints");
    if (!menu) return;
    const bool any = !desk_.selection().empty();
    item("Make boundary", C::make_boundary, any);
    item("Make interior", C::make_interior, any);
    item("Make exterior", C::make_exterior, any);
    ui::separator();
    item("Add normals", C::add_normals, any);
    item("Remove normals", C::remove_normals, any);
    ui::separator();
    item("Raise the value", C::raise_value, any);
    item("Lower the value", C::lower_value, any);
    ui::separator();
    item("Cage of exterior constraints", C::cage);
  }

  void view() {
    const auto menu = ui::menu("View");
    if (!menu) return;
    const Display<2>& display = desk_.display();
    item("Show everything", C::fit);
    item("Zoom in", C::zoom_in);
    item("Zoom out", C::zoom_out);
    ui::separator();
    item_switch("Field", C::toggle_field, display.field);
    item_switch("Isolines", C::toggle_isolines, display.isolines);
    item_switch("Gradient", C::toggle_gradient, display.gradient);
    item_switch("Constraint marks", C::toggle_constraints, display.constraints);
    item_switch("Normals", C::toggle_normals, display.normals);
    item_switch("Weights", C::toggle_weights, state_.shown.weights);
    item_switch("Grid lines", C::toggle_grid, display.grid);
    item_switch("Scale bar", C::toggle_scale_bar, display.scale_bar);
    item_switch("Snap to grid", C::toggle_snap, desk_.grid().on);
    ui::separator();
    item_switch("See-saw plate", C::toggle_plate, state_.shown.plate);
    item_switch("Profile line", C::toggle_profile, desk_.profile().has_value());
    item("Remember as \"before\"", C::remember);
    item_switch("Compare with \"before\"", C::compare, desk_.other_name() == "before");
    item("Compare kernels", C::compare_kernels);
    ui::separator();
    item_switch("Panels", C::toggle_panels, state_.panels);
    item_switch("Dark", C::toggle_dark, state_.dark);
    item("Larger letters", C::larger_letters);
    item("Smaller letters", C::smaller_letters);
    item_switch("Full screen", C::full_screen, state_.full_screen);
  }

  void help() {
    const auto menu = ui::menu("Help");
    if (!menu) return;
    item("Keys and gestures", C::help);
    item("Guided tour", C::tour);
  }

  Desk& desk_;
  const MenuState& state_;
  const MenuActions& actions_;
};

}  // namespace

void draw_menu_bar(Desk& desk, const MenuState& state, const MenuActions& actions) {
  Menus(desk, state, actions).draw();
}

void draw_tools(const Rect& place, Desk& desk, const std::function<void(DeskCommand)>& act) {
  const auto panel = ui::panel("Tools", place, {.title = false});
  if (!panel) return;
  for (const ToolInfo& each : tool_infos()) {
    const auto command = static_cast<C>(static_cast<int>(each.tool));
    const std::string label = capitalized(each.name) + "  " + keys_of(command) + "##" + each.name;
    if (ui::tool_button(label, desk.tool() == each.tool, ui::width_left())) act(command);
    if (ui::last_hovered()) ui::tooltip(each.hint);
  }
  if (desk.tool() == Tool::line || desk.tool() == Tool::circle) {
    ui::separator();
    int count = desk.count();
    ui::soft_text("how many");
    const auto width = ui::item_width(ui::width_left());
    if (ui::slider("##count", count, 1, 40)) desk.set_count(count);
  }
  ui::separator();
  {
    const auto off = ui::disabled(desk.editor().undo_size() == 0);
    if (ui::button("Undo", ui::width_left())) act(C::undo);
    if (const char* name = desk.editor().undo_name(); name && ui::last_hovered())
      ui::tooltip(std::string(in_words(name)));
  }
  {
    const auto off = ui::disabled(desk.editor().redo_size() == 0);
    if (ui::button("Redo", ui::width_left())) act(C::redo);
    if (const char* name = desk.editor().redo_name(); name && ui::last_hovered())
      ui::tooltip(std::string(in_words(name)));
  }
  if (ui::button("Cage  K##cage", ui::width_left())) act(C::cage);
  if (ui::last_hovered()) ui::tooltip("eight exterior constraints around everything");
  if (ui::button("Show all  F##fit", ui::width_left())) act(C::fit);
  ui::separator();
  if (ui::button("Figures  F2##gallery", ui::width_left())) act(C::gallery);
  if (ui::button("Tour  F3##tour", ui::width_left())) act(C::tour);
  if (ui::button("Keys  F1##help", ui::width_left())) act(C::help);
}

}  // namespace seesaw
