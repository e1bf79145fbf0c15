#include "core/polygonize/cube_table.h"

#include <algorithm>

#include "core/base/check.h"
#include "core/base/types.h"

namespace seesaw {

const std::array<CubeEdge, 12> cube_edges = {
    {{0, 0}, {2, 0}, {4, 0}, {6, 0}, {0, 1}, {1, 1}, {4, 1}, {5, 1}, {0, 2}, {1, 2}, {2, 2}, {3, 2}}};

namespace {

using Loop = std::vector<int>;

// The corners of face 2 axis + side, counter-clockwise as seen from outside the cube.
std::array<int, 4> face_corners(int face) {
  const int axis = face / 2, u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
  if (face % 2 == 1) return {1 << axis, 1 << axis | u, 1 << axis | u | v, 1 << axis | v};
  return {0, v, u | v, u};
}

int edge_between(int a, int b) {
  for (std::size_t e = 0; e < 12; ++e)
    if ((cube_edges[e].low == a && cube_edges[e].high() == b) ||
        (cube_edges[e].low == b && cube_edges[e].high() == a))
      return static_cast<int>(e);
  return -1;
}

bool share_a_face(int e, int f) {
  const auto on_face = [](int edge, int face) {
    const CubeEdge& it = cube_edges[static_cast<std::size_t>(edge)];
    const int axis = face / 2, side = face % 2;
    return it.axis != axis && (it.low >> axis & 1) == side;
  };
  for (int face = 0; face < 6; ++face)
    if (on_face(e, face) && on_face(f, face)) return true;
  return false;
}

// Going around a face counter-clockwise as seen from outside the cube, a segment leads from where one comes
// inside to where one goes out again. So a loop runs counter-clockwise around the solid's outward normal.
std::vector<Loop> loops_of(unsigned inside) {
  std::array<int, 12> next;
  next.fill(-1);
  for (int face = 0; face < 6; ++face) {
    const auto corner = face_corners(face);
    const auto is_inside = [&](std::size_t i) { return (inside >> corner[i % 4] & 1u) != 0; };
    for (std::size_t i = 0; i < 4; ++i) {
      if (!is_inside(i) || is_inside(i + 1)) continue;
      // Out between corners i and i + 1. Where did we come in before? That cuts off the inside corners by
      // themselves.
      std::size_t in = i + 3;
      while (is_inside(in)) --in;
      next[static_cast<std::size_t>(edge_between(corner[in % 4], corner[(in + 1) % 4]))] =
          edge_between(corner[i], corner[(i + 1) % 4]);
    }
  }
  std::vector<Loop> loops;
  std::array<bool, 12> seen{};
  for (std::size_t e = 0; e < 12; ++e) {
    Loop loop;
    for (std::size_t at = e; next[at] >= 0 && !seen[at]; at = static_cast<std::size_t>(next[at])) {
      seen[at] = true;
      loop.push_back(static_cast<int>(at));
    }
    if (!loop.empty()) loops.push_back(loop);
  }
  return loops;
}

Point<3> middle(int edge) {
  const CubeEdge& it = cube_edges[static_cast<std::size_t>(edge)];
  Point<3> p(it.low & 1, it.low >> 1 & 1, it.low >> 2);
  p[it.axis] += 0.5;
  return p;
}

// The cut of loop[first .. last] whose worst triangle, with vertices in the middle of their edges, is the
// best. Returns its quality, below zero where the diagonals would have to lie in a face.
double best_cut(const Loop& loop, std::size_t first, std::size_t last, CubeTriangles& triangles) {
  if (last - first < 2) return 1;
  double best = -1;
  CubeTriangles best_triangles;
  for (std::size_t k = first + 1; k < last; ++k) {
    const auto forbidden = [&](std::size_t a, std::size_t b) {
      return b - a > 1 && !(a == 0 && b == loop.size() - 1) && share_a_face(loop[a], loop[b]);
    };
    if (forbidden(first, k) || forbidden(k, last)) continue;
    const Point<3> a = middle(loop[first]), b = middle(loop[k]), c = middle(loop[last]);
    CubeTriangles these = {{static_cast<std::uint8_t>(loop[first]), static_cast<std::uint8_t>(loop[k]),
                            static_cast<std::uint8_t>(loop[last])}};
    double quality = (b - a).cross(c - a).norm() /
                     std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    quality = std::min({quality, best_cut(loop, first, k, these), best_cut(loop, k, last, these)});
    if (quality > best) {
      best = quality;
      best_triangles = these;
    }
  }
  triangles.insert(triangles.end(), best_triangles.begin(), best_triangles.end());
  return best;
}

struct Table {
  std::array<CubeTriangles, 256> triangles;
  std::array<unsigned, 256> faces{};
  Table() {
    for (unsigned inside = 0; inside < 256; ++inside) {
      for (const Loop& loop : loops_of(inside))
        SEESAW_CHECK_GE(best_cut(loop, 0, loop.size() - 1, triangles[inside]), 0.0);
      for (int face = 0; face < 6; ++face) {
        int count = 0;
        for (const int c : face_corners(face)) count += static_cast<int>(inside >> c & 1u);
        if (count % 4 != 0) faces[inside] |= 1u << face;
      }
    }
  }
};

const Table& table() {
  static const Table made;
  return made;
}

}  // namespace

const CubeTriangles& cube_triangles(unsigned inside) { return table().triangles[inside]; }
unsigned crossed_faces(unsigned inside) { return table().faces[inside]; }

}  // namespace seesaw
