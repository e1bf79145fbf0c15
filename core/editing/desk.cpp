#include "core/editing/desk.h"

#include "core/base/text.h"
#include "core/scene/document_json.h"
#include "core/scene/picture.h"

namespace seesaw {

namespace {

Box<2> box_around(const Document<2>& document) {
  Box<2> box;
  for (const SceneConstraint<2>& each : document.constraints) box.extend(each.constraint.at);
  return box;
}

bool may_repeat(DeskCommand command) {
  switch (command) {
    case DeskCommand::undo:
    case DeskCommand::redo:
    case DeskCommand::select_next:
    case DeskCommand::select_previous:
    case DeskCommand::raise_value:
    case DeskCommand::lower_value:
    case DeskCommand::zoom_in:
    case DeskCommand::zoom_out:
      return true;
    default:
      return command >= DeskCommand::nudge_left && command <= DeskCommand::nudge_far_down;
  }
}

bool is_nudge(DeskCommand command) {
  return (command >= DeskCommand::nudge_left && command <= DeskCommand::nudge_far_down) ||
         command == DeskCommand::raise_value || command == DeskCommand::lower_value;
}

/// While something is in hand the document is the hand's.
bool may_interrupt(DeskCommand command) {
  return command == DeskCommand::cancel || command == DeskCommand::undo ||
         command >= DeskCommand::edit_values ||
         (command >= DeskCommand::fit && command <= DeskCommand::toggle_grid);
}

}  // namespace

Desk::Desk(Document<2> document, DeskOptions options)
    : options_(std::move(options)), editor_(std::move(document), options_.editor) {
  display_ = saved_display_ = editor_.document().display;
  show_as_saved();
}

std::optional<DeskCommand> Desk::handle(const DeskEvent& event) {
  if (const auto* down = std::get_if<KeyDown>(&event)) return key(*down);
  if (const auto* up = std::get_if<KeyUp>(&event)) {
    if (up->key == pan_key) space_ = false;
    if (open_ == Open::nudge) close_gesture();
    return std::nullopt;
  }
  if (const auto* moved = std::get_if<PointerMoved>(&event)) move(*moved);
  if (const auto* wheel = std::get_if<WheelTurned>(&event)) turn_wheel(*wheel);
  if (const auto* down = std::get_if<PointerDown>(&event)) press(*down);
  if (const auto* up = std::get_if<PointerUp>(&event)) return release(*up);
  if (std::holds_alternative<FocusLost>(event)) {
    space_ = false;
    let_go();
  }
  return std::nullopt;
}

std::optional<DeskCommand> Desk::key(const KeyDown& event) {
  if (event.key == pan_key && event.held == Held{}) {
    space_ = true;
    return std::nullopt;
  }
  const bool drawing = hand_ && (hand_->gesture == Gesture::line || hand_->gesture == Gesture::circle);
  if (drawing && (event.key == more_key || event.key == fewer_key)) {
    set_count(count_ + (event.key == more_key ? 1 : -1));
    return std::nullopt;
  }
  const std::optional<DeskCommand> command = command_of(event.key, event.held);
  if (!command || (event.repeat && !may_repeat(*command))) return std::nullopt;
  return run(*command);
}

std::optional<DeskCommand> Desk::perform(DeskCommand command) {
  const std::optional<DeskCommand> left = run(command);
  if (open_ == Open::nudge) close_gesture();  // There is no key to wait for.
  return left;
}

std::optional<DeskCommand> Desk::run(DeskCommand command) {
  using C = DeskCommand;
  if (hand_ && !may_interrupt(command)) return std::nullopt;
  if (command >= C::edit_values) return command;
  if (command == C::cancel || (hand_ && command == C::undo)) {
    if (cancel()) return std::nullopt;
    if (!selection_.empty())
      selection_.clear();
    else
      take(Tool::select);
    return std::nullopt;
  }
  if (!is_nudge(command) || open_ == Open::slider) close_gesture();
  if (command <= C::tool_pan)
    take(static_cast<Tool>(command));
  else if (command <= C::select_previous)
    run_selection(command);
  else if (command < C::fit)
    run_edit(command);
  else
    run_display(command);
  return std::nullopt;
}

bool Desk::did(const Action<2>& action) {
  try {
    const Index before = editor_.size();
    const Outcome outcome = editor_.apply(action);
    selection_.follow(outcome, before, editor_.size());
    if (std::holds_alternative<Restore<2>>(action) && outcome.changed) selection_.clear();
    return true;
  } catch (const Refused& refused) {
    // The action's name is for sessions and scripts; a hand knows what it has done.
    std::string words = refused.what();
    const std::string name = name_of<2>(action) + std::string(": ");
    if (words.starts_with(name)) words.erase(0, name.size());
    say(std::move(words), true);
    return false;
  }
}

bool Desk::apply(const Action<2>& action) {
  let_go();
  return did(action);
}

bool Desk::slide(const Action<2>& action) {
  if (hand_) return false;
  if (open_ == Open::nudge) close_gesture();
  if (open_ == Open::none) {
    editor_.begin_gesture();
    open_ = Open::slider;
  }
  return did(action);
}

void Desk::let_go() {
  if (hand_) end_hand();
  close_gesture();
}

void Desk::close_gesture() {
  if (open_ != Open::none) editor_.end_gesture();
  open_ = Open::none;
}

bool Desk::cancel() {
  if (hand_) {
    if (hand_->open) editor_.cancel_gesture();
    selection_ = hand_->selection;
    profile_ = hand_->profile;
    if (hand_->gesture == Gesture::pan) {
      const double width = view_.width(), height = view_.height();
      view_ = hand_->view;
      view_.resize(width, height);
    }
    hand_.reset();
    return true;
  }
  if (open_ == Open::none) return false;
  const Index before = editor_.size();
  const Outcome outcome = editor_.cancel_gesture();
  selection_.follow_undo(outcome, before, editor_.size(), false);
  open_ = Open::none;
  return true;
}

void Desk::take(Tool tool) {
  if (hand_) return;
  tool_ = tool;
  if (tool == Tool::boundary) kind_ = ConstraintKind::boundary;
  if (tool == Tool::interior) kind_ = ConstraintKind::interior;
  if (tool == Tool::exterior) kind_ = ConstraintKind::exterior;
}

void Desk::select(const std::vector<Index>& indices) {
  std::vector<Index> there;
  for (const Index i : indices)
    if (i >= 0 && i < editor_.size()) there.push_back(i);
  selection_ = Selection(there);
}

void Desk::say(std::string text, bool trouble) { message_ = {std::move(text), trouble, message_.number + 1}; }

std::shared_ptr<const Interpolant<2>> Desk::other() {
  if (!other_kernel_ || *other_kernel_ == document().kernel) return comparing_ ? before_ : nullptr;
  if (other_revision_ != revision()) {
    Document<2> same = document();
    same.kernel = *other_kernel_;
    // What there is stays while the newest is on its way.
    Shape<2> shape{.function = other_};
    solve<2>(shape, same, 0, options_.other_solver);
    other_ = shape.impossible ? nullptr : shape.function;
    other_pending_ = shape.pending;
    other_revision_ = revision();
  }
  return other_;
}

std::string Desk::other_name() const {
  if (other_kernel_ && *other_kernel_ != document().kernel) return std::string(name_of(*other_kernel_));
  return comparing_ ? "before" : "";
}

void Desk::solve_again() {
  editor_.solve_again();
  if (other_pending_) other_revision_ = ~std::uint64_t{0};
  if (fit_when_solved_ && editor_.shape().function) fit();
}

void Desk::fit() {
  Document<2> everything = document();
  everything.display.view.reset();
  const auto function = editor_.shape().function;
  fit_when_solved_ = !function && editor_.shape().pending;
  if (everything.constraints.empty() || !function)
    view_.show(everything.constraints.empty() ? Box<2>() : grown(box_around(everything), 0.12));
  else
    view_.show(view_box(everything, *function));
  show_profile_whole();
}

void Desk::show_profile_whole() {
  if (!profile_) return;
  Box<2> box = view_.scene();
  const auto beyond = [&](const Point<2>& end) { return !box.contains(end); };
  if (!beyond(profile_->from) && !beyond(profile_->to)) return;
  box.extend(profile_->from);
  box.extend(profile_->to);
  view_.show(grown(box, 0.03));
}

void Desk::show_as_saved() {
  if (!display_.view) return fit();
  fit_when_solved_ = false;
  view_.show(*display_.view);
}

// Before a person moves the view: from there on it is theirs.
void Desk::keep_home() {
  view_.set_home(box_around(document()));
  fit_when_solved_ = false;
}

}  // namespace seesaw
