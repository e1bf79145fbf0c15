#include "core/rbf/border.h"

#include <algorithm>
#include <array>

#include "core/base/check.h"
#include "core/rbf/kernel_sums.h"
#include "core/rbf/small_lu.h"

namespace seesaw {

namespace {

// Columns of removed rows that are kept although the rows are back: somebody may take them away again, as a
// drag with undo and redo does.
constexpr std::size_t idle_columns = 64;

}  // namespace

template <int Dim>
Border<Dim>::Border(std::shared_ptr<const FullFit<Dim>> base)
    : base_(std::move(base)),
      n_(base_->rows.values.size()),
      coordinates_(base_->fit.function.normalized_centers().transpose()),
      change_(Values::Zero(n_)),
      y_change_(Values::Zero(n_ + Dim + 1)),
      y_base_(n_ + Dim + 1) {
  y_base_ << base_->fit.function.normalized_weights(), base_->fit.function.normalized_polynomial();
  y_ = y_base_;
}

template <int Dim>
template <class Key>
Index Border<Dim>::find(const Key& key) const {
  const auto found =
      std::find_if(columns_.begin(), columns_.end(), [&](const Column& c) { return c.is(key); });
  return found == columns_.end() ? -1 : static_cast<Index>(found - columns_.begin());
}

template <int Dim>
typename Border<Dim>::Column Border<Dim>::column_of(const Point<Dim>& center) const {
  Column column{-1, center, Values(n_ + Dim + 1), {}};
  std::array<const double*, Dim> arrays;
  for (int d = 0; d < Dim; ++d) arrays[static_cast<std::size_t>(d)] = coordinates_.col(d).data();
  kernel_sums().kernel_values(base_->kernel(), Dim, {arrays.data(), nullptr, n_}, center.data(),
                              column.g.data());
  column.g[n_] = 1.0;
  column.g.template tail<Dim>() = center;
  return column;
}

template <int Dim>
double Border<Dim>::product(const Column& row, const Values& x) const {
  return row.removed < 0 ? row.g.dot(x) : x[row.removed];
}

template <int Dim>
double Border<Dim>::schur_entry(const Column& row, const Column& column) const {
  double d = 0.0;
  if (row.removed < 0 && column.removed < 0) {
    std::array<const double*, Dim> arrays;
    for (int k = 0; k < Dim; ++k) arrays[static_cast<std::size_t>(k)] = &row.added[k];
    kernel_sums().kernel_values(base_->kernel(), Dim, {arrays.data(), nullptr, 1}, column.added.data(), &d);
    if (&row == &column) d += (base_->kernel() == Kernel::linear ? -1.0 : 1.0) * base_->smoothing;
  }
  return d - product(row, column.z);
}

template <int Dim>
void Border<Dim>::forget(const std::vector<Index>& removed, const PointsRef<Dim>& added) {
  std::size_t idle = 0;
  std::vector<Index> kept;
  std::vector<Column> columns;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    Column& column = columns_[i];
    bool keep = false;
    if (column.removed >= 0) {
      keep = std::binary_search(removed.begin(), removed.end(), column.removed) || idle++ < idle_columns;
    } else {
      for (Index k = 0; k < added.cols() && !keep; ++k) keep = column.added == added.col(k);
    }
    if (!keep) continue;
    kept.push_back(static_cast<Index>(i));
    columns.push_back(std::move(column));
  }
  columns_ = std::move(columns);
  schur_ = Eigen::MatrixXd(schur_(kept, kept));
}

template <int Dim>
Index Border<Dim>::unknown(const std::vector<Index>& removed, const PointsRef<Dim>& added) const {
  Index count = 0;
  for (const Index row : removed) count += find(row) < 0;
  for (Index k = 0; k < added.cols(); ++k) count += find(Point<Dim>(added.col(k))) < 0;
  return count;
}

template <int Dim>
Values Border<Dim>::change_of(const std::vector<Index>& removed, const Values& values) const {
  Values change = values - base_->rows.values;
  for (const Index row : removed) change[row] = 0.0;
  return change;
}

template <int Dim>
Index Border<Dim>::solves(const std::vector<Index>& removed, const PointsRef<Dim>& added,
                          const Values& values) const {
  return unknown(removed, added) + (change_of(removed, values) != change_ ? 1 : 0);
}

template <int Dim>
Index Border<Dim>::set(const std::vector<Index>& removed, const PointsRef<Dim>& added, const Values& values,
                       const Progress& progress) {
  SEESAW_CHECK_EQ(values.size(), n_);
  forget(removed, added);
  std::vector<Column> unknown;
  for (const Index row : removed)
    if (find(row) < 0) unknown.push_back({row, Point<Dim>::Zero(), {}, {}});
  for (Index k = 0; k < added.cols(); ++k)
    if (find(Point<Dim>(added.col(k))) < 0) unknown.push_back(column_of(added.col(k)));
  Values change = change_of(removed, values);
  const bool other_values = change != change_;
  const Index columns = static_cast<Index>(unknown.size()), solves = columns + (other_values ? 1 : 0);

  if (solves > 0) {
    Eigen::MatrixXd right_sides = Eigen::MatrixXd::Zero(n_ + Dim + 1, solves);
    for (Index k = 0; k < columns; ++k) {
      const Column& column = unknown[slot(k)];
      if (column.removed < 0)
        right_sides.col(k) = column.g;
      else
        right_sides(column.removed, k) = 1.0;
    }
    if (other_values) right_sides.col(columns).head(n_) = change;
    const Eigen::MatrixXd z = base_->factorization.solve_all(right_sides, progress);
    const Index before = static_cast<Index>(columns_.size());
    for (Index k = 0; k < columns; ++k) {
      unknown[slot(k)].z = z.col(k);
      columns_.push_back(std::move(unknown[slot(k)]));
    }
    schur_.conservativeResize(before + columns, before + columns);
    for (Index j = 0; j < before + columns; ++j)
      for (Index i = j < before ? before : 0; i < before + columns; ++i)
        schur_(i, j) = schur_entry(columns_[slot(i)], columns_[slot(j)]);
    if (other_values) {
      change_ = std::move(change);
      y_change_ = z.col(columns);
      y_ = y_base_ + y_change_;
    }
  }
  active_.clear();
  for (const Index row : removed) active_.push_back(find(row));
  for (Index k = 0; k < added.cols(); ++k) active_.push_back(find(Point<Dim>(added.col(k))));
  removed_ = static_cast<Index>(removed.size());
  return solves;
}

template <int Dim>
std::optional<BorderedSolution> Border<Dim>::combine(const Values& y, const Values& added_values) const {
  const Index size = static_cast<Index>(active_.size());
  SEESAW_CHECK_EQ(added_values.size(), size - removed_);
  Values x = y, u(size);
  if (size > 0) {
    Values right(size);
    right << Values::Zero(removed_), added_values;
    for (Index i = 0; i < size; ++i) right[i] -= product(columns_[slot(active_[slot(i)])], y);
    Eigen::MatrixXd schur = schur_(active_, active_);
    const SmallLu lu(std::move(schur));
    if (lu.singular()) return std::nullopt;
    u = lu.solve(right);
    for (Index i = 0; i < size; ++i) x -= u[i] * columns_[slot(active_[slot(i)])].z;
    for (Index i = 0; i < removed_; ++i) x[columns_[slot(active_[slot(i)])].removed] = 0.0;
  }
  return BorderedSolution{x.head(n_), u.tail(size - removed_), x.tail(Dim + 1)};
}

template <int Dim>
std::optional<BorderedSolution> Border<Dim>::solution(const Values& added_values) const {
  return combine(y_, added_values);
}

template <int Dim>
std::optional<BorderedSolution> Border<Dim>::solution_of(const Values& values, const Values& added_values,
                                                         const Progress& progress) const {
  SEESAW_CHECK_EQ(values.size(), n_);
  Eigen::MatrixXd right_side = Eigen::MatrixXd::Zero(n_ + Dim + 1, 1);
  right_side.col(0).head(n_) = values;
  return combine(base_->factorization.solve_all(right_side, progress), added_values);
}

template class Border<2>;
template class Border<3>;
template class Border<4>;

}  // namespace seesaw
