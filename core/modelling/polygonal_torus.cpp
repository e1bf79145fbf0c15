#include "core/modelling/polygonal_torus.h"

#include <cmath>

#include "core/base/check.h"

namespace seesaw {

TriangleMesh polygonal_torus(const TorusShape& shape, int around, int across) {
  SEESAW_CHECK_LE(3, around);
  SEESAW_CHECK_LE(3, across);
  SEESAW_CHECK_LT(0.0, shape.axis.norm());
  SEESAW_CHECK_LT(0.0, shape.minor);
  SEESAW_CHECK_LT(shape.minor, shape.major);
  const Point<3> z = shape.axis.normalized();
  Index least = 0;
  z.cwiseAbs().minCoeff(&least);
  const Point<3> x = z.cross(Point<3>::Unit(least)).normalized(), y = z.cross(x);

  TriangleMesh mesh;
  const int count = around * across;
  mesh.vertices.resize(3, count);
  mesh.normals.resize(3, count);
  mesh.faces.resize(3, 2 * count);
  constexpr double turn = 6.283185307179586;
  // Turning each ring by half a step only closes up for an even number of them.
  const double half = around % 2 == 0 ? 0.5 : 0.0;
  const auto index = [&](int i, int j) { return (i + around) % around * across + (j + across) % across; };
  for (int i = 0; i < around; ++i) {
    const double angle = turn * i / around;
    const Point<3> outward = std::cos(angle) * x + std::sin(angle) * y;
    for (int j = 0; j < across; ++j) {
      const double tilt = turn * (j + (i % 2 ? half : 0.0)) / across;
      const Point<3> normal = std::cos(tilt) * outward + std::sin(tilt) * z;
      mesh.normals.col(index(i, j)) = normal;
      mesh.vertices.col(index(i, j)) = shape.center + shape.major * outward + shape.minor * normal;
    }
  }
  Index f = 0;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const int a = index(i, j), b = index(i + 1, j), c = index(i + 1, j + 1), d = index(i, j + 1);
      // The shorter way across the four: odd rings stand half a step ahead.
      const bool ahead = half > 0 && i % 2 == 0;
      if (ahead) {
        mesh.faces.col(f++) << a, b, d;
        mesh.faces.col(f++) << b, c, d;
      } else {
        mesh.faces.col(f++) << a, b, c;
        mesh.faces.col(f++) << a, c, d;
      }
    }
  return mesh;
}

}  // namespace seesaw
