// A desk: a document being edited, and what stands around it while a person works. All of the 2D editor but
// its window.
//
// Before it: events of a window or a script (core/editing/desk_events.h), menus, sliders, files.
// After it: whatever draws asks it what there is to see; core/editing/editor.h keeps the document.
//
//     Desk desk(read_document<2>("figures/scenes/turk2002-fig01-left.json"));
//     desk.view().resize(1280, 800);
//     desk.fit();
//     desk.handle(KeyDown{DeskKey::b});                        // the tool for boundary constraints
//     desk.handle(PointerDown{{1.2, 0.1}});                    // one there; on the curve where that is near
//     desk.handle(PointerMoved{{1.6, 0.1}});                   // the curve is pulled
//     desk.handle(PointerUp{{1.6, 0.1}});
//     desk.perform(DeskCommand::undo);                         // all of it
//
// What a key or a gesture means is in one table (core/editing/desk_bindings.h). Whatever a hand does between
// pressing and letting go is one step to undo, and Esc takes it back while it lasts. What cannot be done is
// said in message(), and changes nothing. The selection never names a constraint that is not there.
#pragma once

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <variant>

#include "core/editing/arrangements.h"
#include "core/editing/desk_bindings.h"
#include "core/editing/grid.h"
#include "core/editing/selection.h"
#include "core/editing/session.h"
#include "core/editing/view_2d.h"

namespace seesaw {

/// The system's clipboard, or one of the desk's own where nothing is given.
struct Clipboard {
  std::function<void(const std::string&)> set = {};
  std::function<std::string()> get = {};
};

struct DeskOptions {
  EditorOptions<2> editor = {};
  /// For the function of another kernel, to compare with. A window gives a solver of its own here that may be
  /// StillSolving (core/editing/background_solver.h), as it does in `editor`.
  Solver<2> other_solver = [](const Constraints<2>& c, FitOptions o) {
    o.condition = false;
    return fit<2>(c, o);
  };
  Clipboard clipboard = {};
  /// In pixels, at scale 1.
  Reaches reaches = {};
  double drag_threshold = 4;  ///< pixels; a press that moves less is a click
  /// No file or paste makes the document larger than this: a fit takes N^3 / 3 multiplications.
  Index most_constraints = 5000;
};

/// What was done, or why not: one sentence for the bottom of the window.
struct DeskMessage {
  std::string text = {};
  bool trouble = false;
  /// Grows with every message.
  std::uint64_t number = 0;
};

class Desk {
 public:
  explicit Desk(Document<2> document = {}, DeskOptions options = {});
  Desk(Desk&&) = default;
  Desk& operator=(Desk&&) = default;

  // --- What is done. A command that only a program can do (save, help, ...) comes back; so do those of
  // perform().

  std::optional<DeskCommand> handle(const DeskEvent& event);
  std::optional<DeskCommand> perform(DeskCommand command);

  /// One step to undo, from a field or a list. False where it was refused: message() says why.
  bool apply(const Action<2>& action);
  /// For a slider: from the first on one step to undo, until let_go(). Esc takes it back.
  bool slide(const Action<2>& action);
  /// The slider is let go, the gesture under way is ended where it is.
  void let_go();
  /// Takes back what is in hand, as Esc. False where nothing was.
  bool cancel();
  /// A command of a recorded session, done as it was then: for demonstrations. False where it was refused.
  bool do_again(const Command<2>& command);

  void take(Tool tool);
  /// Those of `indices` that exist.
  void select(const std::vector<Index>& indices);
  /// Constraints of lines and circles, 1 to 200.
  void set_count(int count) { count_ = std::clamp(count, 1, 200); }
  /// The program's symbols are this many times as large, and so is what one has to hit. > 0.
  void set_scale(double scale) { scale_ = scale; }
  void say(std::string text, bool trouble = false);

  // --- What there is to see.

  const Editor<2>& editor() const { return editor_; }
  const Document<2>& document() const { return editor_.document(); }
  /// 0 <= index < editor().size().
  const Constraint<2>& constraint(Index index) const {
    return document().constraints[static_cast<std::size_t>(index)].constraint;
  }
  /// Solves where that is still to be done. The reference lasts until something is done.
  const Shape<2>& shape() { return editor_.shape(); }
  /// Where a solver has news: asks both again for what was pending, and the editor's for a better function.
  /// What was shown whole before there was a curve is shown whole once there is one.
  void solve_again();
  /// Grows with every change of the document, and never repeats, also over documents.
  std::uint64_t revision() const { return revisions_before_ + editor_.revision(); }

  Tool tool() const { return space_ ? Tool::pan : tool_; }
  /// Of the constraints along lines and circles: the last that was taken in hand.
  ConstraintKind kind() const { return kind_; }
  int count() const { return count_; }
  const Selection& selection() const { return selection_; }
  /// What would be grabbed by a press, or is being dragged.
  Hit hover();
  /// What part of their size symbols are drawn in, for want of room (core/scene/crowding.h).
  double symbol_share();
  /// Where the pointer was last, scene units; nothing before it came.
  std::optional<Point<2>> cursor() const;
  /// What is being dragged, if anything.
  Gesture gesture() const { return hand_ ? hand_->gesture : Gesture::none; }
  /// A slider or a held key is changing the document.
  bool sliding() const { return open_ != Open::none; }
  std::optional<Box<2>> band() const;
  /// Where constraints will stand when the line or circle is let go, 2 x N.
  Points<2> preview() const;

  View2D& view() { return view_; }
  const View2D& view() const { return view_; }
  Grid& grid() { return grid_; }
  const Grid& grid() const { return grid_; }
  double grid_step() const { return grid_.step(view_.pixel()); }
  const std::optional<ProfileLine>& profile() const { return profile_; }
  /// For a program that knows a good one; nothing in hand may be dragging it.
  void set_profile(std::optional<ProfileLine> line) {
    if (!hand_) profile_ = std::move(line);
  }
  /// Saved with the document, but not undone: how a person looks at it.
  Display<2>& display() { return display_; }
  const Display<2>& display() const { return display_; }
  const DeskMessage& message() const { return message_; }
  double scale() const { return scale_; }
  /// DeskOptions::most_constraints.
  Index most_constraints() const { return options_.most_constraints; }

  /// The shape to compare with: that of "before", or of another kernel. Null for none. Lives until something
  /// is done.
  std::shared_ptr<const Interpolant<2>> other();
  /// True where other() is that of an earlier revision, or null, because its solver is still at work.
  bool other_pending() const { return other_pending_; }
  /// "before", or the kernel's name (core/rbf/kernel.h); empty for none.
  std::string other_name() const;

  // --- The view.

  /// Shows all constraints, the closed curves and the profile line.
  void fit();
  /// Steps back where an end of the profile line is out of sight.
  void show_profile_whole();
  /// Shows what the document asks for; else everything.
  void show_as_saved();

  // --- Documents.

  /// Reads the file and makes it the document, without a step to undo. A recorded session is done again: what
  /// was done can then be undone, and the document has no file. False where it cannot be read: the message
  /// says why, and nothing has changed.
  bool open(const std::filesystem::path& path);
  /// Whether there is a document or a session in the file, before anything is given up for it. Where not, the
  /// message says why.
  bool can_open(const std::filesystem::path& path);
  /// All or nothing. False where it cannot be written.
  bool save(const std::filesystem::path& path);
  /// An empty one, or a figure from the gallery, which has no file to be saved to.
  void start(Document<2> document = {});
  /// As start(), but as one step to undo: a person who goes from figure to figure loses nothing. For a
  /// document without a file. What was saved counts as saved.
  void exchange(Document<2> document);
  /// One that was saved after a crash, and is still to be saved to `path`.
  void recover(Document<2> document, const std::filesystem::path& path);

  /// With the display as it is.
  Document<2> to_save() const;
  bool unsaved() const;
  /// Empty for a document without a file.
  const std::filesystem::path& path() const { return path_; }
  /// For the window: the file's name, the title or "untitled", and "*" where it is unsaved.
  std::string name() const;

  /// The selection as a document of its own; the whole one where nothing is selected.
  std::string selection_text() const;
  /// Adds the constraints of a document, and selects them. False where it is none.
  bool paste(const std::string& text);
  /// Makes it the document, as one step to undo.
  bool paste_scene(const std::string& text);

  void start_recording();
  /// What was recorded; nothing if it was not. Ends also where another document is opened.
  std::optional<Session<2>> stop_recording();
  bool recording() const { return recording_; }
  /// How many commands, so far.
  std::size_t recorded() const { return recording_ ? session_->commands.size() : 0; }
  /// Writes what was recorded, all or nothing, and ends the recording, which goes on where that fails. Throws
  /// FileError.
  void save_recording(const std::filesystem::path& path);

 private:
  // From the press of a button to its release.
  struct Hand {
    Gesture gesture = Gesture::none;
    PointerButton button = PointerButton::left;
    Hit hit = {};
    Point<2> pressed = Point<2>::Zero();  // scene units
    bool moved = false;                   // it is a drag
    bool open = false;                    // a gesture of the editor
    Index which = -1;                     // the constraint that is dragged by
    Point<2> origin = Point<2>::Zero();   // where it, or the end that is dragged, was
    Point<2> grip = Point<2>::Zero();     // from the cursor to it
    Point<2> end = Point<2>::Zero();      // where the band, line or circle ends
    double value = 1;                     // of the normal at the start
    // As it was before, for Esc.
    Selection selection = {};
    std::optional<ProfileLine> profile = {};
    View2D view = View2D();
  };
  enum class Open { none, slider, nudge };

  // desk_hand.cpp
  void press(const PointerDown& event);
  void begin_hand(const PointerDown& event, const std::vector<Hit>& found);
  std::optional<DeskCommand> release(const PointerUp& event);
  std::optional<DeskCommand> click();
  void end_hand();
  void open_gesture();
  bool place(ConstraintKind kind, const Point<2>& at, const Held& held);
  bool give_normal();
  std::vector<Hit> hits_at(const Point<2>& at);
  /// As it is drawn, pixels.
  double spike_length();

  // desk_drag.cpp
  void move(const PointerMoved& event);
  void drag(const Point<2>& at, const Held& held);
  void drag_constraints(const Point<2>& at, const Held& held);
  void turn_normal(const Point<2>& at, const Held& held);
  void turn_wheel(const WheelTurned& event);
  Point<2> snapped(const Point<2>& at, const Held& held) const;
  Point<2> line_end(const Point<2>& at, const Held& held) const;

  // desk.cpp
  std::optional<DeskCommand> key(const KeyDown& event);
  std::optional<DeskCommand> run(DeskCommand command);
  bool did(const Action<2>& action);  // applies it; where it is refused, says why
  void close_gesture();
  void keep_home();

  // desk_commands.cpp
  void run_selection(DeskCommand command);
  void run_edit(DeskCommand command);
  void run_display(DeskCommand command);
  void undo_or_redo(bool undo);
  void nudge(const Point<2>& direction, bool far);
  void lever(double factor);
  void make(ConstraintKind kind);
  void add_normals();
  void add(const Constraints<2>& constraints, const char* none_left);
  /// From a constraint to its copy.
  Point<2> beside() const;
  bool room_for(std::size_t more);

  // desk_document.cpp
  void check_size(Index count, const std::string& name) const;
  std::variant<Document<2>, Session<2>> read(const std::filesystem::path& path) const;
  bool says_why_not(const std::filesystem::path& path, const std::function<void()>& act);
  void replace(Editor<2> next, std::filesystem::path path, bool saved);

  DeskOptions options_;
  Editor<2> editor_;
  std::uint64_t revisions_before_ = 0;

  Tool tool_ = Tool::select;
  bool space_ = false;
  ConstraintKind kind_ = ConstraintKind::boundary;
  int count_ = 8;
  Selection selection_;
  std::optional<Hand> hand_;
  Open open_ = Open::none;
  std::optional<Point<2>> cursor_;  // pixels: the view may move beneath it
  double scale_ = 1;

  View2D view_;
  Grid grid_;
  std::optional<ProfileLine> profile_;
  Display<2> display_;
  DeskMessage message_;

  std::shared_ptr<const Interpolant<2>> before_;
  bool comparing_ = false;
  std::optional<Kernel> other_kernel_;
  std::shared_ptr<const Interpolant<2>> other_;  // of other_kernel_
  std::uint64_t other_revision_ = ~std::uint64_t{0};
  double spacing_ = 0;  // between constraints, of this revision:
  std::uint64_t spacing_revision_ = ~std::uint64_t{0};
  bool other_pending_ = false;
  bool fit_when_solved_ = false;  // the view shows constraints alone: the curve was not there yet

  std::filesystem::path path_;
  std::optional<std::uint64_t> saved_state_ = 0;
  Display<2> saved_display_;
  std::string own_clipboard_;
  std::unique_ptr<Session<2>> session_;
  bool recording_ = false;
};

}  // namespace seesaw
