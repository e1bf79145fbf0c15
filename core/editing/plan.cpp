#include "core/editing/plan.h"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "core/base/check.h"
#include "core/scene/document_rules.h"

namespace seesaw {

namespace {

std::vector<std::size_t> numbers_below(std::size_t n) {
  std::vector<std::size_t> result(n);
  std::iota(result.begin(), result.end(), std::size_t{0});
  return result;
}

std::string words_for(std::size_t index) { return "constraint " + std::to_string(index); }

/// Plans one action; the members that are functions of an action are the rules of that action.
template <int Dim>
class Planner {
 public:
  Planner(const Document<Dim>& document, const char* action) : document_(document), action_(action) {}

  Change<Dim> operator()(const Add<Dim>& add) const {
    Insert<Dim> insert;
    for (const SceneConstraint<Dim>& each : add.constraints) {
      const std::size_t index = document_.constraints.size() + insert.at.size();
      if (const auto fault = fault_of(each)) refuse("new " + words_for(index), *fault);
      insert.at.push_back(index);
      insert.constraints.push_back(each);
    }
    if (insert.at.empty()) refuse("there is no constraint to add");
    return {std::move(insert)};
  }

  Change<Dim> operator()(const Move<Dim>& move) const {
    return replace(move.which, [&](SceneConstraint<Dim>& each) { each.constraint.at += move.by; });
  }
  Change<Dim> operator()(const MoveTo<Dim>& move) const {
    return replace({move.which}, [&](SceneConstraint<Dim>& each) { each.constraint.at = move.to; });
  }

  Change<Dim> operator()(const Delete& action) const {
    Erase<Dim> erase;
    erase.at = places(action.which);
    std::ranges::sort(erase.at);
    for (const std::size_t index : erase.at) erase.constraints.push_back(document_.constraints[index]);
    return {std::move(erase)};
  }

  Change<Dim> operator()(const SetValue& set) const {
    return replace(set.which, [&](SceneConstraint<Dim>& each) { each.constraint.value = set.value; });
  }

  Change<Dim> operator()(const SetKind& set) const {
    return replace(set.which, [&](SceneConstraint<Dim>& each) {
      each.constraint.kind = set.kind;
      each.constraint.value = set.value.value_or(set.kind == ConstraintKind::boundary   ? 0.0
                                                 : set.kind == ConstraintKind::interior ? 1.0
                                                                                        : -1.0);
      if (set.kind == ConstraintKind::boundary) return;
      each.constraint.normal.reset();
      each.highlight_normal = false;
    });
  }

  Change<Dim> operator()(const SetNormal<Dim>& set) const {
    boundary_at(document_, set.which, action_);
    return replace({set.which}, [&](SceneConstraint<Dim>& each) { each.constraint.normal = set.normal; });
  }
  Change<Dim> operator()(const TurnNormal<Dim>& turn) const {
    return replace({turn.which}, [&](SceneConstraint<Dim>& each) {
      if (!each.constraint.normal)
        refuse(words_for(static_cast<std::size_t>(turn.which)) + " has no normal: add one first");
      each.constraint.normal->direction = turn.direction;
      if (turn.value) each.constraint.normal->value = *turn.value;
    });
  }
  Change<Dim> operator()(const RemoveNormal& remove) const {
    return replace(remove.which, [](SceneConstraint<Dim>& each) {
      each.constraint.normal.reset();
      each.highlight_normal = false;
    });
  }

  Change<Dim> operator()(const SetKernel& set) const {
    return replace_head([&](Document<Dim>& head) { head.kernel = set.kernel; });
  }
  Change<Dim> operator()(const SetSmoothing& set) const {
    return replace_head([&](Document<Dim>& head) { head.smoothing = set.smoothing; });
  }

  Change<Dim> operator()(const Restore<Dim>& restore) const {
    const Document<Dim>& next = restore.document;
    if (const auto fault = fault_of(next)) refuse("the document", *fault);
    if (const auto fault = fault_of(next.display)) refuse("display", *fault);
    if constexpr (Dim == 3) {
      if (next.camera)
        if (const auto fault = fault_of(*next.camera)) refuse("camera", *fault);
    }
    for (std::size_t i = 0; i < next.constraints.size(); ++i)
      if (const auto fault = fault_of(next.constraints[i])) refuse(words_for(i), *fault);
    // Laid on even where it is the same: -0.0 equals 0.0, and is not the same bits.
    return {Erase<Dim>{numbers_below(document_.constraints.size()), document_.constraints},
            ReplaceHead<Dim>{head_of(document_), head_of(next)},
            Insert<Dim>{numbers_below(next.constraints.size()), next.constraints}};
  }

  // Asked for by the editor before it plans: core/editing/resolve.h.
  Change<Dim> operator()(const AddOnSurface<Dim>&) const { return unresolved(); }
  Change<Dim> operator()(const AddNormal&) const { return unresolved(); }

 private:
  [[noreturn]] void refuse(const std::string& why) const { throw Refused(std::string(action_) + ": " + why); }
  [[noreturn]] void refuse(const std::string& what, const Fault& fault) const {
    refuse(what + ": " + fault.key + ": " + fault.message);
  }

  Change<Dim> unresolved() const {
    SEESAW_CHECK_EQ(std::string(action_), "an action that asks the shape nothing");
    return {};
  }

  /// The indices, checked: there, and each named once.
  std::vector<std::size_t> places(const std::vector<Index>& which) const {
    if (which.empty()) refuse("names no constraint");
    const std::size_t count = document_.constraints.size();
    std::vector<std::size_t> result;
    result.reserve(which.size());
    for (const Index index : which) {
      if (index < 0 || static_cast<std::size_t>(index) >= count)
        refuse("constraint " + std::to_string(index) + " does not exist, there " +
               (count == 0   ? "are none"
                : count == 1 ? "is only 0"
                             : "are " + std::to_string(count) + " (0 to " + std::to_string(count - 1) + ")"));
      result.push_back(static_cast<std::size_t>(index));
    }
    std::vector<std::size_t> sorted = result;
    std::ranges::sort(sorted);
    if (const auto twice = std::ranges::adjacent_find(sorted); twice != sorted.end())
      refuse(words_for(*twice) + " is named twice");
    return result;
  }

  template <class Edit>
  Change<Dim> replace(const std::vector<Index>& which, const Edit& edit) const {
    Replace<Dim> result;
    bool different = false;
    for (const std::size_t index : places(which)) {
      const SceneConstraint<Dim>& before = document_.constraints[index];
      SceneConstraint<Dim> after = before;
      edit(after);
      if (const auto fault = fault_of(after)) refuse(words_for(index), *fault);
      different = different || !(after == before);
      result.at.push_back(index);
      result.before.push_back(before);
      result.after.push_back(std::move(after));
    }
    if (!different) return {};
    return {std::move(result)};
  }

  template <class Edit>
  Change<Dim> replace_head(const Edit& edit) const {
    const Document<Dim> before = head_of(document_);
    Document<Dim> after = before;
    edit(after);
    if (const auto fault = fault_of(after)) refuse(fault->key + ": " + fault->message);
    if (after == before) return {};
    return {ReplaceHead<Dim>{before, std::move(after)}};
  }

  const Document<Dim>& document_;
  const char* action_;
};

}  // namespace

template <int Dim>
const char* name_of(const Action<Dim>& action) {
  // In the order of the variant.
  constexpr const char* names[] = {"add",           "add_on_surface", "move",          "move_to",
                                   "delete",        "set_value",      "set_kind",      "add_normal",
                                   "set_normal",    "turn_normal",    "remove_normal", "set_kernel",
                                   "set_smoothing", "restore"};
  static_assert(std::size(names) == std::variant_size_v<Action<Dim>>);
  return names[action.index()];
}

std::string_view in_words(std::string_view name) {
  constexpr std::pair<std::string_view, std::string_view> words[] = {
      {"add", "adding"},
      {"add_on_surface", "adding"},
      {"move", "moving"},
      {"move_to", "moving"},
      {"delete", "deleting"},
      {"set_value", "another value"},
      {"set_kind", "another kind"},
      {"add_normal", "adding a normal"},
      {"set_normal", "another normal"},
      {"turn_normal", "turning a normal"},
      {"remove_normal", "removing a normal"},
      {"set_kernel", "another kernel"},
      {"set_smoothing", "smoothing"},
      {"restore", "another scene in place of this one"}};
  static_assert(std::size(words) == std::variant_size_v<Action<2>>);
  for (const auto& [action, said] : words)
    if (action == name) return said;
  return name;
}

template <int Dim>
Change<Dim> plan(const Action<Dim>& action, const Document<Dim>& document) {
  return std::visit(Planner<Dim>(document, name_of<Dim>(action)), action);
}

template <int Dim>
const Constraint<Dim>& boundary_at(const Document<Dim>& document, Index index, const char* action) {
  const std::string what = std::string(action) + ": constraint " + std::to_string(index);
  if (index < 0 || static_cast<std::size_t>(index) >= document.constraints.size())
    throw Refused(what + " does not exist, there are " + std::to_string(document.constraints.size()));
  const Constraint<Dim>& constraint = document.constraints[static_cast<std::size_t>(index)].constraint;
  if (constraint.kind != ConstraintKind::boundary)
    throw Refused(what + " is " + name_of(constraint.kind) + ": only a boundary constraint has a normal");
  return constraint;
}

#define SEESAW_INSTANTIATE(Dim)                                             \
  template const char* name_of<Dim>(const Action<Dim>&);                    \
  template Change<Dim> plan<Dim>(const Action<Dim>&, const Document<Dim>&); \
  template const Constraint<Dim>& boundary_at(const Document<Dim>&, Index, const char*);
SEESAW_INSTANTIATE(2)
SEESAW_INSTANTIATE(3)
#undef SEESAW_INSTANTIATE

}  // namespace seesaw
