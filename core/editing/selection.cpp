#include "core/editing/selection.h"

#include <algorithm>

namespace seesaw {

namespace {

template <int Dim, class Test>
std::vector<Index> all_that(const Document<Dim>& document, const Test& test) {
  std::vector<Index> result;
  for (std::size_t i = 0; i < document.constraints.size(); ++i)
    if (test(document.constraints[i].constraint)) result.push_back(static_cast<Index>(i));
  return result;
}

}  // namespace

Selection::Selection(std::vector<Index> indices) { add(indices); }

bool Selection::contains(Index index) const { return std::ranges::binary_search(indices_, index); }

void Selection::add(const std::vector<Index>& more) {
  indices_.insert(indices_.end(), more.begin(), more.end());
  std::ranges::sort(indices_);
  indices_.erase(std::ranges::unique(indices_).begin(), indices_.end());
}

void Selection::toggle(Index index) {
  const auto place = std::ranges::lower_bound(indices_, index);
  if (place != indices_.end() && *place == index)
    indices_.erase(place);
  else
    indices_.insert(place, index);
}

void Selection::follow(const Outcome& done, Index before, Index now) {
  if (done.changed && before != now) indices_ = done.touched;
}

void Selection::follow_undo(const Outcome& done, Index before, Index now, bool all) {
  if (!done.changed) return;
  if (all)
    clear();
  else if (before != now || !std::ranges::includes(indices_, done.touched))
    indices_ = done.touched;
}

template <int Dim>
std::vector<Index> all_of(const Document<Dim>& document) {
  return all_that(document, [](const Constraint<Dim>&) { return true; });
}
template <int Dim>
std::vector<Index> all_of(const Document<Dim>& document, ConstraintKind kind) {
  return all_that(document, [&](const Constraint<Dim>& each) { return each.kind == kind; });
}
template <int Dim>
std::vector<Index> all_in(const Document<Dim>& document, const Box<Dim>& box) {
  return all_that(document, [&](const Constraint<Dim>& each) { return box.contains(each.at); });
}

#define SEESAW_INSTANTIATE(Dim)                                             \
  template std::vector<Index> all_of(const Document<Dim>&);                 \
  template std::vector<Index> all_of(const Document<Dim>&, ConstraintKind); \
  template std::vector<Index> all_in(const Document<Dim>&, const Box<Dim>&);
SEESAW_INSTANTIATE(2)
SEESAW_INSTANTIATE(3)
#undef SEESAW_INSTANTIATE

}  // namespace seesaw
