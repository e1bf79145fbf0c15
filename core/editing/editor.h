// A document being edited: actions in, the document and its shape out, everything undoable.
//
// Before it: core/editing/action.h, from a mouse, a script or a session file.
// After it: the sandboxes and figures draw document() and shape().
//
// Turk & O'Brien 2002, section 5, is this loop:
//     1. create or move constraints    apply()
//     2. solve the new equation        done by apply()
//     3. adjust floater positions      shape().function, core/particles
//     4. render
//
//     Editor<3> editor(document);
//     editor.apply(AddOnSurface<3>{.from = eye, .direction = through_cursor});
//     const Index added = editor.size() - 1;                   // f has not changed
//     editor.begin_gesture();                                  // the mouse goes down ...
//     editor.apply(Move<3>{{added}, {0.01, 0, 0}});            // ... moves, many times ...
//     editor.end_gesture();                                    // ... goes up: one step to undo
//     editor.undo();
//
// An action happens as a whole or not at all: Refused says why, and nothing has changed. An action that
// changes nothing leaves no trace. Undo has no limit and gives back every bit.
//
// There is no window here, no selection and no file. The document never breaks a rule of
// core/scene/document_rules.h that it kept at the start, so it can be saved at any moment.
#pragma once

#include <functional>

#include "core/editing/action.h"
#include "core/editing/history.h"
#include "core/editing/shape.h"

namespace seesaw {

struct Undo {};
struct Redo {};
/// The mouse goes down; up; Esc is pressed in between.
struct BeginGesture {};
struct EndGesture {};
struct CancelGesture {};
/// A moment with a name, at which a figure takes its picture. Changes nothing.
struct Label {
  std::string text;
};

/// Everything that can be told to an editor, so everything that a session records. For messages: name_of.
template <int Dim>
using Command = std::variant<Action<Dim>, Undo, Redo, BeginGesture, EndGesture, CancelGesture, Label>;

/// "undo", "redo", "begin", "end", "cancel", "label", or the action's name. For Dim 2 and 3.
template <int Dim>
const char* name_of(const Command<Dim>& command);

/// What became of a command.
struct Outcome {
  bool changed = false;
  /// Indices of the constraints that are new or different in the document as it is now, ascending: what an
  /// editor selects after an undo.
  std::vector<Index> touched = {};
};

template <int Dim>
struct EditorOptions {
  Solver<Dim> solver = [](const Constraints<Dim>& c, const FitOptions& o) { return fit<Dim>(c, o); };
  /// Solve after every change. Otherwise when shape() is asked for, and the last good function is then that
  /// of the last good document for which it was: for replays that want the document, and for windows that
  /// draw less often than the mouse moves.
  bool solve_at_once = true;
};

/// It can be moved but not copied: two histories would tell one listener.
template <int Dim>
class Editor {
 public:
  using Listener = std::function<void(const Command<Dim>&, const Editor&)>;

  /// Also without constraints or with an impossible set. With solve_at_once, solves. Throws Error for a
  /// smoothing that is none (below 0, not a number).
  explicit Editor(Document<Dim> document, EditorOptions<Dim> options = {});
  Editor(Editor&&) = default;
  Editor& operator=(Editor&&) = default;

  const Document<Dim>& document() const { return document_; }
  /// How many constraints there are.
  Index size() const { return static_cast<Index>(document_.constraints.size()); }
  /// Of document(), or the last good one and what is wrong. The reference lasts until the next command.
  const Shape<Dim>& shape();
  /// Asks the solver again, for one that had been StillSolving or has a better function now. Neither a change
  /// nor a command: revision and history stay.
  void solve_again();

  /// Grows with every change of the document, undo included, and never repeats.
  std::uint64_t revision() const { return revision_; }
  /// Names the document's state: the same after undo and redo as before, 0 at the start. What was saved at
  /// this state is saved.
  std::uint64_t state() const { return history_.state(); }
  /// The largest there was: states that come about later are larger.
  std::uint64_t newest_state() const { return history_.newest_state(); }

  /// Throws Refused. One solve and time linear in the document.
  Outcome apply(const Action<Dim>& action);

  /// Nothing to undo is no error: the outcome says unchanged. Refused during a gesture.
  Outcome undo();
  Outcome redo();
  std::size_t undo_size() const { return history_.undo_size(); }
  std::size_t redo_size() const { return history_.redo_size(); }
  /// The name of the action that undo() would take back, redo() do again; null where there is none.
  const char* undo_name() const {
    return history_.next_undo() ? history_.next_undo()->name.c_str() : nullptr;
  }
  const char* redo_name() const {
    return history_.next_redo() ? history_.next_redo()->name.c_str() : nullptr;
  }

  /// Until end_gesture() all that is applied is one step to undo. Gestures do not nest: Refused.
  void begin_gesture();
  void end_gesture();
  /// Ends the gesture and takes all of it back, as if it had not been.
  Outcome cancel_gesture();
  bool in_gesture() const { return history_.is_open(); }

  /// Tells the listener, and that is all.
  void label(const std::string& text);

  /// Any of the above.
  Outcome perform(const Command<Dim>& command);

  /// Called after every command that did something, with the command as a replay wants it: actions that asked
  /// the shape a question are answered. One listener; an empty function for none.
  void listen(Listener listener) { listener_ = std::move(listener); }

 private:
  void changed();
  Outcome after(const Command<Dim>& command, Outcome outcome);

  EditorOptions<Dim> options_;
  Document<Dim> document_;
  History<Dim> history_;
  Shape<Dim> shape_;
  std::uint64_t revision_ = 0;
  bool solved_ = false;
  Listener listener_;
};

extern template class Editor<2>;
extern template class Editor<3>;

}  // namespace seesaw
