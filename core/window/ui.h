// Panels, menus and widgets, in one voice for both sandboxes.
//
// An interface that is drawn anew each frame: a call draws a widget and says what was done to it.
//
//     if (auto panel = ui::panel("Lever", {900, 40, 300, 200})) {
//       if (ui::button("Undo")) editor.undo();
//       const ui::Edit edit = ui::slider("Interior value", value, -2, 2);
//       if (edit.began) editor.begin_gesture();
//       if (edit.changed) editor.set_value(value);
//       if (edit.ended) editor.end_gesture();
//     }
//
// A label must be unique within its panel; what follows "##" in it is not shown: "Delete##3". Scripts call a
// widget by what is shown; a field without a shown label by its hint, a choice by what is chosen. All lengths
// are logical pixels of the window; multiply yours by ui::scale().
//
// Before it: Window::begin_frame. After it: Window::end_frame, which draws it all.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/image/rect.h"
#include "core/window/input.h"
#include "core/window/texture.h"
#include "core/window/ui_style.h"

namespace seesaw::ui {

/// Something that is open until the end of the block: `if (auto menu = ui::menu("File")) { ... }`. What is
/// not open is false, and nothing should be drawn into it.
class [[nodiscard]] Scope {
 public:
  Scope(bool open, void (*end)()) : open_(open), end_(end) {}
  Scope(Scope&& other) noexcept : open_(other.open_), end_(std::exchange(other.end_, nullptr)) {}
  Scope& operator=(Scope&&) = delete;
  ~Scope() {
    if (end_) end_();
  }
  explicit operator bool() const { return open_; }

 private:
  bool open_;
  void (*end_)();
};

/// What a hand did to a value. A drag begins, changes many times, and ends; so does typing.
struct Edit {
  bool changed = false;
  bool began = false;  ///< in this frame it was taken hold of
  bool ended = false;  ///< let go after at least one change
  explicit operator bool() const { return changed; }
};

// Containers.

struct PanelOptions {
  bool title = true;
  bool movable = false;  ///< moved and resized by hand; its Rect is then where it begins
  bool padded = true;
  bool scrolls = true;   ///< by a bar where its content is too high
  bool* open = nullptr;  ///< with a closing cross that makes it false
};
Scope panel(const std::string& title, const Rect& rect, const PanelOptions& options = {});
/// The bar along the top of the window, ui::menu_height() high.
Scope menu_bar();
double menu_height();
Scope menu(const std::string& label, bool enabled = true);
/// True when it is chosen. `keys` is shown only; label_of(KeyChord) writes it.
bool menu_item(const std::string& label, const std::string& keys = {}, bool enabled = true);
/// With a tick while `on`.
bool menu_switch(const std::string& label, bool& on, const std::string& keys = {});
/// A part of a panel that folds away under its heading.
Scope section(const std::string& label, bool open_at_first = true);
Scope tabs(const std::string& id);
Scope tab(const std::string& label);
/// A part that scrolls; 0 for all that is left.
Scope scroll_area(const std::string& id, double width = 0, double height = 0, bool framed = false);
/// Rows and columns; `headers` may be empty strings for none. Begin each cell with next_cell().
/// Columns are as wide as their content wants, or share the width by `weights`, one each.
Scope table(const std::string& id, const std::vector<std::string>& headers, bool striped = false,
            const std::vector<double>& weights = {});
void next_cell();
/// Widgets within are drawn pale and do nothing while `off`.
Scope disabled(bool off);
/// Labels within may repeat those outside.
Scope id(const std::string& name);
Scope id(long number);
/// Sliders, fields and choices within are so wide; negative: so much is left free to their right.
Scope item_width(double width);

// Dialogs: in the middle, over all else, until they are closed; Escape closes them, with nothing done. One
// that is drawn within another stands before it, and keys are for the foremost.

/// From anywhere, a menu too; it opens where and when dialog(title) is next called.
void open_dialog(const std::string& title);
/// Without `escape` the program itself looks for that key, and may do something first.
Scope dialog(const std::string& title, double width = 0, bool escape = true);
void close_dialog();
/// Whether a dialog, a menu or a popup is open.
bool any_dialog();
/// Within a dialog: whether nothing stands before it, neither another dialog nor an open choice.
bool foremost();
/// A small menu at the pointer.
void open_popup(const std::string& id);
Scope popup(const std::string& id);

// Buttons.

bool button(const std::string& label, double width = 0);
/// In the accent's color; in a dialog Enter presses it.
bool main_button(const std::string& label, double width = 0);
/// Looks pressed while `on`: tools.
bool tool_button(const std::string& label, bool on, double width = 0);
bool checkbox(const std::string& label, bool& on);
bool radio(const std::string& label, bool on);
/// A line of a list.
bool list_item(const std::string& label, bool chosen);

/// What stands at the right of a list's line, flush right in a column of its own.
struct RowFact {
  std::string words;
  double width = 0;
};
struct RowUse {
  bool clicked = false;  ///< the second click of two, too
  bool double_clicked = false;
};
/// A line of a list as wide as there is room: a small mark, the label, which is shortened where it is too
/// long, and soft facts. The label is shown whole, "##" too, so it stands within a ui::id.
RowUse list_row(const std::string& label, bool chosen, const std::vector<RowFact>& facts = {},
                const std::string& mark = {});
/// Draws those of `count` lines of the same height that can be seen: a list of 100,000 is as quick as one of
/// 10. Stands in a scroll_area, which is moved so that line `show` can be seen; -1 for no such wish.
void long_list(Index count, const std::function<void(Index)>& draw_row, Index show = -1);

// Values.

struct SliderOptions {
  const char* format = "%.3g";
  bool logarithmic = false;   ///< for values over several powers of ten; may include zero
  bool typed_beyond = false;  ///< a number that is typed may lie beyond the ends
};
/// A click and a drag; ctrl-click to type.
Edit slider(const std::string& label, double& value, double least, double most, const SliderOptions& = {});
Edit slider(const std::string& label, int& value, int least, int most);
/// A field to type a number into; changes when Enter is pressed or the field is left. With step > 0 also
/// - and + buttons.
Edit number(const std::string& label, double& value, double step = 0, const char* format = "%.6g");
/// A number that is dragged sideways, `speed` a pixel; ctrl-click or double-click to type.
Edit drag_number(const std::string& label, double& value, double speed, const char* format = "%.4g");
Edit text_field(const std::string& label, std::string& text, const std::string& hint = {});
/// Several lines; `ended` when it is left.
Edit text_area(const std::string& label, std::string& text, double width = 0, double height = 0);
/// One of `names`; others than 0 .. n - 1 show as none.
Edit choice(const std::string& label, int& chosen, const std::vector<std::string>& names);

// Words.

void text(const std::string& words);
/// Broken into lines at the panel's edge.
void paragraph(const std::string& words);
void soft_text(const std::string& words);
void bold_text(const std::string& words);
void heading(const std::string& words);
void colored_text(const std::string& words, const Color& color);
/// A name on the left and its value flush right: the live numbers.
void fact(const std::string& name, const std::string& value);
void progress(double fraction, const std::string& words);
/// Shown while the pointer rests on the last widget.
void tooltip(const std::string& words);
double text_width(const std::string& words);
/// The words, or as much of their beginning and end as fits into `width`, with … between.
std::string shortened(const std::string& words, double width);

// Layout.

/// The next widget stands beside the last; `gap` < 0 for the usual one.
void same_line(double gap = -1);
void separator();
void gap(double height);
double width_left();
double height_left();
double line_height();
/// Of letters and panels (Window::set_scale).
double scale();
/// What comes next is `width` wide, and flush right.
void flush_right(double width);
/// How wide a button with these words is, and with all of them side by side.
double button_width(const std::string& label);
double buttons_width(const std::vector<std::string>& labels);
/// Of the window.
double window_width();
double window_height();
/// Where the last widget is.
Rect last_place();
bool last_hovered();
/// The next widget gets the keys.
void focus_next();
/// Whether the key went down in this frame, whoever has the keys; `repeat`: or was held for a while. Only
/// keys that move a caret or end its work are known here: arrows, page up and down, enter, escape, tab and
/// such.
bool key_pressed(Key key, bool repeat = false);

// Pictures.

/// Under all panels. Where `rect` has as many real pixels as the texture, they are shown exactly.
void background(const Texture& texture, const Rect& rect);

/// What the pointer does to a picture in a panel.
struct PictureUse {
  bool hovered = false;
  bool held = false;      ///< a button went down on it and is not up yet
  int button = 0;         ///< of held: 0 left, 1 right, 2 middle
  double dx = 0, dy = 0;  ///< moved in this frame while held
  double wheel = 0;       ///< notches up while hovered
  double x = 0, y = 0;    ///< of the pointer from the picture's top left
  bool double_clicked = false;
  Rect place;
};
PictureUse picture(const std::string& label, const Texture& texture, double width, double height);

enum class Pointer { arrow, hand, move, text, forbidden, across, down };
/// How the pointer looks in this frame.
void pointer(Pointer look);

/// The colors of the present style.
UiColors colors();

}  // namespace seesaw::ui
