// The markers of scene.h as meshes.
#include <cmath>
#include <numbers>

#include "core/base/check.h"
#include "core/raytrace/sampling.h"
#include "core/raytrace/scene.h"

namespace seesaw {

namespace {

// A profile (distance from the axis, height along it), turned about the axis; each piece between two of its
// points has its own normals, so that rims are sharp.
struct Turned {
  Point<3> base, axis, u, v;
  int segments;
  TriangleMesh mesh = {};

  Turned(const Point<3>& from, const Point<3>& direction, int sides)
      : base(from), axis(direction.normalized()), segments(sides) {
    SEESAW_CHECK_LT(0.0, direction.norm());
    SEESAW_CHECK_GE(sides, 3);
    across(axis, u, v);
  }

  Point<3> spoke(int k) const {
    const double angle = 2 * std::numbers::pi * k / segments;
    return std::cos(angle) * u + std::sin(angle) * v;
  }

  void piece(double radius_a, double height_a, double radius_b, double height_b) {
    const Index first = mesh.vertices.cols();
    const Index count = 2 * segments;
    mesh.vertices.conservativeResize(3, first + count);
    mesh.normals.conservativeResize(3, first + count);
    const Index faces = mesh.faces.cols();
    mesh.faces.conservativeResize(3, faces + 2 * segments);
    Index face = faces;
    for (int k = 0; k < segments; ++k) {
      const Point<3> out = spoke(k);
      const Point<3> normal = ((height_b - height_a) * out - (radius_b - radius_a) * axis).stableNormalized();
      mesh.vertices.col(first + 2 * k) = base + radius_a * out + height_a * axis;
      mesh.vertices.col(first + 2 * k + 1) = base + radius_b * out + height_b * axis;
      mesh.normals.col(first + 2 * k) = mesh.normals.col(first + 2 * k + 1) = normal;
      const int a = static_cast<int>(first) + 2 * k, b = a + 1;
      const int c = static_cast<int>(first) + 2 * ((k + 1) % segments), d = c + 1;
      if (radius_a > 0) mesh.faces.col(face++) << a, c, b;
      if (radius_b > 0) mesh.faces.col(face++) << b, c, d;
    }
    mesh.faces.conservativeResize(3, face);
  }
};

}  // namespace

TriangleMesh disc_mesh(const Point<3>& center, const Point<3>& normal, double radius, double thickness,
                       int segments) {
  Turned turned(center, normal, segments);
  turned.piece(0, 0, radius, 0);
  turned.piece(radius, 0, radius, thickness);
  turned.piece(radius, thickness, 0, thickness);
  return turned.mesh;
}

TriangleMesh cylinder_mesh(const Point<3>& from, const Point<3>& to, double radius, int segments) {
  return disc_mesh(from, to - from, radius, (to - from).norm(), segments);
}

TriangleMesh cone_mesh(const Point<3>& from, const Point<3>& to, double radius, int segments) {
  Turned turned(from, to - from, segments);
  turned.piece(0, 0, radius, 0);
  turned.piece(radius, 0, 0, (to - from).norm());
  return turned.mesh;
}

TriangleMesh spike_mesh(const Point<3>& from, const Point<3>& to, double radius, int segments) {
  const double length = (to - from).norm();
  const double head = std::min(6 * radius, 0.5 * length);
  Turned turned(from, to - from, segments);
  turned.piece(0, 0, radius, 0);
  turned.piece(radius, 0, radius, length - head);
  turned.piece(radius, length - head, 2.4 * radius, length - head);
  turned.piece(2.4 * radius, length - head, 0, length);
  return turned.mesh;
}

TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b) {
  TriangleMesh result;
  const auto add = [&](const TriangleMesh& mesh) {
    const Index vertices = result.vertices.cols(), faces = result.faces.cols();
    TriangleMesh part = mesh;
    if (!mesh.has_normals() && mesh.faces.cols() > 0) {
      part.vertices.resize(3, mesh.faces.size());
      part.normals.resize(3, mesh.faces.size());
      for (Index f = 0; f < mesh.faces.cols(); ++f) {
        for (int k = 0; k < 3; ++k) {
          part.vertices.col(3 * f + k) = mesh.vertices.col(mesh.faces(k, f));
          part.faces(k, f) = static_cast<int>(3 * f + k);
        }
        const Point<3> p = part.vertices.col(3 * f), q = part.vertices.col(3 * f + 1),
                       r = part.vertices.col(3 * f + 2);
        for (int k = 0; k < 3; ++k) part.normals.col(3 * f + k) = (q - p).cross(r - p).stableNormalized();
      }
    }
    result.vertices.conservativeResize(3, vertices + part.vertices.cols());
    result.normals.conservativeResize(3, vertices + part.vertices.cols());
    result.faces.conservativeResize(3, faces + part.faces.cols());
    result.vertices.rightCols(part.vertices.cols()) = part.vertices;
    if (part.has_normals()) result.normals.rightCols(part.vertices.cols()) = part.normals;
    result.faces.rightCols(part.faces.cols()) = part.faces.array() + static_cast<int>(vertices);
  };
  add(a);
  add(b);
  return result;
}

}  // namespace seesaw
