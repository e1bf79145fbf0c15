#include "core/editing/desk_bindings.h"

#include <algorithm>

namespace seesaw {

namespace {

constexpr Held with_shift{.shift = true}, with_ctrl{.ctrl = true}, with_alt{.alt = true};
constexpr Held with_ctrl_shift{.shift = true, .ctrl = true}, with_ctrl_alt{.ctrl = true, .alt = true};

constexpr unsigned bit_of(Tool tool) { return 1u << static_cast<int>(tool); }
constexpr unsigned bit_of(Over over) { return 1u << static_cast<int>(over); }
constexpr unsigned any_tool = ~0u;

std::string keys_for(const PointerBinding& row) {
  const char* const button = row.button == PointerButton::left ? row.clicks == 2 ? "double click" : "click"
                             : row.button == PointerButton::middle ? "middle button"
                                                                   : "right button";
  std::string keys = name_of(row.held.value_or(Held{})) + button;
  if (row.clicks == 0 && *row.click == 0 && row.button == PointerButton::left)
    keys.replace(keys.rfind("click"), 5, "drag");
  return *row.where ? keys + " on " + row.where : keys;
}

std::string words_of(const PointerBinding& row) {
  if (*row.click == 0) return row.drag;
  return *row.drag == 0 ? row.click : std::string(row.click) + "; drag: " + row.drag;
}

/// "Tool boundary, interior, exterior"
std::string section_of(const PointerBinding& row) {
  if (row.tools == any_tool) return "Pointer, with any tool";
  std::string names;
  for (const ToolInfo& each : tool_infos())
    if (row.tools & bit_of(each.tool)) names += (names.empty() ? "" : ", ") + std::string(each.name);
  return "Pointer: " + names;
}

}  // namespace

std::span<const KeyBinding> key_bindings() {
  using K = DeskKey;
  using C = DeskCommand;
  constexpr const char *in_tools = "Tools", *in_selection = "Selection", *in_edit = "Edit", *in_view = "View",
                       *in_show = "Show", *in_file = "Document";
  constexpr const char* nudge =
      "nudge the selection by a pixel, or a step of the grid; with none, move the view";
  constexpr const char* nudge_far = "the same, ten times as far";
  static constexpr KeyBinding rows[] = {
      {K::v, {}, C::tool_select, in_tools, "select and move"},
      {K::b, {}, C::tool_boundary, in_tools, "boundary: f = 0, the curve passes here"},
      {K::i, {}, C::tool_interior, in_tools, "interior: f = 1"},
      {K::e, {}, C::tool_exterior, in_tools, "exterior: f = -1"},
      {K::n, {}, C::tool_normal, in_tools, "normal: the way out"},
      {K::l, {}, C::tool_line, in_tools, "a line of constraints"},
      {K::c, {}, C::tool_circle, in_tools, "a circle of constraints"},
      {K::p, {}, C::tool_profile, in_tools, "profile: a line across the curve"},
      {K::h, {}, C::tool_pan, in_tools, "pan"},

      {K::a, with_ctrl, C::select_all, in_selection, "all"},
      {K::a, with_ctrl_shift, C::select_none, in_selection, "none"},
      {K::b, with_shift, C::select_boundary, in_selection, "all boundary constraints"},
      {K::i, with_shift, C::select_interior, in_selection, "all interior constraints"},
      {K::e, with_shift, C::select_exterior, in_selection, "all exterior constraints"},
      {K::n, with_shift, C::select_normals, in_selection, "all constraints with a normal"},
      {K::u, {}, C::select_culprits, in_selection, "the culprits of an impossible set"},
      {K::tab, {}, C::select_next, in_selection, "the next constraint"},
      {K::tab, with_shift, C::select_previous, in_selection, "the one before"},

      {K::escape,
       {},
       C::cancel,
       in_edit,
       "take back what is in hand; else select nothing; else back to the select tool"},
      {K::z, with_ctrl, C::undo, in_edit, "undo"},
      {K::z, with_ctrl_shift, C::redo, in_edit, "redo"},
      {K::y, with_ctrl, C::redo, in_edit, "redo"},
      {K::del, {}, C::delete_selection, in_edit, "delete the selection"},
      {K::backspace, {}, C::delete_selection, in_edit, "delete the selection"},
      {K::n, with_ctrl_shift, C::add_normals, in_edit, "give the selection's boundary constraints normals"},
      {K::del, with_shift, C::remove_normals, in_edit, "remove the selection's normals"},
      {K::b, with_ctrl, C::make_boundary, in_edit, "make the selection boundary"},
      {K::i, with_ctrl, C::make_interior, in_edit, "make the selection interior"},
      {K::e, with_ctrl, C::make_exterior, in_edit, "make the selection exterior"},
      {K::right_bracket,
       {},
       C::raise_value,
       in_edit,
       "the see-saw lever: the selection's interior values up, exterior ones down, by a tenth; with no "
       "selection all interior ones"},
      {K::left_bracket, {}, C::lower_value, in_edit, "the lever back: values toward 0"},
      {K::left, {}, C::nudge_left, in_edit, nudge},
      {K::right, {}, C::nudge_right, in_edit, nudge},
      {K::up, {}, C::nudge_up, in_edit, nudge},
      {K::down, {}, C::nudge_down, in_edit, nudge},
      {K::left, with_shift, C::nudge_far_left, in_edit, nudge_far},
      {K::right, with_shift, C::nudge_far_right, in_edit, nudge_far},
      {K::up, with_shift, C::nudge_far_up, in_edit, nudge_far},
      {K::down, with_shift, C::nudge_far_down, in_edit, nudge_far},
      {K::k, {}, C::cage, in_edit, "a cage: eight exterior constraints around everything"},
      {K::d, with_ctrl, C::duplicate, in_edit, "duplicate the selection"},
      {K::x, with_ctrl, C::cut, in_edit, "cut the selection"},
      {K::c, with_ctrl, C::copy, in_edit, "copy the selection, or with none the scene, as JSON"},
      {K::c, with_ctrl_shift, C::copy_scene, in_edit, "copy the whole scene"},
      {K::v, with_ctrl, C::paste, in_edit, "paste constraints"},
      {K::v, with_ctrl_shift, C::paste_scene, in_edit, "paste a whole scene in place of this one"},

      {K::f, {}, C::fit, in_view, "show everything"},
      {K::home, {}, C::fit, in_view, "show everything"},
      {K::plus, {}, C::zoom_in, in_view, "zoom in"},
      {K::plus, with_shift, C::zoom_in, in_view, "zoom in"},
      {K::minus, {}, C::zoom_out, in_view, "zoom out"},

      {K::g, {}, C::toggle_snap, in_show, "snap to the grid"},
      {K::comma, {}, C::finer_grid, in_show, "a finer grid"},
      {K::period, {}, C::coarser_grid, in_show, "a coarser grid"},
      {K::digit1, {}, C::toggle_field, in_show, "the function as colors"},
      {K::digit2, {}, C::toggle_isolines, in_show, "isolines"},
      {K::digit3, {}, C::toggle_gradient, in_show, "the gradient"},
      {K::digit4, {}, C::toggle_constraints, in_show, "constraints"},
      {K::digit5, {}, C::toggle_normals, in_show, "normals"},
      {K::digit6, {}, C::toggle_scale_bar, in_show, "the scale bar"},
      {K::digit7, {}, C::toggle_grid, in_show, "grid lines"},
      {K::w, {}, C::toggle_weights, in_show, "each constraint's weight"},
      {K::t, {}, C::toggle_plate, in_show, "the see-saw: the function as a plate"},
      {K::p, with_shift, C::toggle_profile, in_show, "the profile line"},
      {K::f9, {}, C::toggle_panels, in_show, "the panels, or the scene alone"},
      {K::f10, {}, C::toggle_dark, in_show, "light or dark"},
      {K::plus, with_ctrl, C::larger_letters, in_show, "larger letters, for the back of the hall"},
      {K::minus, with_ctrl, C::smaller_letters, in_show, "smaller letters"},
      {K::m, {}, C::remember, in_show, "remember this shape as \"before\""},
      {K::o, {}, C::compare, in_show, "compare with \"before\""},
      {K::o, with_shift, C::compare_kernels, in_show, "compare with another kernel"},

      {K::n, with_ctrl, C::new_document, in_file, "new"},
      {K::o, with_ctrl, C::open, in_file, "open"},
      {K::s, with_ctrl, C::save, in_file, "save"},
      {K::s, with_ctrl_shift, C::save_as, in_file, "save under another name"},
      {K::e, with_ctrl_shift, C::export_picture, in_file, "export a picture or the curve"},
      {K::p, with_ctrl_shift, C::export_window, in_file,
       "export the whole window, plate and profile too, as a picture"},
      {K::r, with_ctrl, C::record, in_file, "record the session, or stop recording"},
      {K::r, with_ctrl_shift, C::replay, in_file, "replay a recorded session, as it was done"},
      {K::enter, {}, C::edit_values, in_file, "type the selection's numbers"},
      {K::f1, {}, C::help, in_file, "this list"},
      {K::f2, {}, C::gallery, in_file, "the papers' figures, to open and drag"},
      {K::f3, {}, C::tour, in_file, "a short guided tour"},
      {K::f11, {}, C::full_screen, in_file, "full screen"},
      {K::q, with_ctrl, C::quit, in_file, "quit"},
  };
  return rows;
}

std::span<const PointerBinding> pointer_bindings() {
  using S = Gesture;
  constexpr auto left = PointerButton::left, middle = PointerButton::middle, right = PointerButton::right;
  constexpr Held bare{};
  constexpr unsigned select = bit_of(Tool::select), normal = bit_of(Tool::normal), pan = bit_of(Tool::pan);
  constexpr unsigned line = bit_of(Tool::line), circle = bit_of(Tool::circle),
                     profile = bit_of(Tool::profile);
  constexpr unsigned placing = bit_of(Tool::boundary) | bit_of(Tool::interior) | bit_of(Tool::exterior);
  constexpr unsigned anything = ~0u, empty = bit_of(Over::nothing), curve = bit_of(Over::curve);
  constexpr unsigned constraint = bit_of(Over::constraint), spike = bit_of(Over::spike);
  constexpr unsigned ends = bit_of(Over::profile_start) | bit_of(Over::profile_end);
  constexpr unsigned along = bit_of(Over::profile), ground = empty | curve | ends | along;
  static constexpr PointerBinding rows[] = {
      {S::turn, select | placing | normal, left, with_ctrl, spike, 0, "the end of a normal", "select it",
       "turn the normal; its length becomes its value"},
      {S::pan, any_tool, middle, {}, anything, 0, "", "", "pan"},
      {S::pan, any_tool, right, {}, anything, 0, "", "", "pan"},
      {S::quick_boundary, any_tool, left, with_ctrl, anything, 0, "",
       "place a boundary constraint; on a constraint: make it one", "add to the selection by a rubber band"},
      {S::quick_interior, any_tool, left, with_ctrl_shift, anything, 0, "",
       "place an interior constraint; on a constraint: make it one", "add to the selection by a rubber band"},
      {S::quick_exterior, any_tool, left, with_ctrl_alt, anything, 0, "",
       "place an exterior constraint; on a constraint: make it one", "add to the selection by a rubber band"},
      {S::toggle, any_tool, left, with_shift, constraint, 0, "a constraint",
       "into the selection, or out of it", "move the selection"},
      {S::beneath, any_tool, left, with_alt, constraint, 0, "a constraint", "select the one beneath it",
       "move that"},
      {S::pan, any_tool, left, with_shift, anything & ~constraint, 0, "empty space", "", "pan"},

      {S::values, select, left, bare, constraint, 2, "a constraint", "type its numbers", ""},
      {S::on_curve, select, left, bare, curve, 2, "the curve",
       "place a boundary constraint on it; nothing changes", ""},
      {S::center, select | pan, left, bare, empty, 2, "empty space", "center the view there", ""},
      {S::grab, select | placing, left, bare, constraint, 0, "a constraint", "select it",
       "move the selection"},
      {S::turn, select | placing | normal, left, bare, spike, 0, "the end of a normal", "select it",
       "turn the normal"},
      {S::move_profile, select | profile, left, bare, ends, 0, "an end of the profile line", "", "move it"},
      {S::move_profile, select | profile, left, bare, along, 0, "the profile line", "", "move it"},
      {S::band, select, left, bare, ground, 0, "empty space", "select nothing", "select by a rubber band"},

      {S::place, placing, left, bare, ground, 0, "empty space or the curve",
       "place a constraint; a boundary one near the curve goes onto it, and nothing changes", "move it"},
      {S::place, placing, left, with_alt, ground, 0, "empty space or the curve",
       "place a constraint exactly here", "move it"},
      {S::give_normal, normal, left, bare, constraint, 0, "a boundary constraint",
       "give it the normal that it has", "turn that"},
      {S::place_normal, normal, left, bare, ground, 0, "empty space or the curve",
       "place a boundary constraint with a normal", "turn that"},
      {S::line, line, left, bare, anything, 0, "", "", "place constraints along a line"},
      {S::circle, circle, left, bare, anything, 0, "", "", "place constraints on a circle, from its center"},
      {S::profile, profile, left, bare, anything, 0, "", "", "draw the profile line"},
      {S::pan, pan, left, bare, anything, 0, "", "", "pan"},
  };
  return rows;
}

std::span<const DragBinding> drag_bindings() {
  static constexpr DragBinding rows[] = {
      {DragEffect::straight, with_shift, "along one axis; lines, circles and normals in steps of 15 degrees"},
      {DragEffect::free, with_alt, "snap to nothing"},
      {DragEffect::value, with_ctrl, "of a normal: its length becomes its value"},
  };
  return rows;
}

std::span<const WheelBinding> wheel_bindings() {
  static constexpr WheelBinding rows[] = {
      {WheelUse::count, true, {}, "more constraints along the line or circle, or fewer"},
      {WheelUse::across, false, with_shift, "move the view sideways"},
      {WheelUse::zoom, false, {}, "zoom about the cursor"},
  };
  return rows;
}

std::span<const ToolInfo> tool_infos() {
  static constexpr ToolInfo rows[] = {
      {Tool::select, "select",
       "Drag constraints, or a rubber band around them. Double-click the curve for one more."},
      {Tool::boundary, "boundary",
       "Click where the curve is to pass. On the curve itself nothing changes: then drag."},
      {Tool::interior, "interior", "Click what is to be inside; its value is the height of the plate there."},
      {Tool::exterior, "exterior", "Click what is to be outside."},
      {Tool::normal, "normal",
       "Click a boundary constraint for its normal, drag the end of the spike to turn it."},
      {Tool::line, "line", "Drag a line; the wheel sets how many constraints. Kind: the last of B, I, E."},
      {Tool::circle, "circle", "Drag from the center; the wheel sets how many. Kind: the last of B, I, E."},
      {Tool::profile, "profile", "Drag a line across the curve to see the function along it."},
      {Tool::pan, "pan", "Drag to move the view; the wheel zooms about the cursor."},
  };
  static_assert(std::size(rows) == tool_count);
  return rows;
}

std::string name_of(DeskKey key) {
  constexpr const char* others[] = {"Esc",  "Enter", "Tab",  "Space", "Backspace", "Delete",
                                    "Home", "End",   "Left", "Right", "Up",        "Down",
                                    "+",    "-",     "[",    "]",     ",",         "."};
  static_assert(static_cast<int>(DeskKey::escape) + std::size(others) == desk_keys);
  if (key <= DeskKey::z) return {static_cast<char>('A' + static_cast<int>(key))};
  if (key <= DeskKey::digit9)
    return std::to_string(static_cast<int>(key) - static_cast<int>(DeskKey::digit0));
  if (key <= DeskKey::f12)
    return "F" + std::to_string(static_cast<int>(key) - static_cast<int>(DeskKey::f1) + 1);
  return others[static_cast<int>(key) - static_cast<int>(DeskKey::escape)];
}

std::string name_of(const Held& held) {
  return std::string(held.ctrl ? "Ctrl+" : "") + (held.alt ? "Alt+" : "") + (held.shift ? "Shift+" : "");
}

std::optional<DeskCommand> command_of(DeskKey key, const Held& held) {
  for (const KeyBinding& row : key_bindings())
    if (row.key == key && row.held == held) return row.command;
  return std::nullopt;
}

std::string keys_of(DeskCommand command) {
  for (const KeyBinding& row : key_bindings())
    if (row.command == command) return name_of(row.held) + name_of(row.key);
  return {};
}

Gesture gesture_of(Tool tool, Over over, PointerButton button, const Held& held, int clicks) {
  for (const PointerBinding& row : pointer_bindings())
    if ((row.tools & bit_of(tool)) && (row.over & bit_of(over)) && row.button == button &&
        (!row.held || *row.held == held) && (row.clicks == 0 || row.clicks == clicks))
      return row.gesture;
  return Gesture::none;
}

bool in_effect(DragEffect effect, const Held& held) {
  return std::ranges::any_of(
      drag_bindings(), [&](const DragBinding& row) { return row.effect == effect && held.hold(row.held); });
}

WheelUse wheel_use(bool drawing, const Held& held) {
  for (const WheelBinding& row : wheel_bindings())
    if (row.while_drawing == drawing && (!row.held || *row.held == held)) return row.use;
  return WheelUse::zoom;
}

std::vector<HelpLine> help_lines() {
  std::vector<HelpLine> lines;
  // Lines of a section stand together; what says the same is one line with several keys.
  const auto say = [&](const std::string& section, const std::string& keys, const std::string& words) {
    auto place = lines.end();
    for (auto line = lines.begin(); line != lines.end(); ++line) {
      if (line->section != section) continue;
      if (line->words == words) {
        line->keys += ", " + keys;
        return;
      }
      place = line + 1;
    }
    lines.insert(place, {section, keys, words});
  };
  for (const KeyBinding& row : key_bindings())
    say(row.section, name_of(row.held) + name_of(row.key), row.words);
  for (const bool any : {true, false})
    for (const PointerBinding& row : pointer_bindings())
      if ((row.tools == any_tool) == any) say(section_of(row), keys_for(row), words_of(row));
  say("Pointer, with any tool", name_of(pan_key) + " held", "pan, as with the pan tool");
  for (const DragBinding& row : drag_bindings()) {
    std::string keys = name_of(row.held);
    keys.pop_back();
    say("While dragging", keys, row.words);
  }
  say("While dragging", name_of(more_key) + ", " + name_of(fewer_key), wheel_bindings().front().words);
  for (const WheelBinding& row : wheel_bindings())
    say("Wheel", name_of(row.held.value_or(Held{})) + (row.while_drawing ? "Wheel while drawing" : "Wheel"),
        row.words);
  return lines;
}

}  // namespace seesaw
