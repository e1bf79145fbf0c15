// Which rows of a new set of constraints are rows of an old one?
//
// Before it: core/rbf/system.h, the rows of both.  After it: core/rbf/border.h, the system of the difference.
//
// A row of eq. 8 (Turk & O'Brien 2002) is known by its position: its value stands on the right side only, and
// its number decides nothing but where its weight is stored. So constraints may be inserted, erased, replaced
// and reordered at will, and what counts is which positions went and which came, to the bit.
#pragma once

#include <vector>

#include "core/base/types.h"

namespace seesaw {

struct RowMatch {
  std::vector<Index> old_row;  ///< of each new row; -1 where there is none
  std::vector<Index> removed;  ///< old rows without a new one, ascending
  std::vector<Index> added;    ///< new rows without an old one, ascending

  Index size() const { return static_cast<Index>(removed.size() + added.size()); }
};

template <int Dim>
class RowFinder {
 public:
  /// Of the old rows' centers, Dim x N, finite. O(N log N).
  explicit RowFinder(const PointsRef<Dim>& centers);

  /// Of the new rows' centers. Several rows at one position (smoothed measurements) are matched one by one,
  /// in order. O(N) where most rows follow each other as they did before, O(N log N) otherwise.
  RowMatch match(const PointsRef<Dim>& centers) const;

 private:
  Points<Dim> centers_;
  std::vector<Index> order_;  // sorted by position, then by index
};

extern template class RowFinder<2>;
extern template class RowFinder<3>;
extern template class RowFinder<4>;

}  // namespace seesaw
