// Time as a window counts it: real, or a fixed step a frame.
//
// With a fixed step the same events give the same pictures on a fast and a slow machine: a caret blinks and
// an animation moves by frames, not by seconds. That is what scripts and tests want.
#pragma once

#include <algorithm>
#include <chrono>
#include <optional>

namespace seesaw {

class FrameClock {
 public:
  /// Seconds a frame, > 0; nothing for real time.
  explicit FrameClock(std::optional<double> fixed_step) : fixed_step_(fixed_step) {}

  /// Begins a frame. The first is at time 0 and takes no time; real steps are at most a tenth of a second,
  /// so that nothing leaps after a pause.
  void tick() {
    const auto now = std::chrono::steady_clock::now();
    if (frames_ > 0)
      step_ = fixed_step_ ? *fixed_step_ : std::min(std::chrono::duration<double>(now - last_).count(), 0.1);
    time_ = fixed_step_ ? static_cast<double>(frames_) * *fixed_step_ : time_ + step_;
    last_ = now;
    ++frames_;
  }

  double time() const { return time_; }  ///< of this frame, seconds
  double step() const { return step_; }  ///< since the frame before, seconds
  long frames() const { return frames_; }
  bool is_fixed() const { return fixed_step_.has_value(); }

 private:
  std::optional<double> fixed_step_;
  double time_ = 0, step_ = 0;
  long frames_ = 0;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace seesaw
