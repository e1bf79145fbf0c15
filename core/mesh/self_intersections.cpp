#include "core/mesh/self_intersections.h"

#include <algorithm>
#include <array>

#include "core/base/check.h"
#include "core/base/parallel.h"
#include "core/mesh/face_boxes.h"
#include "core/mesh/predicates.h"

namespace seesaw {

namespace {

using Triangle = std::array<Point<3>, 3>;

// The plane's points seen along axis `axis`.
Point<2> flat(const Point<3>& p, int axis) { return {p[(axis + 1) % 3], p[(axis + 2) % 3]}; }

int side_seen_along(const Point<3>& a, const Point<3>& b, const Point<3>& c, int axis) {
  return seesaw::side_of_line(flat(a, axis), flat(b, axis), flat(c, axis));
}

// An axis along which the triangle is seen with its area, or -1 for a triangle of no area.
int axis_of(const Triangle& t) {
  const Point<3> normal = (t[1] - t[0]).cross(t[2] - t[0]).cwiseAbs();
  Index best = 0;
  normal.maxCoeff(&best);
  for (int k = 0; k < 3; ++k) {
    const int axis = (static_cast<int>(best) + k) % 3;
    if (side_seen_along(t[0], t[1], t[2], axis) != 0) return axis;
  }
  return -1;
}

// Is p, on the line through a and b, between them?
bool between(const Point<2>& a, const Point<2>& b, const Point<2>& p) {
  return Box<2>(a.cwiseMin(b), a.cwiseMax(b)).contains(p);
}

bool segments_meet(const Point<2>& a, const Point<2>& b, const Point<2>& p, const Point<2>& q) {
  const int ap = seesaw::side_of_line(a, b, p), aq = seesaw::side_of_line(a, b, q);
  const int pa = seesaw::side_of_line(p, q, a), pb = seesaw::side_of_line(p, q, b);
  if (ap * aq < 0 && pa * pb < 0) return true;
  return (ap == 0 && between(a, b, p)) || (aq == 0 && between(a, b, q)) || (pa == 0 && between(p, q, a)) ||
         (pb == 0 && between(p, q, b));
}

bool segment_meets_triangle_in_plane(const Point<3>& p, const Point<3>& q, const Triangle& t, int axis) {
  int left = 0, right = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const int side = side_seen_along(t[k], t[(k + 1) % 3], p, axis);
    left += side >= 0;
    right += side <= 0;
  }
  if (left == 3 || right == 3) return true;
  for (std::size_t k = 0; k < 3; ++k)
    if (segments_meet(flat(p, axis), flat(q, axis), flat(t[k], axis), flat(t[(k + 1) % 3], axis)))
      return true;
  return false;
}

// Have the segment and the triangle, both with their rims, a point in common?
bool segment_meets_triangle(const Point<3>& p, const Point<3>& q, const Triangle& t, int axis) {
  const int side_p = side_of_plane(t[0], t[1], t[2], p), side_q = side_of_plane(t[0], t[1], t[2], q);
  if (side_p * side_q > 0) return false;
  if (side_p == 0 && side_q == 0) return segment_meets_triangle_in_plane(p, q, t, axis);
  int left = 0, right = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const int side = side_of_plane(p, q, t[k], t[(k + 1) % 3]);
    left += side >= 0;
    right += side <= 0;
  }
  return left == 3 || right == 3;
}

class Pairs {
 public:
  explicit Pairs(const TriangleMesh& mesh) : mesh_(mesh), axes_(static_cast<std::size_t>(mesh.faces.cols())) {
    for (Index f = 0; f < mesh.faces.cols(); ++f) axes_[static_cast<std::size_t>(f)] = axis_of(triangle(f));
  }

  bool has_area(Index f) const { return axes_[static_cast<std::size_t>(f)] >= 0; }

  bool intersect(Index f, Index g) const {
    std::array<int, 3> f_common{}, g_common{};  // the corners of f and of g that are one vertex
    std::size_t common = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (mesh_.faces(i, f) == mesh_.faces(j, g)) {
          f_common[common] = i;
          g_common[common++] = j;
        }
    if (common == 3) return true;
    const Triangle a = triangle(f), b = triangle(g);
    if (common == 2) {
      const Point<3>& a_tip = a[static_cast<std::size_t>(3 - f_common[0] - f_common[1])];
      const Point<3>& b_tip = b[static_cast<std::size_t>(3 - g_common[0] - g_common[1])];
      if (side_of_plane(a[0], a[1], a[2], b_tip) != 0) return false;
      const Point<3>& from = a[static_cast<std::size_t>(f_common[0])];
      const Point<3>& to = a[static_cast<std::size_t>(f_common[1])];
      const int axis = axes_[static_cast<std::size_t>(f)];
      return side_seen_along(from, to, a_tip, axis) == side_seen_along(from, to, b_tip, axis);
    }
    const auto side_meets = [](const Triangle& s, int corner, const Triangle& t, int axis) {
      return segment_meets_triangle(s[static_cast<std::size_t>((corner + 1) % 3)],
                                    s[static_cast<std::size_t>((corner + 2) % 3)], t, axis);
    };
    const int f_axis = axes_[static_cast<std::size_t>(f)], g_axis = axes_[static_cast<std::size_t>(g)];
    if (common == 1) return side_meets(a, f_common[0], b, g_axis) || side_meets(b, g_common[0], a, f_axis);
    if (apart(a, b) || apart(b, a)) return false;
    for (int corner = 0; corner < 3; ++corner)
      if (side_meets(a, corner, b, g_axis) || side_meets(b, corner, a, f_axis)) return true;
    return false;
  }

 private:
  Triangle triangle(Index f) const {
    return {mesh_.vertices.col(mesh_.faces(0, f)), mesh_.vertices.col(mesh_.faces(1, f)),
            mesh_.vertices.col(mesh_.faces(2, f))};
  }
  // All of b on one side of a's plane: most pairs end here.
  static bool apart(const Triangle& a, const Triangle& b) {
    const int side = side_of_plane(a[0], a[1], a[2], b[0]);
    return side != 0 && side_of_plane(a[0], a[1], a[2], b[1]) == side &&
           side_of_plane(a[0], a[1], a[2], b[2]) == side;
  }

  const TriangleMesh& mesh_;
  std::vector<int> axes_;
};

}  // namespace

std::vector<std::pair<int, int>> self_intersections(const TriangleMesh& mesh, const Progress& progress) {
  SEESAW_CHECK_EQ(mesh.vertices.allFinite(), true);
  if (mesh.faces.cols() == 0) return {};
  SEESAW_CHECK_LE(0, mesh.faces.minCoeff());
  SEESAW_CHECK_LT(Index{mesh.faces.maxCoeff()}, mesh.vertices.cols());
  const Pairs pairs(mesh);
  std::vector<int> chosen;
  for (Index f = 0; f < mesh.faces.cols(); ++f)
    if (pairs.has_area(f)) chosen.push_back(static_cast<int>(f));
  const FaceBoxes tree(mesh, chosen);
  const auto count = static_cast<Index>(chosen.size());
  constexpr Index block = 1024;
  std::vector<std::vector<std::pair<int, int>>> found(static_cast<std::size_t>((count + block - 1) / block));
  const auto search = [&](Index begin, Index end) {
    for (Index i = begin; i < end; ++i) {
      const int f = chosen[static_cast<std::size_t>(i)];
      Box<3> box;
      for (int k = 0; k < 3; ++k) box.extend(Point<3>(mesh.vertices.col(mesh.faces(k, f))));
      tree.visit(box, [&](int g) {
        if (f < g && pairs.intersect(f, g)) found[static_cast<std::size_t>(i / block)].emplace_back(f, g);
      });
    }
  };
  // In runs of blocks, so that the caller's own thread can report between them.
  constexpr Index run = 64 * block;
  for (Index begin = 0; begin < count; begin += run) {
    report(progress, static_cast<double>(begin) / static_cast<double>(count));
    parallel_blocks(std::min(run, count - begin), block,
                    [&](Index from, Index to) { search(begin + from, begin + to); });
  }
  std::vector<std::pair<int, int>> all;
  for (auto& some : found) {
    std::sort(some.begin(), some.end());
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

}  // namespace seesaw
