// A short guided tour: the three kinds of constraints, normals, the see-saw, and new constraints on the
// curve.
//
// Each step sets up a scene, says what is so and why, and asks for one thing to be done; it sees when that
// has been done, on the document, however it was done. One can go on and back at any time.
//
// Before it: F3. After it: the desk has the step's scene; a panel over the scene has its words.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/editing/desk.h"

namespace seesaw {

struct TourStep {
  const char* title;
  const char* words;  ///< what is so, and why
  const char* task;   ///< what to do; empty for nothing
  std::function<Document<2>()> scene;
  /// Whether it has been done, from the step's scene to the document as it is.
  std::function<bool(const Document<2>& scene, Desk& desk)> done;
  bool plate = false;
  std::optional<ProfileLine> profile = {};
  std::vector<Index> pointed = {};  ///< constraints that the words speak of
  Tool tool = Tool::select;
};

const std::vector<TourStep>& tour_steps();

class Tour {
 public:
  bool running() const { return step_ >= 0; }
  /// 0-based; -1 where it is not running.
  int step() const { return step_; }
  bool done() const { return done_; }

  /// Begins with step `step`, whose scene becomes the desk's document. What is open and unsaved is the
  /// caller's business. Throws FileError where a scene cannot be read.
  void go_to(int step, Desk& desk);
  void stop() { step_ = -1; }
  /// Looks whether what was asked has been done. Each frame.
  void watch(Desk& desk);
  /// The step's constraints, until it is done.
  std::vector<Index> pointed() const;

  enum class Wish { none, back, next, stop };
  /// Its panel; what was pressed.
  Wish frame(const Rect& place);

 private:
  int step_ = -1;
  bool done_ = false;
  Document<2> start_;
};

}  // namespace seesaw
