// What every key and every gesture means: one table, from which the desk acts and the help is written.
//
// Before it: core/editing/desk_events.h.  After it: core/editing/desk.h looks up what to do; F1 shows
// help_lines(). A gesture that is not in the table does not exist, and one that is is in the help.
//
// A press of a pointer button begins a *gesture*, which becomes a click or a drag. Which gesture depends on
// the tool in hand, what is under the cursor, the button and the modifier keys at the press; the first row
// that fits holds. What modifier keys are held while dragging is another matter (DragEffect).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/editing/desk_events.h"
#include "core/editing/hit_test.h"

namespace seesaw {

enum class Tool { select, boundary, interior, exterior, normal, line, circle, profile, pan };
inline constexpr int tool_count = static_cast<int>(Tool::pan) + 1;

/// Everything that a key or a menu can ask for.
enum class DeskCommand {
  // Tools, in the order of Tool.
  tool_select,
  tool_boundary,
  tool_interior,
  tool_exterior,
  tool_normal,
  tool_line,
  tool_circle,
  tool_profile,
  tool_pan,
  // What to work on.
  select_all,
  select_none,
  select_boundary,
  select_interior,
  select_exterior,
  select_normals,
  select_culprits,
  select_next,
  select_previous,
  // What to do.
  cancel,
  undo,
  redo,
  delete_selection,
  remove_normals,
  add_normals,
  make_boundary,
  make_interior,
  make_exterior,
  raise_value,
  lower_value,
  nudge_left,
  nudge_right,
  nudge_up,
  nudge_down,
  nudge_far_left,
  nudge_far_right,
  nudge_far_up,
  nudge_far_down,
  cage,
  duplicate,
  cut,
  copy,
  copy_scene,
  paste,
  paste_scene,
  // Where to look.
  fit,
  zoom_in,
  zoom_out,
  // What to see.
  toggle_snap,
  finer_grid,
  coarser_grid,
  toggle_field,
  toggle_isolines,
  toggle_gradient,
  toggle_constraints,
  toggle_normals,
  toggle_scale_bar,
  toggle_grid,
  toggle_profile,
  remember,
  compare,
  compare_kernels,
  // What only a program can do: Desk::handle hands these over.
  edit_values,
  toggle_weights,
  toggle_plate,
  toggle_panels,
  toggle_dark,
  larger_letters,
  smaller_letters,
  gallery,
  tour,
  new_document,
  open,
  save,
  save_as,
  export_picture,
  export_window,
  record,
  replay,
  help,
  full_screen,
  quit
};
inline constexpr int desk_commands = static_cast<int>(DeskCommand::quit) + 1;

struct KeyBinding {
  DeskKey key;
  Held held;
  DeskCommand command;
  const char* section;
  const char* words;
};
/// No two rows have the same key with the same modifiers.
std::span<const KeyBinding> key_bindings();
std::optional<DeskCommand> command_of(DeskKey key, const Held& held);
/// Its keys, for a menu: "Ctrl+Shift+Z"; empty where it has none. The first of several.
std::string keys_of(DeskCommand command);

/// Held down it makes the pointer pan, whatever the tool.
inline constexpr DeskKey pan_key = DeskKey::space;
/// While a line or circle of constraints is drawn they do what the wheel does.
inline constexpr DeskKey more_key = DeskKey::plus, fewer_key = DeskKey::minus;

/// What a press begins.
enum class Gesture {
  none,
  pan,
  grab,          ///< click: selects it; drag: moves the selection
  toggle,        ///< click: into the selection or out of it; drag: moves
  beneath,       ///< click: selects the one beneath; drag: moves it
  turn,          ///< drag: turns a normal
  band,          ///< click: selects nothing; drag: a rubber band
  place,         ///< press: a constraint of the tool's kind; drag: moves it
  place_normal,  ///< press: a boundary constraint with a normal; drag: turns it
  give_normal,   ///< press: gives it a normal; drag: turns that
  quick_boundary,
  quick_interior,
  quick_exterior,  ///< click: places one, or makes one that; drag: a rubber band that adds
  line,
  circle,
  profile,
  move_profile,  ///< an end of it, or all of it
  center,        ///< double click: centers the view
  on_curve,      ///< double click on the curve: a boundary constraint there
  values         ///< double click on a constraint: its numbers
};

struct PointerBinding {
  Gesture gesture;
  unsigned tools;  ///< bit t: holds for Tool t
  PointerButton button;
  std::optional<Held> held;  ///< exactly these; nothing for any
  unsigned over;             ///< bit o: holds over Over o
  int clicks;                ///< of a double click, 2; else 0
  const char* where;         ///< for the help: what is under the cursor; empty for anything
  const char* click;         ///< what a click does; empty for nothing
  const char* drag;          ///< what a drag does; empty for nothing
};
std::span<const PointerBinding> pointer_bindings();
Gesture gesture_of(Tool tool, Over over, PointerButton button, const Held& held, int clicks);

/// What modifier keys do while something is dragged.
enum class DragEffect {
  straight,  ///< along an axis; lines, circles and normals in steps of 15 degrees
  free,      ///< snaps to nothing
  value      ///< the length of a normal is its value
};
struct DragBinding {
  DragEffect effect;
  Held held;
  const char* words;
};
std::span<const DragBinding> drag_bindings();
bool in_effect(DragEffect effect, const Held& held);

/// What the wheel does.
enum class WheelUse { count, across, zoom };
struct WheelBinding {
  WheelUse use;
  bool while_drawing;  ///< a line or circle of points
  std::optional<Held> held;
  const char* words;
};
std::span<const WheelBinding> wheel_bindings();
WheelUse wheel_use(bool drawing, const Held& held);

struct ToolInfo {
  Tool tool;
  const char* name;  ///< "boundary"
  const char* hint;  ///< one line for the bottom of the window
};
/// In the order of Tool.
std::span<const ToolInfo> tool_infos();

struct HelpLine {
  std::string section;  ///< equal for lines that belong together
  std::string keys;     ///< "Ctrl+Shift+Z, Ctrl+Y"
  std::string words;
};
/// All of the above, as F1 shows it.
std::vector<HelpLine> help_lines();

}  // namespace seesaw
