// Inside core/window: what panels and widgets remember from frame to frame.
//
// Every widget notes its name and place, so that a script can say `click "Undo"` and still hit when the
// layout has changed. It is owned by the Window and reached through Dear ImGui's context.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/image/rect.h"
#include "core/window/ui_style.h"

namespace seesaw::detail {

struct UiState {
  struct Item {
    std::string panel;  ///< the visible part of its panel's title
    std::string label;  ///< the visible part of its own
    Rect place;         ///< logical pixels of the window
  };
  UiFonts fonts = {};
  double scale = 1;
  bool dark = false;
  std::vector<Item> items = {};          ///< of this frame so far; between frames, of the last
  std::vector<std::string> panels = {};  ///< those that are open now, innermost last

  std::vector<std::string> to_open = {};  ///< dialogs and popups that were asked for and not drawn yet
  int dialogs = 0;                        ///< that are open around what is drawn now

  /// What stands in the number fields that have the caret, or had it in the last frame, by Dear ImGui's
  /// numbers for them.
  std::map<unsigned, double> typed = {};
  /// The number for the widget that was dragged, or typed into, in the last frame; 0 for none.
  unsigned in_hand = 0;

  /// Whether it was asked for; then it is no longer.
  bool take_to_open(const std::string& name) { return std::erase(to_open, name) > 0; }
  void begin_frame() {
    items.clear();
    panels.clear();
  }
  /// The widget called "label" or "panel/label", the last drawn if there are several; null if there is none.
  const Item* find(const std::string& name) const;
  /// All names, for messages: "Undo, Redo, ...".
  std::string names() const;
};

/// The present Window's.
UiState& ui_state();
/// Notes the widget that was drawn last, if it can be seen.
void note_item(const std::string& label);
/// What is shown of a label: all before "##".
std::string visible_part(const std::string& label);

}  // namespace seesaw::detail
