// A gesture of the pointer: the press that begins it, the drag, the click, the end.
#include <cmath>

#include "core/editing/curve_foot.h"
#include "core/editing/desk.h"

namespace seesaw {

namespace {

bool moves_constraints(Gesture gesture) {
  return gesture == Gesture::grab || gesture == Gesture::toggle || gesture == Gesture::beneath ||
         gesture == Gesture::values || gesture == Gesture::place || gesture == Gesture::on_curve;
}

bool turns_normal(Gesture gesture) {
  return gesture == Gesture::turn || gesture == Gesture::give_normal || gesture == Gesture::place_normal;
}

/// What a modifier key and a click make; nothing for the other strokes.
std::optional<ConstraintKind> quick_kind(Gesture gesture) {
  if (gesture == Gesture::quick_boundary) return ConstraintKind::boundary;
  if (gesture == Gesture::quick_interior) return ConstraintKind::interior;
  if (gesture == Gesture::quick_exterior) return ConstraintKind::exterior;
  return std::nullopt;
}

/// `v` turned to the nearest of 24 directions, its length along that.
Point<2> in_steps(const Point<2>& v) {
  const double step = M_PI / 12, angle = step * std::round(std::atan2(v.y(), v.x()) / step);
  // Along the axes exactly.
  const auto exact = [](double x) { return std::abs(x) < 1e-15 ? 0.0 : x; };
  const Point<2> direction(exact(std::cos(angle)), exact(std::sin(angle)));
  return direction * v.dot(direction);
}

}  // namespace

std::vector<Hit> Desk::hits_at(const Point<2>& at) {
  const Tool now = tool();
  const bool sees_profile = profile_ && (now == Tool::select || now == Tool::profile);
  Reaches reaches = options_.reaches;
  for (double Reaches::*each :
       {&Reaches::constraint, &Reaches::spike, &Reaches::profile, &Reaches::curve, &Reaches::spike_length})
    reaches.*each *= scale_;
  return hits(at,
              {.document = document(),
               .display = display_,
               .field = editor_.shape().function.get(),
               .profile = sees_profile ? &*profile_ : nullptr,
               .pixel = view_.pixel()},
              reaches);
}

Hit Desk::hover() {
  if (hand_) {
    Hit hit = hand_->hit;
    if (hand_->which >= 0) {
      hit.which = hand_->which;
      if (hit.over != Over::spike) hit.over = Over::constraint;
      hit.at = constraint(hit.which).at;
    }
    return hit;
  }
  if (!cursor_) return {};
  const std::vector<Hit> found = hits_at(*cursor());
  return found.empty() ? Hit{} : found.front();
}

std::optional<Point<2>> Desk::cursor() const {
  if (!cursor_) return std::nullopt;
  return view_.scene_from_pixel(*cursor_);
}

void Desk::press(const PointerDown& event) {
  if (!event.at.allFinite()) return;
  cursor_ = view_.pixel_from_scene(event.at);
  if (hand_) return;
  close_gesture();
  const std::vector<Hit> found = hits_at(event.at);
  const Hit hit = found.empty() ? Hit{} : found.front();
  const Gesture gesture = gesture_of(tool(), hit.over, event.button, event.held, event.clicks);
  if (gesture == Gesture::none) return;
  hand_ = Hand{.gesture = gesture,
               .button = event.button,
               .hit = hit,
               .pressed = event.at,
               .end = event.at,
               .selection = selection_,
               .profile = profile_,
               .view = view_};
  begin_hand(event, found);
}

void Desk::begin_hand(const PointerDown& event, const std::vector<Hit>& found) {
  Hand& hand = *hand_;
  bool ready = true;
  switch (hand.gesture) {
    case Gesture::grab:
    case Gesture::toggle:
    case Gesture::values:
    case Gesture::turn:
      hand.which = hand.hit.which;
      if (hand.gesture != Gesture::toggle && !selection_.contains(hand.which))
        selection_ = Selection({hand.which});
      break;
    case Gesture::beneath: {
      // The next in the pile after the one that is selected; around and around.
      std::vector<Index> pile;
      for (const Hit& each : found)
        if (each.over == Over::constraint) pile.push_back(each.which);
      const auto top = std::ranges::find_if(pile, [&](Index i) { return selection_.contains(i); });
      const std::size_t place = top == pile.end() ? 0 : static_cast<std::size_t>(top - pile.begin());
      hand.which = pile[(place + 1) % pile.size()];
      selection_ = Selection({hand.which});
      break;
    }
    case Gesture::place:
    case Gesture::on_curve:
    case Gesture::place_normal: {
      open_gesture();
      const bool with_kind = hand.gesture == Gesture::place;
      ready = place(with_kind ? kind_ : ConstraintKind::boundary, event.at, event.held);
      if (ready && hand.gesture == Gesture::place_normal) give_normal();
      break;
    }
    case Gesture::give_normal:
      open_gesture();
      hand.which = hand.hit.which;
      selection_ = Selection({hand.which});
      ready = give_normal();
      break;
    case Gesture::line:
    case Gesture::circle:
    case Gesture::profile:
      hand.pressed = hand.end = snapped(event.at, event.held);
      break;
    case Gesture::move_profile:
      hand.origin = hand.hit.over == Over::profile_end ? profile_->to : profile_->from;
      hand.grip = hand.origin - event.at;
      break;
    default:
      break;
  }
  if (!ready) {
    // What was selected instead stays.
    const Selection selected = selection_;
    cancel();
    selection_ = selected;
    return;
  }
  if (hand.which >= 0) {
    const Constraint<2>& each = constraint(hand.which);
    hand.origin = each.at;
    hand.grip = hand.origin - event.at;
    if (each.normal) hand.value = each.normal->value;
  }
}

void Desk::open_gesture() {
  if (hand_->open) return;
  editor_.begin_gesture();
  hand_->open = true;
}

bool Desk::place(ConstraintKind kind, const Point<2>& at, const Held& held) {
  Point<2> where = snapped(at, held);
  const auto function = editor_.shape().function;
  if (kind == ConstraintKind::boundary && function && !in_effect(DragEffect::free, held))
    if (const auto foot = curve_foot(*function, at, options_.reaches.curve * scale_ * view_.pixel()))
      where = *foot;
  for (Index i = 0; i < editor_.size(); ++i)
    if (constraint(i).at == where) {
      say("there is a constraint in this place already: it is selected");
      selection_ = Selection({i});
      return false;
    }
  if (!room_for(1) || !did(Add<2>{{{.constraint = fresh(kind, where)}}})) return false;
  hand_->which = editor_.size() - 1;
  return true;
}

bool Desk::give_normal() {
  const Constraint<2>& each = constraint(hand_->which);
  return each.normal || did(AddNormal{.which = hand_->which});
}

void Desk::move(const PointerMoved& event) {
  if (!event.at.allFinite()) return;
  cursor_ = view_.pixel_from_scene(event.at);
  if (!hand_) return;
  hand_->moved = hand_->moved ||
                 (event.at - hand_->pressed).stableNorm() > options_.drag_threshold * scale_ * view_.pixel();
  if (hand_->moved) drag(event.at, event.held);
}

void Desk::drag(const Point<2>& at, const Held& held) {
  Hand& hand = *hand_;
  if (moves_constraints(hand.gesture)) return drag_constraints(at, held);
  if (turns_normal(hand.gesture)) return turn_normal(at, held);
  switch (hand.gesture) {
    case Gesture::pan: {
      keep_home();
      view_.pan(hand.pressed - at);
      // Where it could not follow, the hand takes hold anew.
      hand.pressed = *cursor();
      break;
    }
    case Gesture::band:
    case Gesture::quick_boundary:
    case Gesture::quick_interior:
    case Gesture::quick_exterior:
      hand.end = at;
      selection_ = hand.gesture == Gesture::band ? Selection() : hand.selection;
      if (display_.constraints) selection_.add(all_in(document(), *band()));
      break;
    case Gesture::line:
    case Gesture::circle:
      hand.end = line_end(at, held);
      break;
    case Gesture::profile:
      profile_ = ProfileLine{hand.pressed, line_end(at, held)};
      break;
    case Gesture::move_profile:
      if (hand.hit.over == Over::profile) {
        const Point<2> by = at + hand.grip - hand.origin;
        profile_ = ProfileLine{hand.profile->from + by, hand.profile->to + by};
      } else {
        const bool start = hand.hit.over == Over::profile_start;
        Point<2> to = snapped(at + hand.grip, held);
        const Point<2>& fixed = start ? profile_->to : profile_->from;
        if (in_effect(DragEffect::straight, held)) to = fixed + in_steps(to - fixed);
        (start ? profile_->from : profile_->to) = to;
      }
      break;
    default:
      break;
  }
}

Point<2> Desk::snapped(const Point<2>& at, const Held& held) const {
  return grid_.on && !in_effect(DragEffect::free, held) ? grid_.nearest(at, view_.pixel()) : at;
}

Point<2> Desk::line_end(const Point<2>& at, const Held& held) const {
  if (in_effect(DragEffect::straight, held)) return hand_->pressed + in_steps(at - hand_->pressed);
  return snapped(at, held);
}

void Desk::drag_constraints(const Point<2>& at, const Held& held) {
  Hand& hand = *hand_;
  if (!selection_.contains(hand.which)) selection_.add({hand.which});
  open_gesture();
  Point<2> to = snapped(at + hand.grip, held);
  if (in_effect(DragEffect::straight, held)) {
    const Point<2> way = at + hand.grip - hand.origin;
    const int still = std::abs(way.x()) >= std::abs(way.y()) ? 1 : 0;
    to[still] = hand.origin[still];
  }
  const Point<2> here = constraint(hand.which).at;
  if (to == here) return;
  if (selection_.size() == 1)
    did(MoveTo<2>{hand.which, to});
  else
    did(Move<2>{selection_.indices(), to - here});
}

void Desk::turn_normal(const Point<2>& at, const Held& held) {
  const Index which = hand_->which;
  const Constraint<2>& each = constraint(which);
  Point<2> direction = at - each.at;
  if (!each.normal || direction.isZero(0)) return;
  if (in_effect(DragEffect::straight, held)) direction = in_steps(direction);
  TurnNormal<2> turn{.which = which, .direction = direction.stableNormalized()};
  if (in_effect(DragEffect::value, held))
    turn.value =
        hand_->value * direction.stableNorm() / (options_.reaches.spike_length * scale_ * view_.pixel());
  open_gesture();
  did(turn);
}

std::optional<DeskCommand> Desk::release(const PointerUp& event) {
  if (!event.at.allFinite()) return std::nullopt;
  move({event.at, event.held});
  if (!hand_ || hand_->button != event.button) return std::nullopt;
  std::optional<DeskCommand> left;
  if (!hand_->moved) left = click();
  end_hand();
  return left;
}

std::optional<DeskCommand> Desk::click() {
  const Hand& hand = *hand_;
  if (const auto kind = quick_kind(hand.gesture)) {
    if (hand.hit.over == Over::constraint) {
      const Index which = hand.hit.which;
      if (constraint(which).kind != *kind) did(SetKind{{which}, *kind});
      selection_ = Selection({which});
    } else {
      // The modifier keys say which kind; they are not those of a drag.
      open_gesture();
      place(*kind, hand.pressed, {});
    }
    return std::nullopt;
  }
  switch (hand.gesture) {
    case Gesture::grab:
      selection_ = Selection({hand.which});
      break;
    case Gesture::toggle:
      selection_.toggle(hand.which);
      break;
    case Gesture::band:
      selection_.clear();
      break;
    case Gesture::center:
      keep_home();
      view_.center_on(hand.pressed);
      break;
    case Gesture::values:
      return DeskCommand::edit_values;
    default:
      break;
  }
  return std::nullopt;
}

void Desk::end_hand() {
  Hand& hand = *hand_;
  if (hand.moved && (hand.gesture == Gesture::line || hand.gesture == Gesture::circle)) {
    Constraints<2> added;
    const Points<2> places = preview();
    for (Index i = 0; i < places.cols(); ++i) added.push_back(fresh(kind_, places.col(i)));
    add(added, "there are constraints in all these places already");
  }
  if (hand.open) {
    // What was dragged back to where it came from was not dragged.
    const bool old = hand.gesture == Gesture::grab || hand.gesture == Gesture::toggle ||
                     hand.gesture == Gesture::beneath || hand.gesture == Gesture::values;
    if (old && constraint(hand.which).at == hand.origin)
      editor_.cancel_gesture();
    else
      editor_.end_gesture();
  }
  hand_.reset();
}

std::optional<Box<2>> Desk::band() const {
  if (!hand_ || !hand_->moved || !(hand_->gesture == Gesture::band || quick_kind(hand_->gesture)))
    return std::nullopt;
  return Box<2>(hand_->pressed.cwiseMin(hand_->end), hand_->pressed.cwiseMax(hand_->end));
}

Points<2> Desk::preview() const {
  if (hand_ && hand_->moved && hand_->gesture == Gesture::line)
    return points_on_line(hand_->pressed, hand_->end, count_);
  if (hand_ && hand_->moved && hand_->gesture == Gesture::circle)
    return points_on_circle(hand_->pressed, hand_->end, count_);
  return Points<2>(2, 0);
}

void Desk::turn_wheel(const WheelTurned& event) {
  if (!event.at.allFinite() || !std::isfinite(event.up) || !std::isfinite(event.right)) return;
  const bool drawing = gesture() == Gesture::line || gesture() == Gesture::circle;
  keep_home();
  switch (wheel_use(drawing, event.held)) {
    case WheelUse::count:
      set_count(count_ + (event.up > 0 ? 1 : event.up < 0 ? -1 : 0));
      break;
    case WheelUse::across:
      view_.pan({40 * view_.pixel() * (event.right - event.up), 0});
      break;
    case WheelUse::zoom:
      view_.zoom(std::exp2(0.25 * std::clamp(event.up, -40.0, 40.0)), event.at);
      view_.pan({40 * view_.pixel() * event.right, 0});
      break;
  }
  cursor_ = view_.pixel_from_scene(event.at);
}

}  // namespace seesaw
