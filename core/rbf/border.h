// Rows that come and go, on the factorization of the rows that were there: the bordered system.
//
// Before it: core/rbf/full_fit.h, the factored matrix of some rows; core/rbf/row_match.h, what has changed.
// After it: core/rbf/edit_session.h, a function after every edit.
//
// Let K be the matrix of eq. 8 (Turk & O'Brien 2002) for the N old rows, polynomial included, and x = [w; p].
// Every change of the rows is a border around K, never a change in it:
//
//   added at a     a column and row of its own:  g_a = [phi(|c_i - a|); 1; a], and s lambda in the corner
//   removed, r     its weight is to be 0: the row e_r' x = 0. Its old equation must then be given slack, a
//                  new unknown: the column e_r
//   moved          removed and added
//   other value    nothing but the right side
//
//     [ K   G ] [x]   [h]
//     [ G'  D ] [u] = [g]      G = [e_r ...  g_a ...],  u = [slacks; weights of the added]
//
// D is the kernel between added rows, and zero elsewhere; h has the values of the old rows (whatever they are
// in a removed one), g those of the added rows and 0 for the removed. With Z = K^-1 G and y = K^-1 h,
//
//     (D - G' Z) u = g - G' y,      x = y - Z u.
//
// A column of Z is one solve with the old factorization, 2 N^2 multiplications, and is kept: an old row that
// is dragged for a minute is removed once, and costs one new column (its new position) a step. The Schur
// complement D - G' Z is as small as the border. It is indefinite: s times its part of added rows is positive
// definite (how far a function can stray from its constraints), that of removed rows negative (an entry of
// the inverse of a positive matrix).
//
// The dragged row near its old position is a border nearly singular twice over, and harmless: the column e_r
// and the column g_a together are what a difference quotient would be, and pivoting finds them.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/rbf/full_fit.h"
#include "core/rbf/row_match.h"

namespace seesaw {

/// Of the bordered system: x without its removed rows' weights (which are zero to rounding, and written as
/// such), and u without the slacks.
struct BorderedSolution {
  Values old_weights;    ///< N, in the order of the old rows
  Values added_weights;  ///< as many as were added
  Values polynomial;     ///< Dim + 1
};

template <int Dim>
class Border {
 public:
  /// Around the matrix of `base`, which must have polynomial_rank Dim + 1.
  explicit Border(std::shared_ptr<const FullFit<Dim>> base);

  /// How many columns of Z `set` would have to solve for.
  Index unknown(const std::vector<Index>& removed, const PointsRef<Dim>& added) const;
  /// How many solves `set` would take: those, and one where the values are not those of before.
  Index solves(const std::vector<Index>& removed, const PointsRef<Dim>& added, const Values& values) const;

  /// Makes the border that of these old rows removed and these centers added (Dim x M, in the base's
  /// normalized coordinates, pairwise distinct), and the values of the old rows `values` (N; whatever one
  /// likes in removed ones). All columns of Z that are not known yet are solved for in one pass over the
  /// matrix; returns how many. Those of added centers that are gone are forgotten. Where `progress` says stop
  /// it throws Cancelled, and must be set again before it solves.
  Index set(const std::vector<Index>& removed, const PointsRef<Dim>& added, const Values& values,
            const Progress& progress = {});

  /// The solution for values `added_values` (M) in the added rows; none where the Schur complement is
  /// singular: the rows then contradict each other, or nearly. N times the border's multiplications.
  std::optional<BorderedSolution> solution(const Values& added_values) const;

  /// The solution for any other values of old and added rows, without what `set` was told: for what a
  /// solution missed, say. One more solve.
  std::optional<BorderedSolution> solution_of(const Values& values, const Values& added_values,
                                              const Progress& progress = {}) const;

 private:
  // A column of the border and its solution.
  struct Column {
    Index removed = -1;  // or -1
    Point<Dim> added = Point<Dim>::Zero();
    Values g;  // N + Dim + 1; none for removed rows
    Values z;

    bool is(Index row) const { return removed == row; }
    bool is(const Point<Dim>& center) const { return removed < 0 && added == center; }
  };

  /// What `values` add to the base's, but for removed rows.
  Values change_of(const std::vector<Index>& removed, const Values& values) const;
  void forget(const std::vector<Index>& removed, const PointsRef<Dim>& added);
  template <class Key>
  Index find(const Key& key) const;
  Column column_of(const Point<Dim>& center) const;
  /// g_i' x of border column i.
  double product(const Column& row, const Values& x) const;
  /// Entry of D - G' Z.
  double schur_entry(const Column& row, const Column& column) const;
  std::optional<BorderedSolution> combine(const Values& y, const Values& added_values) const;

  std::shared_ptr<const FullFit<Dim>> base_;
  Index n_;
  Eigen::Matrix<double, Eigen::Dynamic, Dim> coordinates_;  // of the old centers, one array a coordinate
  std::vector<Column> columns_;                             // all that are known
  Eigen::MatrixXd schur_;                                   // between all that are known
  std::vector<Index> active_;                               // of those: removed rows, then added centers
  Index removed_ = 0;                                       // how many of the active are removed rows
  Values change_, y_change_;                                // values less the base's, and K^-1 of it
  Values y_base_, y_;
};

extern template class Border<2>;
extern template class Border<3>;
extern template class Border<4>;

}  // namespace seesaw
