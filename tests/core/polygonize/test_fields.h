// Fields that put a polygonizer to the test.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>

#include "core/implicit/field.h"
#include "core/mesh/mesh_check.h"
#include "core/polygonize/polygonize.h"

namespace seesaw {

/// A field from a function of a point; gradients by central differences unless they are given.
class TestField final : public Field<3> {
 public:
  using Function = std::function<double(const Point<3>&)>;
  using Gradient = std::function<Point<3>(const Point<3>&)>;
  TestField(const Box<3>& box, Function f, Gradient g = nullptr)
      : box_(box), f_(std::move(f)), g_(std::move(g)) {}

  void evaluate(const PointsRef<3>& points, Eigen::Ref<Values> values) const override {
    check_shapes(points, values);
    for (Index i = 0; i < points.cols(); ++i) values[i] = f_(points.col(i));
  }
  void evaluate(const PointsRef<3>& points, Eigen::Ref<Values> values,
                Eigen::Ref<Points<3>> gradients) const override {
    evaluate(points, values);
    for (Index i = 0; i < points.cols(); ++i) {
      const Point<3> p = points.col(i);
      gradients.col(i) = g_ ? g_(p) : difference(p);
    }
  }
  double gradient_bound(const Box<3>&) const override { return infinity; }
  Box<3> bounding_box() const override { return box_; }

 private:
  Point<3> difference(const Point<3>& p) const {
    Point<3> g;
    for (int d = 0; d < 3; ++d) {
      const Point<3> step = 1e-6 * Point<3>::Unit(d);
      g[d] = (f_(p + step) - f_(p - step)) / 2e-6;
    }
    return g;
  }
  Box<3> box_;
  Function f_;
  Gradient g_;
};

inline Box<3> cube(double half) { return {Point<3>::Constant(-half), Point<3>::Constant(half)}; }

/// 64 bits that look random, from a point's digits: the same point, the same bits.
inline std::uint64_t hash_of(const Point<3>& p, std::uint64_t seed) {
  std::uint64_t h = seed;
  for (int d = 0; d < 3; ++d) {
    h ^= static_cast<std::uint64_t>(std::llround(p[d] * 1048576.0)) + 0x9E3779B97F4A7C15u + (h << 6) +
         (h >> 2);
    h = (h ^ h >> 30) * 0xBF58476D1CE4E5B9u;
    h = (h ^ h >> 27) * 0x94D049BB133111EBu;
    h ^= h >> 31;
  }
  return h;
}

inline Points<3> no_seeds() { return Points<3>(3, 0); }
inline Points<3> one_seed(double x, double y, double z) { return Point<3>(x, y, z); }

/// What holds for every mesh of a surface that closes.
inline ::testing::AssertionResult is_closed_manifold(const MeshReport& report) {
  if (report.closed && report.manifold && report.oriented && report.boundary_edges == 0 &&
      report.unused_vertices == 0)
    return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << "closed " << report.closed << ", manifold " << report.manifold << ", oriented " << report.oriented
         << ", boundary edges " << report.boundary_edges << ", non-manifold edges "
         << report.nonmanifold_edges << ", vertices " << report.nonmanifold_vertices << ", unused "
         << report.unused_vertices << ", faces " << report.faces;
}

/// The largest |f| / |grad f| over the mesh' vertices: how far they are off the surface, in scene units.
inline double farthest_off(const Field<3>& field, const TriangleMesh& mesh) {
  Values values(mesh.vertices.cols());
  Points<3> gradients(3, mesh.vertices.cols());
  field.evaluate(mesh.vertices, values, gradients);
  return (values.transpose().array().abs() / gradients.colwise().norm().array()).maxCoeff();
}

}  // namespace seesaw
