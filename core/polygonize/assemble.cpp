#include "core/polygonize/assemble.h"

#include <algorithm>
#include <numeric>

#include "core/base/parallel.h"
#include "core/polygonize/cube_table.h"
#include "core/polygonize/edge_roots.h"

namespace seesaw {

namespace {

// A lattice edge that changes sign: numbers of its corners.
struct CutEdge {
  int inside, outside;
};

std::uint8_t planes_of(const Lattice& lattice, const Corner& a, const Corner& b) {
  std::uint8_t planes = 0;
  for (std::size_t d = 0; d < 3; ++d)
    if (a[d] == b[d] && (a[d] == lattice.range.low[d] || a[d] == lattice.range.high[d]))
      planes = static_cast<std::uint8_t>(planes | 1u << d);
  return planes;
}

}  // namespace

void LatticeMesh::copy_vertex(Index from, Index to) {
  for (Points<3>* points : {&positions, &inside, &outside}) points->col(to) = Point<3>(points->col(from));
  inside_values[to] = inside_values[from];
  outside_values[to] = outside_values[from];
  on_range[static_cast<std::size_t>(to)] = on_range[static_cast<std::size_t>(from)];
}

LatticeMesh assemble(const Lattice& lattice, const CrossedCubes& found, Sampler& sampler, double tolerance) {
  std::vector<std::array<int, 3>> vertex_on(found.corners.size(), {-1, -1, -1});
  std::vector<CutEdge> edges;
  std::vector<int> face_vertices;
  LatticeMesh mesh;
  mesh.cube_start.reserve(found.cubes.size() + 1);
  for (const CrossedCube& cube : found.cubes) {
    mesh.cube_start.push_back(static_cast<int>(face_vertices.size() / 3));
    for (const auto& triangle : cube_triangles(cube.inside))
      for (const std::uint8_t e : triangle) {
        const CubeEdge& edge = cube_edges[e];
        const int low = cube.corner[static_cast<std::size_t>(edge.low)];
        int& vertex = vertex_on[static_cast<std::size_t>(low)][static_cast<std::size_t>(edge.axis)];
        if (vertex < 0) {
          vertex = static_cast<int>(edges.size());
          const int high = cube.corner[static_cast<std::size_t>(edge.high())];
          edges.push_back(cube.inside >> edge.low & 1u ? CutEdge{low, high} : CutEdge{high, low});
        }
        face_vertices.push_back(vertex);
      }
  }
  mesh.cube_start.push_back(static_cast<int>(face_vertices.size() / 3));
  mesh.faces = Eigen::Map<const Faces>(face_vertices.data(), 3, static_cast<Index>(face_vertices.size() / 3));

  const Index n = static_cast<Index>(edges.size());
  mesh.inside.resize(3, n);
  mesh.outside.resize(3, n);
  mesh.inside_values.resize(n);
  mesh.outside_values.resize(n);
  mesh.on_range.resize(edges.size());
  const auto fill = [&](Index v) {
    const std::size_t in = static_cast<std::size_t>(edges[static_cast<std::size_t>(v)].inside);
    const std::size_t out = static_cast<std::size_t>(edges[static_cast<std::size_t>(v)].outside);
    const Corner a = corner_of(found.corners[in]), b = corner_of(found.corners[out]);
    mesh.inside.col(v) = lattice.position(a);
    mesh.outside.col(v) = lattice.position(b);
    mesh.inside_values[v] = found.values[in];
    mesh.outside_values[v] = found.values[out];
    // A vertex on an exact zero stands on the corner itself, and on all faces that the corner is on.
    mesh.on_range[static_cast<std::size_t>(v)] = planes_of(lattice, a, mesh.is_exact_zero(v) ? a : b);
  };
  parallel_blocks(n, 2048, [&](Index begin, Index end) {
    for (Index v = begin; v < end; ++v) fill(v);
  });
  mesh.positions =
      find_edge_roots(sampler, {mesh.inside, mesh.outside, mesh.inside_values, mesh.outside_values},
                      tolerance)
          .positions;
  return mesh;
}

Index components_of(const Faces& faces, Index vertices, std::vector<int>& component) {
  std::vector<int> parent(static_cast<std::size_t>(vertices));
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int v) {
    while (parent[static_cast<std::size_t>(v)] != v) {
      int& p = parent[static_cast<std::size_t>(v)];
      p = parent[static_cast<std::size_t>(p)];
      v = p;
    }
    return v;
  };
  for (Index f = 0; f < faces.cols(); ++f)
    for (int k = 1; k < 3; ++k) {
      const int a = root(faces(0, f)), b = root(faces(k, f));
      // The smaller number stays, so that numbers do not depend on the order of the unions.
      if (a != b) parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
  component.assign(static_cast<std::size_t>(vertices), -1);
  int count = 0;
  for (int v = 0; v < static_cast<int>(vertices); ++v) {
    int& its = component[static_cast<std::size_t>(root(v))];
    if (its < 0) its = count++;
    component[static_cast<std::size_t>(v)] = its;
  }
  return count;
}

void keep_faces(LatticeMesh& mesh, const std::vector<bool>& keep) {
  std::vector<int> number(static_cast<std::size_t>(mesh.vertices()), -1);
  std::vector<int> starts = {0};
  Index faces = 0;
  int vertices = 0;
  const std::size_t cubes = mesh.cube_start.empty() ? 0 : mesh.cube_start.size() - 1;
  std::size_t cube = 0;
  for (Index f = 0; f < mesh.faces.cols(); ++f) {
    for (; cube < cubes && f >= mesh.cube_start[cube + 1]; ++cube) starts.push_back(static_cast<int>(faces));
    if (!keep[static_cast<std::size_t>(f)]) continue;
    mesh.faces.col(faces++) = Eigen::Vector3i(mesh.faces.col(f));
  }
  for (; cube < cubes; ++cube) starts.push_back(static_cast<int>(faces));
  if (cubes > 0) mesh.cube_start = starts;
  mesh.faces.conservativeResize(3, faces);
  for (Index f = 0; f < faces; ++f)
    for (int k = 0; k < 3; ++k) number[static_cast<std::size_t>(mesh.faces(k, f))] = 0;
  for (Index v = 0; v < mesh.vertices(); ++v) {
    if (number[static_cast<std::size_t>(v)] < 0) continue;
    const Index to = vertices;
    number[static_cast<std::size_t>(v)] = vertices++;
    mesh.copy_vertex(v, to);
  }
  for (Points<3>* points : {&mesh.positions, &mesh.inside, &mesh.outside})
    points->conservativeResize(3, vertices);
  mesh.inside_values.conservativeResize(vertices);
  mesh.outside_values.conservativeResize(vertices);
  mesh.on_range.resize(static_cast<std::size_t>(vertices));
  for (Index f = 0; f < faces; ++f)
    for (int k = 0; k < 3; ++k) mesh.faces(k, f) = number[static_cast<std::size_t>(mesh.faces(k, f))];
}

}  // namespace seesaw
