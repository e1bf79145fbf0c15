// Meshes whose every fact is known without a computer.
#pragma once

#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "core/mesh/triangle_mesh.h"

namespace seesaw {

inline TriangleMesh make_mesh(const std::vector<Point<3>>& vertices,
                              const std::vector<Eigen::Vector3i>& faces) {
  TriangleMesh mesh;
  mesh.vertices.resize(3, static_cast<Index>(vertices.size()));
  mesh.faces.resize(3, static_cast<Index>(faces.size()));
  for (std::size_t i = 0; i < vertices.size(); ++i) mesh.vertices.col(static_cast<Index>(i)) = vertices[i];
  for (std::size_t i = 0; i < faces.size(); ++i) mesh.faces.col(static_cast<Index>(i)) = faces[i];
  return mesh;
}

/// The corner of a unit cube: volume 1/6, area (3 + sqrt 3) / 2.
inline TriangleMesh tetrahedron() {
  return make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                   {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
}

inline TriangleMesh unit_cube() {
  return make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                   {{0, 2, 1},
                    {0, 3, 2},
                    {4, 5, 6},
                    {4, 6, 7},
                    {0, 1, 5},
                    {0, 5, 4},
                    {1, 2, 6},
                    {1, 6, 5},
                    {2, 3, 7},
                    {2, 7, 6},
                    {3, 0, 4},
                    {3, 4, 7}});
}

/// A grid of rows x columns vertices, joined to quadrilaterals; the row and column after the last is the
/// first again where it wraps, and with `twist` the columns meet mirrored (then `rows` does not wrap).
template <class Place>
TriangleMesh grid_mesh(int rows, int columns, bool wrap_rows, bool wrap_columns, bool twist, Place place) {
  std::vector<Point<3>> vertices;
  std::vector<Eigen::Vector3i> faces;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) vertices.push_back(place(i, j));
  const auto at = [&](int i, int j) {
    if (j >= columns && twist) i = rows - 1 - i;
    return (i % rows) * columns + j % columns;
  };
  for (int i = 0; i < rows - !wrap_rows; ++i)
    for (int j = 0; j < columns - !wrap_columns; ++j) {
      faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return make_mesh(vertices, faces);
}

inline constexpr double pi = 3.141592653589793;

/// Around the z axis, outward.
inline TriangleMesh torus_mesh(int around, int across, double large = 1, double small = 0.4) {
  return grid_mesh(around, across, true, true, false, [&](int i, int j) {
    const double u = 2 * pi * i / around, v = 2 * pi * j / across;
    const double r = large + small * std::cos(v);
    return Point<3>(r * std::cos(u), r * std::sin(u), small * std::sin(v));
  });
}

/// A band of one half turn: one side, one boundary.
inline TriangleMesh moebius_mesh(int around) {
  return grid_mesh(3, around, false, true, true, [&](int i, int j) {
    const double u = 2 * pi * j / around, w = 0.3 * (i - 1);
    const double r = 1 + w * std::cos(u / 2);
    return Point<3>(r * std::cos(u), r * std::sin(u), w * std::sin(u / 2));
  });
}

/// An icosahedron, each face cut in four `levels` times and pushed out to the unit sphere: 20 * 4^levels
/// faces.
inline TriangleMesh sphere_mesh(int levels) {
  const double t = (1 + std::sqrt(5.0)) / 2;
  std::vector<Point<3>> v = {{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                             {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
  std::vector<Eigen::Vector3i> f = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (Point<3>& p : v) p.normalize();
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [place, added] = middles.try_emplace(std::minmax(a, b), static_cast<int>(v.size()));
      if (added) v.push_back((v[static_cast<std::size_t>(a)] + v[static_cast<std::size_t>(b)]).normalized());
      return place->second;
    };
    std::vector<Eigen::Vector3i> finer;
    for (const Eigen::Vector3i& t3 : f) {
      const int ab = middle(t3[0], t3[1]), bc = middle(t3[1], t3[2]), ca = middle(t3[2], t3[0]);
      for (const Eigen::Vector3i& part : {Eigen::Vector3i(t3[0], ab, ca), Eigen::Vector3i(ab, t3[1], bc),
                                          Eigen::Vector3i(ca, bc, t3[2]), Eigen::Vector3i(ab, bc, ca)})
        finer.push_back(part);
    }
    f = finer;
  }
  return make_mesh(v, f);
}

inline TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b) {
  TriangleMesh mesh;
  mesh.vertices.resize(3, a.vertices.cols() + b.vertices.cols());
  mesh.vertices << a.vertices, b.vertices;
  mesh.faces.resize(3, a.faces.cols() + b.faces.cols());
  mesh.faces << a.faces, (b.faces.array() + static_cast<int>(a.vertices.cols())).matrix();
  return mesh;
}

inline TriangleMesh inside_out(TriangleMesh mesh) {
  mesh.faces.row(1).swap(mesh.faces.row(2));
  return mesh;
}

inline TriangleMesh moved(TriangleMesh mesh, double scale, const Point<3>& by) {
  mesh.vertices = (scale * mesh.vertices).colwise() + by;
  return mesh;
}

}  // namespace seesaw
