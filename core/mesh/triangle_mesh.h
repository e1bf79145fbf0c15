// Triangles in space: what a polygon model is read into, and what a surface becomes when it is polygonized.
//
// Before it: a file (core/mesh/mesh_file.h), or core/polygonize, which turns f = 0 into triangles.
// After it: mesh_check.h measures it, core/modelling turns it into constraints, core/raytrace draws it.
//
// Orientation carries meaning: seen from outside, a face's vertices run counter-clockwise, so that its normal
// (b - a) x (c - a) points *out*, and a closed mesh has positive volume.
#pragma once

#include "core/base/types.h"

namespace seesaw {

/// Vertex indices of F triangles, 3 x F, counted from 0.
using Faces = Eigen::Matrix<int, 3, Eigen::Dynamic>;

struct TriangleMesh {
  Points<3> vertices = Points<3>(3, 0);  ///< 3 x V, scene units
  Faces faces = Faces(3, 0);             ///< 3 x F
  /// Outward unit normals, 3 x V, or 3 x 0 where nobody has set any.
  Points<3> normals = Points<3>(3, 0);

  bool has_normals() const { return normals.cols() > 0 && normals.cols() == vertices.cols(); }
};

/// Points on a surface with the direction that leads out of it, as a scanner gives them.
struct PointCloud {
  Points<3> points = Points<3>(3, 0);  ///< 3 x N, scene units
  /// Outward normals of any length, 3 x N, or 3 x 0. A zero or NaN column says "not known here".
  Points<3> normals = Points<3>(3, 0);

  bool has_normals() const { return normals.cols() > 0 && normals.cols() == points.cols(); }
};

}  // namespace seesaw
