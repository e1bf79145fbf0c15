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
    if (up->key == DeskKey::space) space_ = false;
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
  if (event.key == DeskKey::space && event.held == Held{}) {
    space_ = true;
    return std::nullopt;
  }
  const bool drawing = hand_ && (hand_->gesture == Gesture::line || hand_->gesture == Gesture::circle);
  if (drawing && (event.key == DeskKey::plus || event.key == DeskKey::minus)) {
    set_count(count_ + (event.key == DeskKey::plus ? 1 : -1));
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
  if (!is_nudge(command)) close_gesture();
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

void Desk::run_selection(DeskCommand command) {
  using C = DeskCommand;
  const Document<2>& document = editor_.document();
  const Index n = editor_.size();
  switch (command) {
    case C::select_all:
      selection_ = Selection(all_of(document));
      break;
    case C::select_none:
      selection_.clear();
      break;
    case C::select_boundary:
      selection_ = Selection(all_of(document, ConstraintKind::boundary));
      break;
    case C::select_interior:
      selection_ = Selection(all_of(document, ConstraintKind::interior));
      break;
    case C::select_exterior:
      selection_ = Selection(all_of(document, ConstraintKind::exterior));
      break;
    case C::select_normals:
      selection_.clear();
      for (Index i = 0; i < n; ++i)
        if (constraint(i).normal) selection_.add({i});
      break;
    case C::select_culprits:
      if (const auto& impossible = editor_.shape().impossible)
        selection_ = Selection(impossible->culprits);
      else
        say("all constraints are obeyed: there is no culprit");
      break;
    case C::select_next:
      if (n > 0) selection_ = Selection({selection_.empty() ? 0 : (selection_.indices().back() + 1) % n});
      break;
    case C::select_previous:
      if (n > 0)
        selection_ = Selection({selection_.empty() ? n - 1 : (selection_.indices().front() + n - 1) % n});
      break;
    default:
      break;
  }
}

void Desk::run_edit(DeskCommand command) {
  using C = DeskCommand;
  const std::vector<Index> which = selection_.indices();
  const bool any = !which.empty();
  switch (command) {
    case C::undo:
      return undo_or_redo(true);
    case C::redo:
      return undo_or_redo(false);
    case C::delete_selection:
      if (any) did(Delete{which});
      return;
    case C::remove_normals: {
      std::vector<Index> with;
      for (const Index i : which)
        if (constraint(i).normal) with.push_back(i);
      if (!with.empty()) did(RemoveNormal{with});
      return;
    }
    case C::add_normals:
      editor_.begin_gesture();
      for (const Index i : which) {
        const Constraint<2>& each = constraint(i);
        if (each.kind == ConstraintKind::boundary && !each.normal) did(AddNormal{.which = i});
      }
      editor_.end_gesture();
      return;
    case C::make_boundary:
      return make(ConstraintKind::boundary);
    case C::make_interior:
      return make(ConstraintKind::interior);
    case C::make_exterior:
      return make(ConstraintKind::exterior);
    case C::raise_value:
      return lever(1.1);
    case C::lower_value:
      return lever(1 / 1.1);
    case C::nudge_left:
    case C::nudge_far_left:
      return nudge({-1, 0}, command == C::nudge_far_left);
    case C::nudge_right:
    case C::nudge_far_right:
      return nudge({1, 0}, command == C::nudge_far_right);
    case C::nudge_up:
    case C::nudge_far_up:
      return nudge({0, 1}, command == C::nudge_far_up);
    case C::nudge_down:
    case C::nudge_far_down:
      return nudge({0, -1}, command == C::nudge_far_down);
    case C::cage:
      return add(cage_around(document(), view_.scene()), "the cage is there already");
    case C::duplicate: {
      const double step = grid_.on ? grid_step() : 12 * scale_ * view_.pixel();
      if (!any || !room_for(which.size())) return;
      Add<2> copies;
      for (const Index i : which) {
        copies.constraints.push_back(document().constraints[static_cast<std::size_t>(i)]);
        copies.constraints.back().constraint.at += Point<2>(step, -step);
      }
      did(copies);
      return;
    }
    case C::cut:
    case C::copy:
    case C::copy_scene: {
      if (command == C::cut && !any) return;
      const std::string text = command == C::copy_scene ? to_json_text(to_save()) : selection_text();
      options_.clipboard.set ? options_.clipboard.set(text) : void(own_clipboard_ = text);
      if (command == C::cut) did(Delete{which});
      return;
    }
    case C::paste:
    case C::paste_scene: {
      const std::string text = options_.clipboard.get ? options_.clipboard.get() : own_clipboard_;
      command == C::paste ? paste(text) : paste_scene(text);
      return;
    }
    default:
      return;
  }
}

void Desk::run_display(DeskCommand command) {
  using C = DeskCommand;
  const auto toggle = [](bool& which) { which = !which; };
  switch (command) {
    case C::fit:
      return fit();
    case C::zoom_in:
    case C::zoom_out:
      keep_home();
      return view_.zoom(command == C::zoom_in ? 1.25 : 0.8, view_.center());
    case C::toggle_snap:
      toggle(grid_.on);
      return say(grid_.on ? "snapping to the grid, a step of " + to_text(grid_step()) : "no snapping");
    case C::finer_grid:
    case C::coarser_grid: {
      // No finer and no coarser than can be seen.
      const bool coarser = command == C::coarser_grid;
      const double step = next_step(grid_step(), coarser) / view_.pixel();
      if (coarser ? step < view_.width() : step > 4) grid_.chosen = next_step(grid_step(), coarser);
      return say("grid: a step of " + to_text(grid_step()));
    }
    case C::toggle_field:
      return toggle(display_.field);
    case C::toggle_isolines:
      return toggle(display_.isolines);
    case C::toggle_gradient:
      return toggle(display_.gradient);
    case C::toggle_constraints:
      return toggle(display_.constraints);
    case C::toggle_normals:
      return toggle(display_.normals);
    case C::toggle_scale_bar:
      return toggle(display_.scale_bar);
    case C::toggle_grid:
      return toggle(display_.grid);
    case C::toggle_profile:
      if (profile_) {
        profile_.reset();
      } else {
        const Point<2> half(0.4 * view_.pixel() * view_.width(), 0);
        profile_ = ProfileLine{view_.center() - half, view_.center() + half};
      }
      return;
    case C::remember:
      before_ = editor_.shape().function;
      return say(before_ ? "remembered: O compares with it" : "there is no shape to remember yet", !before_);
    case C::compare:
      if (!before_) return say("nothing is remembered yet: M remembers the shape as it is", true);
      return toggle(comparing_);
    case C::compare_kernels: {
      // None, then each of the others, then none again.
      std::vector<std::optional<Kernel>> round = {std::nullopt};
      for (const Kernel each : all_kernels)
        if (each != document().kernel) round.push_back(each);
      const auto here = std::ranges::find(round, other_kernel_);
      other_kernel_ = here == round.end() || here + 1 == round.end() ? round.front() : *(here + 1);
      return;
    }
    default:
      return;
  }
}

bool Desk::did(const Action<2>& action) {
  try {
    const Index before = editor_.size();
    const Outcome outcome = editor_.apply(action);
    selection_.follow(outcome, before, editor_.size());
    if (std::holds_alternative<Restore<2>>(action) && outcome.changed) selection_.clear();
    return true;
  } catch (const Refused& refused) {
    say(refused.what(), true);
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
  editor_.cancel_gesture();
  open_ = Open::none;
  return true;
}

void Desk::undo_or_redo(bool undo) {
  const char* const next = undo ? editor_.undo_name() : editor_.redo_name();
  const std::string name = next ? next : "";
  const Index before = editor_.size();
  const Outcome outcome = undo ? editor_.undo() : editor_.redo();
  selection_.follow_undo(outcome, before, editor_.size(), name == "restore");
  const std::string word = undo ? "undo" : "redo";
  say(outcome.changed ? word + ": " + name : "nothing to " + word);
}

void Desk::nudge(const Point<2>& direction, bool far) {
  if (selection_.empty()) {
    close_gesture();
    keep_home();
    return view_.pan(direction * view_.pixel() * (far ? 400 : 40));
  }
  if (open_ == Open::none) editor_.begin_gesture();
  open_ = Open::nudge;
  did(Move<2>{selection_.indices(), direction * (grid_.on ? grid_step() : view_.pixel()) * (far ? 10 : 1)});
}

// Constraints of one value are set together, so that holding the key down takes the room of one step.
void Desk::lever(double factor) {
  std::vector<std::pair<double, std::vector<Index>>> groups;
  for (const Index i : selection_.indices()) {
    const Constraint<2>& each = constraint(i);
    if (each.kind == ConstraintKind::boundary) continue;
    const auto group = std::ranges::find(groups, each.value, &std::pair<double, std::vector<Index>>::first);
    if (group == groups.end())
      groups.push_back({each.value, {i}});
    else
      group->second.push_back(i);
  }
  if (groups.empty()) return say("select an interior or exterior constraint: its value is the lever");
  if (open_ == Open::none) editor_.begin_gesture();
  open_ = Open::nudge;
  for (const auto& [value, which] : groups) did(SetValue{which, value * factor});
}

void Desk::make(ConstraintKind kind) {
  std::vector<Index> others;
  for (const Index i : selection_.indices())
    if (constraint(i).kind != kind) others.push_back(i);
  if (!others.empty()) did(SetKind{others, kind});
}

void Desk::add(const Constraints<2>& constraints, const char* none_left) {
  Add<2> action;
  for (const Constraint<2>& each : without_doubles(constraints, document()))
    action.constraints.push_back({.constraint = each});
  if (action.constraints.empty()) return say(none_left);
  if (room_for(action.constraints.size())) did(action);
}

bool Desk::room_for(std::size_t more) {
  if (editor_.size() + static_cast<Index>(more) <= options_.most_constraints) return true;
  say("that would be more than " + std::to_string(options_.most_constraints) + " constraints", true);
  return false;
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

const Interpolant<2>* Desk::other() {
  if (!other_kernel_ || *other_kernel_ == document().kernel) return comparing_ ? before_.get() : nullptr;
  if (other_revision_ != revision()) {
    Document<2> same = document();
    same.kernel = *other_kernel_;
    Shape<2> shape;
    solve<2>(shape, same, 0, options_.other_solver);
    other_ = shape.function;
    other_revision_ = revision();
  }
  return other_.get();
}

std::string Desk::other_name() const {
  if (other_kernel_ && *other_kernel_ != document().kernel) return std::string(name_of(*other_kernel_));
  return comparing_ ? "before" : "";
}

void Desk::fit() {
  Document<2> everything = document();
  everything.display.view.reset();
  const auto function = editor_.shape().function;
  if (everything.constraints.empty() || !function)
    view_.show(everything.constraints.empty() ? Box<2>() : grown(box_around(everything), 0.12));
  else
    view_.show(view_box(everything, *function));
}

void Desk::show_as_saved() {
  if (display_.view)
    view_.show(*display_.view);
  else
    fit();
}

void Desk::keep_home() { view_.set_home(box_around(document())); }

}  // namespace seesaw
