// Models that the tests of this floor are made from.
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "core/base/random.h"
#include "core/mesh/triangle_mesh.h"

namespace seesaw {

/// A closed mesh over a sphere's latitudes and longitudes: vertex (u, v) goes to shape(direction of u, v).
inline TriangleMesh sphere_like(int around, int rows,
                                const std::function<Point<3>(const Point<3>& direction)>& shape) {
  TriangleMesh mesh;
  const int count = around * (rows - 1) + 2;
  mesh.vertices.resize(3, count);
  mesh.faces.resize(3, 2 * around * (rows - 1));
  const auto at = [&](double u, double v) {
    return shape({std::sin(v) * std::cos(u), std::sin(v) * std::sin(u), std::cos(v)});
  };
  constexpr double pi = 3.141592653589793;
  const auto index = [&](int row, int i) { return (row - 1) * around + (i + around) % around; };
  for (int row = 1; row < rows; ++row)
    for (int i = 0; i < around; ++i)
      mesh.vertices.col(index(row, i)) = at(2 * pi * (i + 0.3) / around, pi * row / rows);
  mesh.vertices.col(count - 2) = shape({0, 0, 1});
  mesh.vertices.col(count - 1) = shape({0, 0, -1});
  Index f = 0;
  for (int i = 0; i < around; ++i) {
    mesh.faces.col(f++) << count - 2, index(1, i), index(1, i + 1);
    mesh.faces.col(f++) << count - 1, index(rows - 1, i + 1), index(rows - 1, i);
    for (int row = 1; row + 1 < rows; ++row) {
      mesh.faces.col(f++) << index(row, i), index(row + 1, i), index(row + 1, i + 1);
      mesh.faces.col(f++) << index(row, i), index(row + 1, i + 1), index(row, i + 1);
    }
  }
  return mesh;
}

/// An ellipsoid around the origin.
inline TriangleMesh ellipsoid(const Point<3>& radii, int around = 24, int rows = 14) {
  return sphere_like(around, rows, [&](const Point<3>& x) { return Point<3>(radii.cwiseProduct(x)); });
}

/// `count` points of the unit sphere at random, with their normals.
inline PointCloud random_sphere(Index count, Random& random) {
  PointCloud cloud;
  cloud.points.resize(3, count);
  for (Index i = 0; i < count; ++i) cloud.points.col(i) = random.direction<3>();
  cloud.normals = cloud.points;
  return cloud;
}

}  // namespace seesaw
