// The shapes of data that every floor of Seesaw speaks.
//
// A point is a column. N points are a Dim x N matrix, one column each, which in memory is the same as a numpy
// array of shape (N, Dim): Eigen is column-major, numpy row-major.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <limits>

namespace seesaw {

using Index = Eigen::Index;

/// An index as the standard containers count: `faces[slot(i)]`.
constexpr std::size_t slot(Index i) { return static_cast<std::size_t>(i); }

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// One point or direction, Dim x 1, in scene units.
template <int Dim>
using Point = Eigen::Matrix<double, Dim, 1>;

/// N points or directions, Dim x N, one a column, in scene units.
template <int Dim>
using Points = Eigen::Matrix<double, Dim, Eigen::Dynamic>;

/// N numbers, N x 1.
using Values = Eigen::VectorXd;

/// N Hessians, each Dim x Dim and symmetric, one a column of Dim * Dim numbers: (Dim * Dim) x N.
template <int Dim>
using Hessians = Eigen::Matrix<double, Dim * Dim, Eigen::Dynamic>;

/// An axis-aligned box; `isEmpty()` when no point was ever added.
template <int Dim>
using Box = Eigen::AlignedBox<double, Dim>;

/// The signed area of the parallelogram of two directions in the plane: positive when b is left of a.
inline double cross(const Point<2>& a, const Point<2>& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Read-only points as a function takes them: a whole matrix or a run of its columns, without a copy.
template <int Dim>
using PointsRef = Eigen::Ref<const Points<Dim>>;

/// The smallest box around `points` (Dim x N); empty for N = 0.
template <int Dim>
Box<Dim> bounding_box_of(const PointsRef<Dim>& points) {
  Box<Dim> box;
  for (Index i = 0; i < points.cols(); ++i) box.extend(Point<Dim>(points.col(i)));
  return box;
}

/// `box` grown by `fraction` of its longest side on every side; a box of no size grows by `fraction` itself.
template <int Dim>
Box<Dim> grown(const Box<Dim>& box, double fraction) {
  const double longest = box.sizes().maxCoeff();
  const Point<Dim> margin = Point<Dim>::Constant(fraction * (longest > 0 ? longest : 1.0));
  return Box<Dim>(box.min() - margin, box.max() + margin);
}

}  // namespace seesaw
