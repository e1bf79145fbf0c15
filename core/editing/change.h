// What an action did to a document, in a form that runs both ways.
//
// Before it: core/editing/plan.h makes one from an action.  After it: core/editing/history.h keeps it.
//
// Undo must give back every bit. a + d - d is not always a, so nothing is computed backwards: a change holds
// what was there before beside what is there after, and undoing puts the one in place of the other. There are
// only four kinds of patches, however many actions there are.
#pragma once

#include <variant>
#include <vector>

#include "core/scene/document.h"

namespace seesaw {

/// Constraints come in: constraint i stands at at[i] of the document afterwards; `at` ascends.
template <int Dim>
struct Insert {
  std::vector<std::size_t> at = {};
  std::vector<SceneConstraint<Dim>> constraints = {};
};
/// The reverse: constraint i goes from at[i] of the document before.
template <int Dim>
struct Erase {
  std::vector<std::size_t> at = {};
  std::vector<SceneConstraint<Dim>> constraints = {};
};
/// The constraint at at[i] becomes another. Each index once.
template <int Dim>
struct Replace {
  std::vector<std::size_t> at = {};
  std::vector<SceneConstraint<Dim>> before = {}, after = {};
};
/// All but the constraints becomes other: documents with an empty list of constraints.
template <int Dim>
struct ReplaceHead {
  Document<Dim> before, after;
};

template <int Dim>
using Patch = std::variant<Insert<Dim>, Erase<Dim>, Replace<Dim>, ReplaceHead<Dim>>;

/// Patches in the order in which they were laid on; each index is one of the document as it is then.
template <int Dim>
using Change = std::vector<Patch<Dim>>;

/// `document` without its constraints.
template <int Dim>
Document<Dim> head_of(const Document<Dim>& document);

/// Lays the change on the document that it was planned for. Linear in the document at most.
template <int Dim>
void apply_change(const Change<Dim>& change, Document<Dim>& document);
/// Takes it off again, to the bit.
template <int Dim>
void revert_change(const Change<Dim>& change, Document<Dim>& document);

/// Adds `next`, which follows on `change`, to it. Where both end in replacing the same (a drag, a slider) the
/// state between is forgotten, so that a drag of a thousand moves takes the room of one.
template <int Dim>
void append(Change<Dim>& change, Change<Dim> next);

/// The constraints that stand in the document because of it, as indices after it was applied, or after it was
/// reverted; ascending. What a selection wants to know.
template <int Dim>
std::vector<Index> touched_after(const Change<Dim>& change);
template <int Dim>
std::vector<Index> touched_before(const Change<Dim>& change);

}  // namespace seesaw
