// What a hand that is moving does, and the wheel.
#include <cmath>

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

/// `v` turned to the nearest of 24 directions, its length along that.
Point<2> in_steps(const Point<2>& v) {
  const double step = M_PI / 12, angle = step * std::round(std::atan2(v.y(), v.x()) / step);
  // Along the axes exactly.
  const auto exact = [](double x) { return std::abs(x) < 1e-15 ? 0.0 : x; };
  const Point<2> direction(exact(std::cos(angle)), exact(std::sin(angle)));
  return direction * v.dot(direction);
}

}  // namespace

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
    turn.value = hand_->value * direction.stableNorm() / (spike_length() * view_.pixel());
  open_gesture();
  did(turn);
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
