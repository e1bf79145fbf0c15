// From constraints to the rows of the linear system: the one place where a normal constraint becomes two
// values.
//
// Before it: core/rbf/constraints.h.  After it: core/rbf/solve.h finds the weights.
//
// Row i of eq. 8 (Turk & O'Brien 2002, section 3) says f(c_i) = h_i. A boundary constraint with a normal
// gives two rows: f(c) = 0 and f(c - offset n) = value (section 4.3). Rows at one position with one value are
// one row: a matrix with two equal rows has no inverse. Rows at one position with two values have no solution
// at all.
#pragma once

#include <vector>

#include "core/base/error.h"
#include "core/rbf/constraints.h"

namespace seesaw {

/// Constraints that no function can meet, or that no computer can tell apart. Normal in an editor: it keeps
/// the last good shape and marks the culprits.
class ConstraintError : public Error {
 public:
  enum class Reason { none_given, not_finite, out_of_range, no_direction, contradictory, too_close };

  ConstraintError(Reason reason, const std::string& message, std::vector<Index> culprits)
      : Error(message), reason_(reason), culprits_(std::move(culprits)) {}

  Reason reason() const { return reason_; }
  /// Indices into the constraints that were given, each once, in ascending order.
  const std::vector<Index>& culprits() const { return culprits_; }

 private:
  Reason reason_;
  std::vector<Index> culprits_;
};

/// The system's rows: row i asks for f(centers.col(i)) = values[i].
template <int Dim>
struct Rows {
  Points<Dim> centers;  ///< Dim x N, scene units
  Values values;        ///< N
  /// N; which constraint each row came from, and whether it is that constraint's normal constraint.
  struct Origin {
    Index constraint = 0;
    bool normal = false;
  };
  std::vector<Origin> origins;
  /// How many further rows were the same as one that is kept.
  Index merged = 0;
};

/// The rows that `constraints` ask for, one or two each, in their order. Nothing is merged yet.
/// Throws ConstraintError: none_given, not_finite, out_of_range (a coordinate beyond 1e100, or all of them
/// within 1e-100 of one another but not the same), no_direction (a normal of length zero).
template <int Dim>
Rows<Dim> rows_of(const Constraints<Dim>& constraints);

/// The same for plain values at points (scattered data, T&O 2002, section 2.2): row i is constraint i.
template <int Dim>
Rows<Dim> rows_of(const PointsRef<Dim>& points, const Eigen::Ref<const Values>& values);

/// Keeps the first of all rows that stand at one position (within tolerance::coincident) and ask for one
/// value. Throws ConstraintError::contradictory, naming every culprit, where one position is asked for two
/// values; too_close where that is for one constraint that lies far away. O(N log N).
template <int Dim>
Rows<Dim> merge_coincident(const Rows<Dim>& rows);

/// The two rows whose centers are nearest to each other, as constraint indices (ascending; one index if both
/// rows came from one constraint). O(N log N) for scattered centers. N >= 2.
template <int Dim>
std::vector<Index> nearest_pair(const Rows<Dim>& rows);

/// Throws ConstraintError::too_close, with that one as culprit, where one constraint is so far from all
/// others that the scene would be a thousandth of its size without it, or less: digits that tell the others
/// apart are lost to it. Else nothing. For who has found rows too near to each other. O(N).
template <int Dim>
void refuse_if_one_is_far(const Rows<Dim>& rows);

/// Coordinates in which the system is solved: x' = (x - center) / scale, with every center in [-1, 1]. The
/// function is the same (a sum of these kernels is invariant under similarity, once the polynomial is
/// refitted), its digits are not: at an offset of 4.5e6, r^3 of scene coordinates would keep none. `scale` is
/// a power of two, so dividing by it is exact.
template <int Dim>
struct Normalization {
  Point<Dim> center = Point<Dim>::Zero();
  double scale = 1.0;

  static Normalization of(const PointsRef<Dim>& points);
  Points<Dim> apply(const PointsRef<Dim>& points) const { return (points.colwise() - center) / scale; }
};

}  // namespace seesaw
