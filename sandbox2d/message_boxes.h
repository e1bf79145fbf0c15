// Questions that must be answered before work goes on: "Save / Don't save / Cancel".
//
// Before it: a window that is to be closed, a copy found after a crash.  After it: the answer's own function.
//
//     Questions questions;
//     questions.ask({"Unsaved changes", "torus.json has changes that are not saved.",
//                    {{"Save", save_and_quit}, {"Don't save", quit}, {"Cancel", {}}}});
//     ... each frame, outside of all panels:  questions.frame();
//
// The first answer is the main button, which Enter presses; Escape gives the last. One question at a time:
// others wait their turn. An answer's function is called when its question is gone, and may ask the next.
#pragma once

#include <deque>
#include <functional>
#include <string>
#include <vector>

namespace seesaw {

struct Answer {
  std::string label;
  std::function<void()> then = {};  ///< may be empty: nothing is to be done
};

struct Question {
  std::string title;
  std::string text;             ///< one or two sentences; \n begins a paragraph
  std::vector<Answer> answers;  ///< one to three
};

class Questions {
 public:
  void ask(Question question);
  /// Draws the present question, if there is one. What an answer's function throws comes out of here, with
  /// the question gone.
  void frame();
  /// Whether one waits for its answer.
  bool open() const { return !waiting_.empty(); }
  /// All are gone, unanswered.
  void clear() { waiting_.clear(); }

 private:
  std::deque<Question> waiting_;  // the first is the present one
  std::string shown_;             // the title of the one on the screen
};

}  // namespace seesaw
