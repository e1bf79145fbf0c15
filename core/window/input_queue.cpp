#include "core/window/input_queue.h"

#include <bitset>

namespace seesaw {

namespace {

constexpr std::size_t button_count = 3;

/// What has changed in the frame so far.
struct FrameSoFar {
  std::bitset<button_count + key_count> changed;
  bool any_button = false;

  /// False where it has changed before.
  bool change(std::size_t which) {
    if (changed[which]) return false;
    changed.set(which);
    return true;
  }
  bool button(MouseButton which) {
    any_button = true;
    return change(static_cast<std::size_t>(which));
  }
  bool key(Key which) { return change(button_count + static_cast<std::size_t>(which)); }

  // Does the event still fit into this frame?
  bool operator()(const MouseMoved&) { return !any_button; }
  bool operator()(const MouseLeft&) { return !any_button; }
  bool operator()(const MousePressed& e) { return button(e.button); }
  bool operator()(const MouseReleased& e) { return button(e.button); }
  bool operator()(const KeyPressed& e) { return e.repeat || key(e.key); }
  bool operator()(const KeyReleased& e) { return key(e.key); }
  template <class Other>
  bool operator()(const Other&) {
    return true;
  }
};

bool is_later_move(const InputEvent& before, const InputEvent& event) {
  const auto* a = std::get_if<MouseMoved>(&before);
  const auto* b = std::get_if<MouseMoved>(&event);
  return a && b && a->modifiers == b->modifiers;
}

}  // namespace

std::vector<InputEvent> InputQueue::next_frame() {
  std::vector<InputEvent> frame;
  FrameSoFar so_far;
  while (!waiting_.empty() && std::visit(so_far, waiting_.front())) {
    if (!frame.empty() && is_later_move(frame.back(), waiting_.front())) frame.pop_back();
    frame.push_back(std::move(waiting_.front()));
    waiting_.pop_front();
  }
  return frame;
}

}  // namespace seesaw
