#include "core/rbf/system.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "core/base/check.h"
#include "core/base/text.h"
#include "core/base/tolerances.h"

namespace seesaw {

namespace {

using Reason = ConstraintError::Reason;

std::string list_of(const std::vector<Index>& indices) {
  std::string text;
  for (std::size_t i = 0; i < indices.size() && i < 10; ++i)
    text += (i ? ", " : "") + std::to_string(indices[i]);
  if (indices.size() > 10) text += " and " + std::to_string(indices.size() - 10) + " more";
  return text;
}

// "constraint 3", "constraints 0, 4"
std::string named(const std::vector<Index>& indices) {
  return (indices.size() == 1 ? "constraint " : "constraints ") + list_of(indices);
}

std::vector<Index> sorted(const std::set<Index>& indices) { return {indices.begin(), indices.end()}; }

template <int Dim>
void refuse_unless_finite(const Rows<Dim>& rows) {
  std::set<Index> culprits;
  for (Index i = 0; i < rows.values.size(); ++i)
    if (!rows.centers.col(i).allFinite() || !std::isfinite(rows.values[i]))
      culprits.insert(rows.origins[static_cast<std::size_t>(i)].constraint);
  if (culprits.empty()) return;
  throw ConstraintError(Reason::not_finite,
                        named(sorted(culprits)) + ": a coordinate or value is not a finite number",
                        sorted(culprits));
}

// Weights are in units of value * length^-3; sizes whose cube is no double have none.
template <int Dim>
void refuse_unless_in_range(const Rows<Dim>& rows) {
  constexpr double largest = 1e100, smallest = 1e-100;
  std::set<Index> culprits;
  const auto refuse = [&](const Values& sizes, const char* words) {
    for (Index i = 0; i < sizes.size(); ++i)
      if (sizes[i] > largest) culprits.insert(rows.origins[static_cast<std::size_t>(i)].constraint);
    if (!culprits.empty())
      throw ConstraintError(Reason::out_of_range, named(sorted(culprits)) + words, sorted(culprits));
  };
  refuse(rows.centers.cwiseAbs().colwise().maxCoeff(),
         ": a coordinate is beyond 1e100; choose another unit of length");
  refuse(rows.values.cwiseAbs(), ": a value is beyond 1e100; choose smaller ones");
  const double extent = bounding_box_of<Dim>(rows.centers).sizes().maxCoeff();
  if (extent > 0 && extent < smallest) {
    for (const auto& origin : rows.origins) culprits.insert(origin.constraint);
    throw ConstraintError(Reason::out_of_range,
                          "all constraints lie within " + to_text(extent) + "; choose another unit of length",
                          sorted(culprits));
  }
}

[[noreturn]] void refuse_nothing() {
  throw ConstraintError(Reason::none_given, "there are no constraints: place at least one", {});
}

// Centers in the order of their projection onto a line in general position: whatever is near is then near in
// the order too, and centers on a lattice, which tie along every axis, do not tie along it.
template <int Dim>
struct Sweep {
  std::vector<Index> order;
  std::vector<double> along;  // ascending, in units of the extent

  Sweep(const Points<Dim>& centers, double extent) : order(static_cast<std::size_t>(centers.cols())) {
    Point<Dim> direction;
    for (int d = 0; d < Dim; ++d) direction[d] = 1.0 / std::sqrt(2.0 + 1.7 * d);
    direction.normalize();
    const Point<Dim> origin = centers.col(0);
    const Values projection = (direction.transpose() * (centers.colwise() - origin)).transpose() / extent;
    std::iota(order.begin(), order.end(), Index{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return projection[a] < projection[b]; });
    along.reserve(order.size());
    for (const Index i : order) along.push_back(projection[i]);
  }
};

template <int Dim>
double extent_of(const Points<Dim>& centers) {
  const double extent = bounding_box_of<Dim>(centers).sizes().maxCoeff();
  return extent > 0 ? extent : 1.0;
}

}  // namespace

template <int Dim>
Rows<Dim> rows_of(const Constraints<Dim>& constraints) {
  if (constraints.empty()) refuse_nothing();
  Rows<Dim> rows;
  Index count = 0;
  for (const auto& constraint : constraints) count += constraint.normal ? 2 : 1;
  rows.centers.resize(Dim, count);
  rows.values.resize(count);
  rows.origins.reserve(static_cast<std::size_t>(count));
  std::set<Index> without_direction;
  const auto add = [&](const Point<Dim>& at, double value, Index constraint, bool normal) {
    const Index i = static_cast<Index>(rows.origins.size());
    rows.centers.col(i) = at;
    rows.values[i] = value;
    rows.origins.push_back({constraint, normal});
  };
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    const Constraint<Dim>& constraint = constraints[i];
    const Index index = static_cast<Index>(i);
    add(constraint.at, constraint.value, index, false);
    if (!constraint.normal) continue;
    const auto& normal = *constraint.normal;
    if (normal.direction.stableNorm() == 0.0) without_direction.insert(index);
    add(normal_center<Dim>(constraint.at, normal), normal.value, index, true);
  }
  if (!without_direction.empty())
    throw ConstraintError(Reason::no_direction,
                          "constraint " + list_of(sorted(without_direction)) +
                              ": its normal has length zero; give it a direction or none",
                          sorted(without_direction));
  refuse_unless_finite(rows);
  refuse_unless_in_range(rows);
  return rows;
}

template <int Dim>
Rows<Dim> rows_of(const PointsRef<Dim>& points, const Eigen::Ref<const Values>& values) {
  SEESAW_CHECK_EQ(points.cols(), values.size());
  if (points.cols() == 0) refuse_nothing();
  Rows<Dim> rows{points, values, {}, 0};
  for (Index i = 0; i < points.cols(); ++i) rows.origins.push_back({i, false});
  refuse_unless_finite(rows);
  refuse_unless_in_range(rows);
  return rows;
}

template <int Dim>
void refuse_if_one_is_far(const Rows<Dim>& rows) {
  // The one farthest from the middle of most.
  Point<Dim> middle;
  for (int d = 0; d < Dim; ++d) {
    Values along = rows.centers.row(d);
    std::nth_element(along.begin(), along.begin() + along.size() / 2, along.end());
    middle[d] = along[along.size() / 2];
  }
  Index farthest = 0;
  const double distance =
      (rows.centers.colwise() - middle).cwiseAbs().colwise().maxCoeff().maxCoeff(&farthest);
  const Index culprit = rows.origins[static_cast<std::size_t>(farthest)].constraint;
  Box<Dim> others;
  for (Index i = 0; i < rows.centers.cols(); ++i)
    if (rows.origins[static_cast<std::size_t>(i)].constraint != culprit) others.extend(rows.centers.col(i));
  if (others.isEmpty() || !(others.sizes().maxCoeff() < 1e-3 * distance)) return;
  throw ConstraintError(
      Reason::too_close,
      "constraint " + std::to_string(culprit) + " is " + to_text(distance, 3) +
          " away from all others, which lie within " + to_text(others.sizes().maxCoeff(), 3) +
          ": too near each other to be told apart in a scene of that size; move or delete it",
      {culprit});
}

template <int Dim>
Rows<Dim> merge_coincident(const Rows<Dim>& rows) {
  const double extent = extent_of<Dim>(rows.centers);
  const double same_value = tolerance::same_value * rows.values.cwiseAbs().maxCoeff();
  const Sweep<Dim> sweep(rows.centers, extent);
  const std::size_t n = sweep.order.size();
  std::vector<bool> dropped(n, false);
  std::set<Index> culprits;
  double farthest_apart = 0, nearest_apart = infinity;
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n && sweep.along[b] - sweep.along[a] <= tolerance::coincident; ++b) {
      const Index i = std::min(sweep.order[a], sweep.order[b]), j = std::max(sweep.order[a], sweep.order[b]);
      const double apart = (rows.centers.col(i) - rows.centers.col(j)).norm();
      if (apart > tolerance::coincident * extent) continue;
      if (std::abs(rows.values[i] - rows.values[j]) <= same_value) {
        dropped[static_cast<std::size_t>(j)] = true;
      } else {
        culprits.insert(rows.origins[static_cast<std::size_t>(i)].constraint);
        culprits.insert(rows.origins[static_cast<std::size_t>(j)].constraint);
        farthest_apart = std::max(farthest_apart, apart);
        nearest_apart = std::min(nearest_apart, apart);
      }
    }
  if (!culprits.empty() && nearest_apart > 0) refuse_if_one_is_far(rows);
  if (!culprits.empty())
    throw ConstraintError(
        Reason::contradictory,
        named(sorted(culprits)) +
            (culprits.size() == 1   ? " and its normal ask for different values at one position"
             : culprits.size() == 2 ? " ask for different values at one position"
                                    : " meet others of them and ask for different values there") +
            (farthest_apart > 0
                 ? " (" + to_text(farthest_apart, 3) + " apart or less, too near in a scene of size " +
                       to_text(extent, 3) + ")"
                 : std::string()) +
            "; move or delete one of them",
        sorted(culprits));
  Rows<Dim> kept;
  kept.merged = std::count(dropped.begin(), dropped.end(), true);
  if (kept.merged == 0) return rows;
  std::vector<Index> columns;
  for (std::size_t i = 0; i < n; ++i)
    if (!dropped[i]) {
      columns.push_back(static_cast<Index>(i));
      kept.origins.push_back(rows.origins[i]);
    }
  kept.centers = rows.centers(Eigen::all, columns);
  kept.values = rows.values(columns);
  return kept;
}

template <int Dim>
std::vector<Index> nearest_pair(const Rows<Dim>& rows) {
  SEESAW_CHECK_LE(2, rows.centers.cols());
  const double extent = extent_of<Dim>(rows.centers);
  const Sweep<Dim> sweep(rows.centers, extent);
  double nearest = infinity;
  std::set<Index> pair;
  for (std::size_t a = 0; a < sweep.order.size(); ++a)
    for (std::size_t b = a + 1; b < sweep.order.size() && sweep.along[b] - sweep.along[a] < nearest; ++b) {
      const Index i = sweep.order[a], j = sweep.order[b];
      const double distance = (rows.centers.col(i) - rows.centers.col(j)).norm() / extent;
      if (distance >= nearest) continue;
      nearest = distance;
      pair = {rows.origins[static_cast<std::size_t>(i)].constraint,
              rows.origins[static_cast<std::size_t>(j)].constraint};
    }
  return sorted(pair);
}

template <int Dim>
Normalization<Dim> Normalization<Dim>::of(const PointsRef<Dim>& points) {
  const Box<Dim> box = bounding_box_of<Dim>(points);
  // Half of each corner before the sum: coordinates near the largest double do not overflow.
  const Point<Dim> center = 0.5 * box.min() + 0.5 * box.max();
  const double reach = (0.5 * box.max() - 0.5 * box.min()).maxCoeff();
  int exponent = 0;
  if (reach > 0) std::frexp(reach, &exponent);
  return {center, std::ldexp(1.0, exponent)};
}

#define SEESAW_INSTANTIATE(Dim)                                                            \
  template Rows<Dim> rows_of<Dim>(const Constraints<Dim>&);                                \
  template Rows<Dim> rows_of<Dim>(const PointsRef<Dim>&, const Eigen::Ref<const Values>&); \
  template void refuse_if_one_is_far<Dim>(const Rows<Dim>&);                               \
  template Rows<Dim> merge_coincident<Dim>(const Rows<Dim>&);                              \
  template std::vector<Index> nearest_pair<Dim>(const Rows<Dim>&);                         \
  template struct Normalization<Dim>;
SEESAW_INSTANTIATE(2)
SEESAW_INSTANTIATE(3)
SEESAW_INSTANTIATE(4)
#undef SEESAW_INSTANTIATE

}  // namespace seesaw
