// Which constraints are selected: indices that are always good.
//
// Before it: clicks, rubber bands, "all".  After it: whatever is done to several constraints at once.
//
// Indices are those of the document as it is, so every change of the document is told (`follow`): after an
// undo those that came back are selected, after a deletion none is, and a drag keeps what is dragged.
#pragma once

#include <vector>

#include "core/editing/editor.h"

namespace seesaw {

class Selection {
 public:
  Selection() = default;
  /// In any order, also twice.
  explicit Selection(std::vector<Index> indices);

  /// Ascending, each once.
  const std::vector<Index>& indices() const { return indices_; }
  Index size() const { return static_cast<Index>(indices_.size()); }
  bool empty() const { return indices_.empty(); }
  bool contains(Index index) const;

  void add(const std::vector<Index>& more);
  void toggle(Index index);
  void clear() { indices_.clear(); }

  /// After an action: new constraints are selected. `before` and `now` are how many there were and are.
  void follow(const Outcome& done, Index before, Index now);
  /// After an undo or redo: what is different is selected, unless it is already, with others. Of a document
  /// that became another (`all`), none.
  void follow_undo(const Outcome& done, Index before, Index now, bool all);

  bool operator==(const Selection&) const = default;

 private:
  std::vector<Index> indices_;
};

/// Constraints of the document, ascending: all; of a kind; with a place in `box`, its rim included.
template <int Dim>
std::vector<Index> all_of(const Document<Dim>& document);
template <int Dim>
std::vector<Index> all_of(const Document<Dim>& document, ConstraintKind kind);
template <int Dim>
std::vector<Index> all_in(const Document<Dim>& document, const Box<Dim>& box);

}  // namespace seesaw
