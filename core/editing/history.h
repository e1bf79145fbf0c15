// What was done, and what was undone: two piles of changes.
//
// Before it: core/editing/change.h.  After it: core/editing/editor.h.
//
// A step is what one Undo takes back: one action, or all actions of a gesture (a drag).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/editing/change.h"

namespace seesaw {

template <int Dim>
struct Step {
  /// For a menu: "Undo move".
  std::string name;
  Change<Dim> change;
  /// Names the document after it: no two documents of one editor's life that came about differently share
  /// one.
  std::uint64_t state = 0;
};

template <int Dim>
class History {
 public:
  /// What has just been laid on the document. What had been undone is forgotten.
  void push(const char* name, Change<Dim> change);

  /// Takes the last step off `document`, or lays the next one on again. Null where there is none; the step
  /// lives until the next call.
  const Step<Dim>* undo(Document<Dim>& document);
  const Step<Dim>* redo(Document<Dim>& document);

  const Step<Dim>* next_undo() const { return done_.empty() ? nullptr : &done_.back(); }
  const Step<Dim>* next_redo() const { return undone_.empty() ? nullptr : &undone_.back(); }
  std::size_t undo_size() const { return done_.size(); }
  std::size_t redo_size() const { return undone_.size(); }
  /// Of the document as it is; 0 at the start.
  std::uint64_t state() const { return done_.empty() ? 0 : done_.back().state; }

  /// The largest that was ever given.
  std::uint64_t newest_state() const { return states_; }

  /// From here to close() everything is one step.
  void open() { open_ = true, fresh_ = true; }
  void close() {
    open_ = false;
    parked_.clear();
  }
  bool is_open() const { return open_; }
  /// Takes what the open gesture has done off again, forgets it, and closes: what had been undone before can
  /// be redone again. Gives the change taken off.
  Change<Dim> cancel(Document<Dim>& document);

 private:
  std::vector<Step<Dim>> done_, undone_;
  std::vector<Step<Dim>> parked_;  // undone_ of before the open gesture, for cancel()
  std::uint64_t states_ = 0;
  bool open_ = false;
  bool fresh_ = false;  // open, and nothing done in it yet
};

}  // namespace seesaw
