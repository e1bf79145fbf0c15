#include "core/editing/editor.h"

#include "core/editing/plan.h"
#include "core/editing/resolve.h"
#include "core/scene/document_rules.h"

namespace seesaw {

template <int Dim>
const char* name_of(const Command<Dim>& command) {
  if (const auto* action = std::get_if<Action<Dim>>(&command)) return name_of<Dim>(*action);
  // In the order of the variant, behind the actions.
  constexpr const char* names[] = {"undo", "redo", "begin", "end", "cancel", "label"};
  static_assert(std::size(names) + 1 == std::variant_size_v<Command<Dim>>);
  return names[command.index() - 1];
}

template <int Dim>
Editor<Dim>::Editor(Document<Dim> document, EditorOptions<Dim> options)
    : options_(std::move(options)), document_(std::move(document)) {
  if (const auto fault = fault_of(document_)) throw Error(fault->key + ": " + fault->message);
  if (options_.solve_at_once) shape();
}

template <int Dim>
const Shape<Dim>& Editor<Dim>::shape() {
  if (!solved_) solve(shape_, document_, revision_, options_.solver);
  solved_ = true;
  return shape_;
}

template <int Dim>
void Editor<Dim>::solve_again() {
  solved_ = false;
  if (options_.solve_at_once) shape();
}

template <int Dim>
void Editor<Dim>::changed() {
  ++revision_;
  solved_ = false;
  if (options_.solve_at_once) shape();
}

template <int Dim>
Outcome Editor<Dim>::after(const Command<Dim>& command, Outcome outcome) {
  if (outcome.changed) changed();
  if (listener_) listener_(command, *this);
  return outcome;
}

template <int Dim>
Outcome Editor<Dim>::apply(const Action<Dim>& action) {
  const bool asks =
      std::holds_alternative<AddOnSurface<Dim>>(action) || std::holds_alternative<AddNormal>(action);
  const Action<Dim> plain = asks ? resolve(action, document_, shape()) : action;
  Change<Dim> change = plan(plain, document_);
  if (change.empty()) return {};
  apply_change(change, document_);
  Outcome outcome{true, touched_after(change)};
  history_.push(name_of<Dim>(action), std::move(change));
  return after(plain, std::move(outcome));
}

template <int Dim>
Outcome Editor<Dim>::undo() {
  if (in_gesture()) throw Refused("undo: end or cancel the gesture first");
  const Step<Dim>* step = history_.undo(document_);
  if (!step) return {};
  return after(Undo{}, {true, touched_before(step->change)});
}

template <int Dim>
Outcome Editor<Dim>::redo() {
  if (in_gesture()) throw Refused("redo: end or cancel the gesture first");
  const Step<Dim>* step = history_.redo(document_);
  if (!step) return {};
  return after(Redo{}, {true, touched_after(step->change)});
}

template <int Dim>
void Editor<Dim>::begin_gesture() {
  if (in_gesture()) throw Refused("begin: a gesture has begun already, end it first");
  history_.open();
  after(BeginGesture{}, {});
}

template <int Dim>
void Editor<Dim>::end_gesture() {
  if (!in_gesture()) throw Refused("end: no gesture has begun");
  history_.close();
  after(EndGesture{}, {});
}

template <int Dim>
Outcome Editor<Dim>::cancel_gesture() {
  if (!in_gesture()) throw Refused("cancel: no gesture has begun");
  const Change<Dim> change = history_.cancel(document_);
  return after(CancelGesture{}, {!change.empty(), touched_before(change)});
}

template <int Dim>
void Editor<Dim>::label(const std::string& text) {
  after(Label{text}, {});
}

template <int Dim>
Outcome Editor<Dim>::perform(const Command<Dim>& command) {
  struct Perform {
    Editor& editor;
    Outcome operator()(const Action<Dim>& action) { return editor.apply(action); }
    Outcome operator()(const Undo&) { return editor.undo(); }
    Outcome operator()(const Redo&) { return editor.redo(); }
    Outcome operator()(const BeginGesture&) { return editor.begin_gesture(), Outcome{}; }
    Outcome operator()(const EndGesture&) { return editor.end_gesture(), Outcome{}; }
    Outcome operator()(const CancelGesture&) { return editor.cancel_gesture(); }
    Outcome operator()(const Label& each) { return editor.label(each.text), Outcome{}; }
  };
  return std::visit(Perform{*this}, command);
}

template const char* name_of<2>(const Command<2>&);
template const char* name_of<3>(const Command<3>&);
template class Editor<2>;
template class Editor<3>;

}  // namespace seesaw
