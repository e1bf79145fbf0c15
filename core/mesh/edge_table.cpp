#include "core/mesh/edge_table.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/base/check.h"

namespace seesaw {

EdgeTable::EdgeTable(const Faces& faces, Index vertices) {
  const Index half_edges = 3 * faces.cols();
  SEESAW_CHECK_LE(half_edges, Index{std::numeric_limits<int>::max()});
  if (faces.cols() > 0) {
    SEESAW_CHECK_LE(0, faces.minCoeff());
    SEESAW_CHECK_LT(Index{faces.maxCoeff()}, vertices);
  }
  const auto size = [](Index n) { return static_cast<std::size_t>(n); };
  const auto skip = [&](Index f) {
    return faces(0, f) == faces(1, f) || faces(1, f) == faces(2, f) || faces(2, f) == faces(0, f);
  };
  // A counting sort by the smaller vertex; then only the few edges around one vertex are left to sort.
  std::vector<int> begin(size(vertices) + 1, 0);
  for (Index h = 0; h < half_edges; ++h)
    if (!skip(h / 3)) ++begin[size(std::min(start_of(faces, h), end_of(faces, h))) + 1];
  for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
  using Entry = std::pair<int, int>;  // the larger vertex, the half-edge
  std::vector<Entry> sorted(size(begin.back()));
  std::vector<int> next(begin.begin(), begin.end() - 1);
  for (Index h = 0; h < half_edges; ++h) {
    if (skip(h / 3)) continue;
    const auto [small, large] = std::minmax({start_of(faces, h), end_of(faces, h)});
    sorted[size(next[size(small)]++)] = {large, static_cast<int>(h)};
  }
  edge_of_.assign(size(half_edges), -1);
  halves_.reserve(sorted.size());
  for (Index v = 0; v < vertices; ++v) {
    const auto from = sorted.begin() + begin[size(v)], to = sorted.begin() + begin[size(v) + 1];
    std::sort(from, to);
    for (auto entry = from; entry != to; ++entry) {
      if (entry == from || entry->first != (entry - 1)->first) {
        first_.push_back(static_cast<int>(halves_.size()));
        ends_.push_back({static_cast<int>(v), entry->first});
      }
      edge_of_[size(entry->second)] = static_cast<int>(ends_.size()) - 1;
      halves_.push_back(entry->second);
    }
  }
  first_.push_back(static_cast<int>(halves_.size()));
}

Index EdgeTable::find(int a, int b) const {
  const auto [small, large] = std::minmax(a, b);
  const auto before = [](const Ends& x, const Ends& y) { return std::pair(x.a, x.b) < std::pair(y.a, y.b); };
  const auto place = std::lower_bound(ends_.begin(), ends_.end(), Ends{small, large}, before);
  return place != ends_.end() && place->a == small && place->b == large ? place - ends_.begin() : -1;
}

DisjointSets::DisjointSets(Index n) : parent_(static_cast<std::size_t>(n)) {
  for (std::size_t i = 0; i < parent_.size(); ++i) parent_[i] = static_cast<int>(i);
}

int DisjointSets::find(Index i) {
  auto at = static_cast<std::size_t>(i);
  while (static_cast<std::size_t>(parent_[at]) != at) {
    parent_[at] = parent_[static_cast<std::size_t>(parent_[at])];
    at = static_cast<std::size_t>(parent_[at]);
  }
  return static_cast<int>(at);
}

void DisjointSets::unite(Index i, Index j) {
  const int a = find(i), b = find(j);
  if (a < b) parent_[static_cast<std::size_t>(b)] = a;
  if (b < a) parent_[static_cast<std::size_t>(a)] = b;
}

}  // namespace seesaw
