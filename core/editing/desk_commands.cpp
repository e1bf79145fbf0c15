// What a desk's commands do, but for those that only a program can.
#include "core/base/text.h"
#include "core/editing/desk.h"
#include "core/editing/resolve.h"
#include "core/scene/document_json.h"
#include "core/scene/document_rules.h"

namespace seesaw {

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
      else if (editor_.shape().pending)
        say("the shape is still being solved: whether there are culprits is not known yet");
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
      return add_normals();
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
      if (!any || !room_for(which.size())) return;
      Add<2> copies;
      for (const Index i : which) {
        copies.constraints.push_back(document().constraints[static_cast<std::size_t>(i)]);
        copies.constraints.back().constraint.at += beside();
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
      if (before_ && editor_.shape().pending)
        return say("remembered as it is drawn, while the newest is still being solved: O compares with it");
      return say(before_ ? "remembered: O compares with it" : "there is no shape to remember yet", !before_);
    case C::compare:
      if (!before_) return say("nothing is remembered yet: M remembers the shape as it is", true);
      toggle(comparing_);
      return say(comparing_ ? "compared with what was remembered, dashed" : "no longer compared");
    case C::compare_kernels: {
      // None, then each of the others, then none again.
      std::vector<std::optional<Kernel>> round = {std::nullopt};
      for (const Kernel each : all_kernels)
        if (each != document().kernel) round.push_back(each);
      const auto here = std::ranges::find(round, other_kernel_);
      other_kernel_ = here == round.end() || here + 1 == round.end() ? round.front() : *(here + 1);
      other_revision_ = ~std::uint64_t{0};
      other_.reset();
      other_pending_ = false;
      return say(other_kernel_
                     ? std::string("compared with the kernel ") + formula_of(*other_kernel_) + ", dashed"
                 : comparing_ ? "compared with what was remembered, dashed"
                              : "no longer compared");
    }
    default:
      return;
  }
}

// A normal that changes f nowhere leaves f to ask for the next: one solve for all of them.
void Desk::add_normals() {
  const Shape<2> shape = editor_.shape();
  editor_.begin_gesture();
  for (const Index i : selection_.indices()) {
    if (constraint(i).kind != ConstraintKind::boundary || constraint(i).normal) continue;
    try {
      did(resolve<2>(AddNormal{.which = i}, document(), shape));
    } catch (const Refused& refused) {
      say(refused.what(), true);
    }
  }
  editor_.end_gesture();
}

void Desk::undo_or_redo(bool undo) {
  const char* const next = undo ? editor_.undo_name() : editor_.redo_name();
  const std::string name = next ? next : "";
  const Index before = editor_.size();
  const Outcome outcome = undo ? editor_.undo() : editor_.redo();
  selection_.follow_undo(outcome, before, editor_.size(), name == "restore");
  if (outcome.changed)
    say(std::string(undo ? "undone: " : "done again: ") + std::string(in_words(name)));
  else
    say(undo ? "nothing to undo" : "nothing to redo");
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

// Of what is selected, or of all interior constraints. Constraints of one value are set together, so that
// holding the key down takes the room of one step.
void Desk::lever(double factor) {
  std::vector<std::pair<double, std::vector<Index>>> groups;
  std::vector<Index> chosen = selection_.indices();
  if (chosen.empty()) chosen = all_of(document(), ConstraintKind::interior);
  for (const Index i : chosen) {
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

Point<2> Desk::beside() const {
  const double step = grid_.on ? grid_step() : 12 * scale_ * view_.pixel();
  return {step, -step};
}

bool Desk::room_for(std::size_t more) {
  if (editor_.size() + static_cast<Index>(more) <= options_.most_constraints) return true;
  say("that would be more than " + std::to_string(options_.most_constraints) + " constraints", true);
  return false;
}

}  // namespace seesaw
