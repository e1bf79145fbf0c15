// Inside core/window: plays a script, one frame at a time.
//
// A command becomes beats, one a frame: a click is a move, a press, a release, because a user interface must
// have seen the pointer over a button before it is pressed, and must see it pressed before it is let go.
//
// Before it: script.h. After it: window.cpp, which lets it act before each frame.
#pragma once

#include <deque>
#include <functional>

#include "core/window/script.h"

namespace seesaw::detail {

/// What a script can do to a window.
struct ScriptStage {
  std::function<void(const InputEvent&)> push;
  std::function<void(int width, int height)> resize;
  std::function<void(const std::filesystem::path&)> screenshot;
  /// The middle of the widget of that name. Throws Error where there is none.
  std::function<Point<2>(const std::string&)> find;
};

class ScriptPlayer {
 public:
  explicit ScriptPlayer(Script script) : script_(std::move(script)) {}

  /// Does the next frame's beat. Throws FileError, naming the script's line, where it cannot be done.
  void beat(const ScriptStage& stage);
  /// Whether all beats have been done.
  bool over() const { return next_ == script_.lines.size() && beats_.empty(); }
  /// For errors of what was asked for in the last beat.
  [[noreturn]] void refuse(const std::string& message) const;

 private:
  using Beat = std::function<void(const ScriptStage&)>;
  struct Expand;

  void move(const ScriptStage& stage, const Point<2>& to);

  Script script_;
  std::size_t next_ = 0;
  int line_ = 0;
  std::deque<Beat> beats_;
  Point<2> pointer_ = Point<2>::Zero();
  Modifiers held_ = {};
};

}  // namespace seesaw::detail
