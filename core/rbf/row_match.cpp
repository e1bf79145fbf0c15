#include "core/rbf/row_match.h"

#include <algorithm>
#include <numeric>

namespace seesaw {

namespace {

template <int Dim>
bool position_before(const Points<Dim>& a, Index i, const PointsRef<Dim>& b, Index j) {
  for (int d = 0; d < Dim; ++d)
    if (a(d, i) != b(d, j)) return a(d, i) < b(d, j);
  return false;
}

}  // namespace

template <int Dim>
RowFinder<Dim>::RowFinder(const PointsRef<Dim>& centers) : centers_(centers), order_(slot(centers.cols())) {
  std::iota(order_.begin(), order_.end(), Index{0});
  std::stable_sort(order_.begin(), order_.end(),
                   [&](Index a, Index b) { return position_before<Dim>(centers_, a, centers_, b); });
}

template <int Dim>
RowMatch RowFinder<Dim>::match(const PointsRef<Dim>& centers) const {
  const Index n = centers_.cols();
  std::vector<bool> taken(slot(n), false);
  const auto fits = [&](Index old_row, Index i) {
    return old_row < n && !taken[slot(old_row)] && centers_.col(old_row) == centers.col(i);
  };
  RowMatch match;
  match.old_row.reserve(slot(centers.cols()));
  Index expected = 0;  // the row after the last one that was found
  for (Index i = 0; i < centers.cols(); ++i) {
    Index found = fits(expected, i) ? expected : -1;
    if (found < 0) {
      auto here = std::lower_bound(order_.begin(), order_.end(), i, [&](Index old_row, Index j) {
        return position_before<Dim>(centers_, old_row, centers, j);
      });
      while (here != order_.end() && centers_.col(*here) == centers.col(i) && taken[slot(*here)]) ++here;
      if (here != order_.end() && fits(*here, i)) found = *here;
    }
    match.old_row.push_back(found);
    if (found < 0) {
      match.added.push_back(i);
    } else {
      taken[slot(found)] = true;
      expected = found + 1;
    }
  }
  for (Index i = 0; i < n; ++i)
    if (!taken[slot(i)]) match.removed.push_back(i);
  return match;
}

template class RowFinder<2>;
template class RowFinder<3>;
template class RowFinder<4>;

}  // namespace seesaw
