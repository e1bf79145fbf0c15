// A hand at a desk: what it takes hold of, and what becomes of it when it lets go.
#include <cmath>

#include "core/editing/curve_foot.h"
#include "core/editing/desk.h"
#include "core/scene/crowding.h"

namespace seesaw {

namespace {

/// What a modifier key and a click make; nothing for the other strokes.
std::optional<ConstraintKind> quick_kind(Gesture gesture) {
  if (gesture == Gesture::quick_boundary) return ConstraintKind::boundary;
  if (gesture == Gesture::quick_interior) return ConstraintKind::interior;
  if (gesture == Gesture::quick_exterior) return ConstraintKind::exterior;
  return std::nullopt;
}

}  // namespace

std::vector<Hit> Desk::hits_at(const Point<2>& at) {
  const Tool now = tool();
  const bool sees_profile = profile_ && (now == Tool::select || now == Tool::profile);
  Reaches reaches = options_.reaches;
  for (double Reaches::*each : {&Reaches::constraint, &Reaches::spike, &Reaches::profile, &Reaches::curve})
    reaches.*each *= scale_;
  reaches.spike_length = spike_length();
  return hits(at,
              {.document = document(),
               .display = display_,
               .field = editor_.shape().function.get(),
               .profile = sees_profile ? &*profile_ : nullptr,
               .pixel = view_.pixel()},
              reaches);
}

double Desk::symbol_share() {
  if (spacing_revision_ != revision()) {
    spacing_ = usual_spacing(document());
    spacing_revision_ = revision();
  }
  return seesaw::symbol_share(spacing_, 1 / view_.pixel(), scale_ * options_.reaches.symbol_size);
}

double Desk::spike_length() { return scale_ * options_.reaches.spike_length * symbol_share(); }

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

std::optional<DeskCommand> Desk::release(const PointerUp& event) {
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

}  // namespace seesaw
