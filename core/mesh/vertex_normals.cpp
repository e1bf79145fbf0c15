#include "core/mesh/vertex_normals.h"

#include <cmath>

#include "core/base/check.h"

namespace seesaw {

Points<3> vertex_normals(const TriangleMesh& mesh) {
  const Index vertices = mesh.vertices.cols();
  if (mesh.faces.cols() > 0) {
    SEESAW_CHECK_LE(0, mesh.faces.minCoeff());
    SEESAW_CHECK_LT(Index{mesh.faces.maxCoeff()}, vertices);
  }
  Points<3> normals = Points<3>::Zero(3, vertices);
  for (Index f = 0; f < mesh.faces.cols(); ++f) {
    const auto corner = [&](int k) -> Point<3> { return mesh.vertices.col(mesh.faces(k % 3, f)); };
    // Lengths are divided out first: a face of size 1e-200 has a normal too.
    const Point<3> sides[3] = {(corner(1) - corner(0)).stableNormalized(),
                               (corner(2) - corner(1)).stableNormalized(),
                               (corner(0) - corner(2)).stableNormalized()};
    const Point<3> normal = sides[0].cross(sides[1]);
    const double length = normal.norm();
    if (!(length > 0)) continue;
    for (int k = 0; k < 3; ++k) {
      const Point<3> back = -sides[(k + 2) % 3];
      const double angle = std::atan2(sides[k].cross(back).norm(), sides[k].dot(back));
      normals.col(mesh.faces(k, f)) += angle / length * normal;
    }
  }
  for (Index v = 0; v < vertices; ++v) {
    const double length = normals.col(v).norm();
    // The angles around a vertex are of the order of one: what is left at 1e-12 is the rounding of a
    // cancellation.
    if (length > 1e-12)
      normals.col(v) /= length;
    else
      normals.col(v).setZero();
  }
  return normals;
}

}  // namespace seesaw
