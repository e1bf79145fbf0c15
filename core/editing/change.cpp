#include "core/editing/change.h"

#include <algorithm>
#include <iterator>
#include <ranges>

#include "core/base/check.h"

namespace seesaw {

namespace {

template <class... Fs>
struct Overloaded : Fs... {
  using Fs::operator()...;
};

using Places = std::vector<std::size_t>;

template <int Dim>
void insert(Document<Dim>& document, const Places& at, const std::vector<SceneConstraint<Dim>>& constraints) {
  auto& list = document.constraints;
  if (at.empty()) return;
  SEESAW_CHECK_EQ(at.size(), constraints.size());
  SEESAW_CHECK_LT(at.back(), list.size() + at.size());
  std::size_t old = list.size(), next = at.size();
  list.resize(list.size() + at.size());
  // From the back, so that each constraint moves once.
  for (std::size_t i = list.size(); next > 0; --i) {
    if (at[next - 1] == i - 1) {
      --next;
      list[i - 1] = constraints[next];
    } else {
      --old;
      list[i - 1] = std::move(list[old]);
    }
  }
}

template <int Dim>
void erase(Document<Dim>& document, const Places& at) {
  auto& list = document.constraints;
  if (at.empty()) return;
  SEESAW_CHECK_LT(at.back(), list.size());
  std::size_t kept = at.front(), next = 0;
  for (std::size_t i = kept; i < list.size(); ++i) {
    if (next < at.size() && at[next] == i) {
      ++next;
    } else {
      list[kept++] = std::move(list[i]);
    }
  }
  SEESAW_CHECK_EQ(next, at.size());
  list.resize(kept);
}

template <int Dim>
void replace(Document<Dim>& document, const Places& at,
             const std::vector<SceneConstraint<Dim>>& constraints) {
  for (std::size_t i = 0; i < at.size(); ++i) {
    SEESAW_CHECK_LT(at[i], document.constraints.size());
    document.constraints[at[i]] = constraints[i];
  }
}

template <int Dim>
void replace_head(Document<Dim>& document, Document<Dim> head) {
  head.constraints = std::move(document.constraints);
  document = std::move(head);
}

// Ascending indices that insertions and removals push around while the patches are gone through.
class Touched {
 public:
  void insert(const Places& at) {
    std::size_t passed = 0;
    for (std::size_t& each : indices_) {
      while (passed < at.size() && at[passed] <= each + passed) ++passed;
      each += passed;
    }
    add(at);
  }
  void erase(const Places& at) {
    Places kept;
    std::size_t passed = 0;
    for (const std::size_t each : indices_) {
      while (passed < at.size() && at[passed] < each) ++passed;
      if (passed == at.size() || at[passed] != each) kept.push_back(each - passed);
    }
    indices_ = std::move(kept);
  }
  void add(const Places& at) {
    indices_.insert(indices_.end(), at.begin(), at.end());
    std::ranges::sort(indices_);
    indices_.erase(std::ranges::unique(indices_).begin(), indices_.end());
  }
  std::vector<Index> result() const { return {indices_.begin(), indices_.end()}; }

 private:
  Places indices_;
};

}  // namespace

template <int Dim>
Document<Dim> head_of(const Document<Dim>& document) {
  Document<Dim> head;
  head.kernel = document.kernel;
  head.smoothing = document.smoothing;
  head.title = document.title;
  head.description = document.description;
  head.figure = document.figure;
  head.display = document.display;
  head.camera = document.camera;
  head.extras = document.extras;
  return head;
}

template <int Dim>
void apply_change(const Change<Dim>& change, Document<Dim>& document) {
  for (const Patch<Dim>& patch : change)
    std::visit(Overloaded{[&](const Insert<Dim>& p) { insert(document, p.at, p.constraints); },
                          [&](const Erase<Dim>& p) { erase(document, p.at); },
                          [&](const Replace<Dim>& p) { replace(document, p.at, p.after); },
                          [&](const ReplaceHead<Dim>& p) { replace_head(document, p.after); }},
               patch);
}

template <int Dim>
void revert_change(const Change<Dim>& change, Document<Dim>& document) {
  for (const Patch<Dim>& patch : std::views::reverse(change))
    std::visit(Overloaded{[&](const Insert<Dim>& p) { erase(document, p.at); },
                          [&](const Erase<Dim>& p) { insert(document, p.at, p.constraints); },
                          [&](const Replace<Dim>& p) { replace(document, p.at, p.before); },
                          [&](const ReplaceHead<Dim>& p) { replace_head(document, p.before); }},
               patch);
}

template <int Dim>
void append(Change<Dim>& change, Change<Dim> next) {
  if (change.size() > 0 && next.size() == 1) {
    auto* last = std::get_if<Replace<Dim>>(&change.back());
    auto* more = std::get_if<Replace<Dim>>(&next.front());
    if (last && more && last->at == more->at) {
      last->after = std::move(more->after);
      return;
    }
    auto* last_head = std::get_if<ReplaceHead<Dim>>(&change.back());
    auto* more_head = std::get_if<ReplaceHead<Dim>>(&next.front());
    if (last_head && more_head) {
      last_head->after = std::move(more_head->after);
      return;
    }
  }
  std::ranges::move(next, std::back_inserter(change));
}

template <int Dim>
std::vector<Index> touched_after(const Change<Dim>& change) {
  Touched touched;
  for (const Patch<Dim>& patch : change)
    std::visit(Overloaded{[&](const Insert<Dim>& p) { touched.insert(p.at); },
                          [&](const Erase<Dim>& p) { touched.erase(p.at); },
                          [&](const Replace<Dim>& p) { touched.add(p.at); }, [](const ReplaceHead<Dim>&) {}},
               patch);
  return touched.result();
}

template <int Dim>
std::vector<Index> touched_before(const Change<Dim>& change) {
  Touched touched;
  for (const Patch<Dim>& patch : std::views::reverse(change))
    std::visit(Overloaded{[&](const Insert<Dim>& p) { touched.erase(p.at); },
                          [&](const Erase<Dim>& p) { touched.insert(p.at); },
                          [&](const Replace<Dim>& p) { touched.add(p.at); }, [](const ReplaceHead<Dim>&) {}},
               patch);
  return touched.result();
}

#define SEESAW_INSTANTIATE(Dim)                                         \
  template Document<Dim> head_of(const Document<Dim>&);                 \
  template void apply_change<Dim>(const Change<Dim>&, Document<Dim>&);  \
  template void revert_change<Dim>(const Change<Dim>&, Document<Dim>&); \
  template void append<Dim>(Change<Dim>&, Change<Dim>);                 \
  template std::vector<Index> touched_after<Dim>(const Change<Dim>&);   \
  template std::vector<Index> touched_before<Dim>(const Change<Dim>&);
SEESAW_INSTANTIATE(2)
SEESAW_INSTANTIATE(3)
#undef SEESAW_INSTANTIATE

}  // namespace seesaw
