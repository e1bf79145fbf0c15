#include "core/contour/triangulation.h"

#include <cmath>

#include "core/base/check.h"

namespace seesaw {
namespace {

constexpr int opposite(int side) { return (side + 2) % 4; }
constexpr int step_x[] = {0, 1, 0, -1};
constexpr int step_y[] = {-1, 0, 1, 0};

}  // namespace

Triangulation::Triangulation(const Lattice& lattice, int turns)
    : lattice_(lattice),
      corners_(static_cast<int>(lattice.corners())),
      turns_(turns),
      cells_(static_cast<std::size_t>(lattice.nx) * static_cast<std::size_t>(lattice.ny), -1) {
  std::vector<char> in(static_cast<std::size_t>(corners_));
  for (std::size_t k = 0; k < in.size(); ++k) in[k] = is_inside(lattice.values[static_cast<Index>(k)]);
  const std::size_t width = static_cast<std::size_t>(lattice.nx) + 1;
  for (int j = 0; j < lattice.ny; ++j) {
    const char* low = in.data() + static_cast<std::size_t>(j) * width;
    const char* high = low + width;
    for (int i = 0; i < lattice.nx; ++i) {
      const int count = low[i] + low[i + 1] + high[i] + high[i + 1];
      if (count != 0 && count != 4) make_cell(i, j);
    }
  }
}

Point<2> Triangulation::uv(int vertex) const {
  if (vertex >= corners_) return refined_uv_[static_cast<std::size_t>(vertex - corners_)];
  return {vertex % (lattice_.nx + 1), vertex / (lattice_.nx + 1)};
}

double Triangulation::value(int vertex) const {
  return vertex < corners_ ? lattice_.values[vertex]
                           : refined_values_[static_cast<std::size_t>(vertex - corners_)];
}

bool Triangulation::is_mixed(int t) const {
  const auto& v = triangle(t).vertex;
  const bool first = inside(v[0]);
  return inside(v[1]) != first || inside(v[2]) != first;
}

int Triangulation::edge_toward(int t, int other) const {
  for (int k = 0; k < 3; ++k)
    if (triangle(t).neighbor[static_cast<std::size_t>(k)] == other) return k;
  SEESAW_CHECK_EQ(t, other);  // They were not neighbors.
  return -1;
}

// Cells alternate the direction of their diagonal, so that the lattice has no preferred one:
//
//   d---c   (i + j) even: a - c, triangles (b, c, a) and (d, a, c)
//   |   |   (i + j) odd:  b - d, triangles (a, b, d) and (c, d, b)
//   a---b   The first has the bottom side.
Triangulation::TriangleEdge Triangulation::root_with_side(int i, int j, int side) const {
  const int first = first_triangle(i, j);
  if ((i + j) % 2 == 0) {
    constexpr TriangleEdge sides[] = {{0, 1}, {0, 2}, {1, 1}, {1, 2}};
    return {first + sides[side].triangle, sides[side].edge};
  }
  constexpr TriangleEdge sides[] = {{0, 2}, {1, 1}, {1, 2}, {0, 1}};
  return {first + sides[side].triangle, sides[side].edge};
}

// For a side whose other cell is not made: it cannot have been bisected, so it is one edge of one leaf.
Triangulation::TriangleEdge Triangulation::leaf_with_side(int i, int j, int side) const {
  const TriangleEdge root = root_with_side(i, j, side);
  const int child = triangle(root.triangle).child;
  if (child < 0) return root;
  return {root.edge == 2 ? child : child + 1, 0};
}

void Triangulation::make_cell(int i, int j) {
  const int a = static_cast<int>(lattice_.corner(i, j)), b = a + 1;
  const int d = static_cast<int>(lattice_.corner(i, j + 1)), c = d + 1;
  const int first = size();
  Triangle low, high;
  if ((i + j) % 2 == 0)
    low.vertex = {b, c, a}, high.vertex = {d, a, c};
  else
    low.vertex = {a, b, d}, high.vertex = {c, d, b};
  low.neighbor = {first + 1, Triangle::not_made, Triangle::not_made};
  high.neighbor = {first, Triangle::not_made, Triangle::not_made};
  low.turns_left = high.turns_left = static_cast<std::int16_t>(turns_);
  triangles_.push_back(low);
  triangles_.push_back(high);
  cells_[cell_index(i, j)] = first;
  for (int side = 0; side < 4; ++side) {
    const auto [t, k] = root_with_side(i, j, side);
    int& across = triangle(t).neighbor[static_cast<std::size_t>(k)];
    const int x = i + step_x[side], y = j + step_y[side];
    if (x < 0 || y < 0 || x >= lattice_.nx || y >= lattice_.ny) {
      across = Triangle::box_side;
    } else if (first_triangle(x, y) >= 0) {
      const auto [other, other_edge] = leaf_with_side(x, y, opposite(side));
      across = other;
      triangle(other).neighbor[static_cast<std::size_t>(other_edge)] = t;
    }
  }
}

// The neighbor across edge k, whose cell is made first if need be.
int Triangulation::neighbor_made(int t, int k) {
  if (triangle(t).neighbor[static_cast<std::size_t>(k)] == Triangle::not_made) {
    const auto [a, b] = edge(t, k);
    const Point<2> p = uv(a), q = uv(b);
    const int i = static_cast<int>(std::min(p.x(), q.x())), j = static_cast<int>(std::min(p.y(), q.y()));
    // The edge runs from (i, j) to the right or up; the cells beside it are (i, j) and the one below or to
    // the left.
    if (first_triangle(i, j) < 0)
      make_cell(i, j);
    else if (p.y() == q.y())
      make_cell(i, j - 1);
    else
      make_cell(i - 1, j);
  }
  return triangle(t).neighbor[static_cast<std::size_t>(k)];
}

// (apex a, l, r) becomes (m, a, l) and (m, r, a), m the middle of l - r.
void Triangulation::split(int t, int middle) {
  const Triangle parent = triangle(t);
  const int child = size();
  const auto [a, l, r] = parent.vertex;
  Triangle left, right;
  left.vertex = {middle, a, l};
  right.vertex = {middle, r, a};
  left.neighbor = {parent.neighbor[2], Triangle::box_side, child + 1};
  right.neighbor = {parent.neighbor[1], child, Triangle::box_side};
  left.crossing[0] = parent.crossing[2];
  right.crossing[0] = parent.crossing[1];
  left.level = right.level = static_cast<std::int16_t>(parent.level + 1);
  left.turns_left = right.turns_left = parent.turns_left;
  for (const int k : {1, 2}) {
    const int other = parent.neighbor[static_cast<std::size_t>(k)];
    if (other < 0) continue;
    for (int& back : triangle(other).neighbor)
      if (back == t) back = k == 2 ? child : child + 1;
  }
  triangle(t).child = child;
  triangles_.push_back(left);
  triangles_.push_back(right);
}

void Triangulation::bisect(int t) {
  int other = neighbor_made(t, 0);
  if (other >= 0 && triangle(other).neighbor[0] != t) {
    bisect(other);
    other = neighbor_made(t, 0);
  }
  const auto [l, r] = edge(t, 0);
  const int middle = corners_ + static_cast<int>(refined_uv_.size());
  refined_uv_.push_back(0.5 * (uv(l) + uv(r)));
  split(t, middle);
  if (other < 0) return;
  split(other, middle);
  const int mine = triangle(t).child, theirs = triangle(other).child;
  // Across the longest side, left and right change places.
  triangle(mine).neighbor[1] = theirs + 1;
  triangle(theirs + 1).neighbor[2] = mine;
  triangle(mine + 1).neighbor[2] = theirs;
  triangle(theirs).neighbor[1] = mine + 1;
}

Points<2> Triangulation::new_positions() const {
  const std::size_t known = refined_values_.size();
  Points<2> positions(2, static_cast<Index>(refined_uv_.size() - known));
  for (Index k = 0; k < positions.cols(); ++k)
    positions.col(k) = lattice_.position(refined_uv_[known + static_cast<std::size_t>(k)]);
  return positions;
}

void Triangulation::set_new_values(const Values& values) {
  refined_values_.insert(refined_values_.end(), values.begin(), values.end());
  SEESAW_CHECK_EQ(refined_values_.size(), refined_uv_.size());
}

bool Triangulation::touches(const Triangle& triangle, const Point<2>& at, double reach) const {
  const std::array<Point<2>, 3> p = {uv(triangle.vertex[0]), uv(triangle.vertex[1]), uv(triangle.vertex[2])};
  for (std::size_t k = 0; k < 3; ++k) {
    const Point<2> along = p[(k + 1) % 3] - p[k], to = at - p[k];
    if (along.x() * to.y() - along.y() * to.x() < -reach * along.norm()) return false;
  }
  // The corners' sharp ends reach further than the edges do.
  const Point<2> low = p[0].cwiseMin(p[1]).cwiseMin(p[2]), high = p[0].cwiseMax(p[1]).cwiseMax(p[2]);
  return (at.array() >= low.array() - reach).all() && (at.array() <= high.array() + reach).all();
}

void Triangulation::leaves_near(const Point<2>& at, double reach, std::vector<int>& leaves) const {
  leaves.clear();
  const auto first = [](double x, int n) { return std::clamp(static_cast<int>(std::floor(x)), 0, n - 1); };
  std::vector<int> open;
  for (int j = first(at.y() - reach, lattice_.ny); j <= first(at.y() + reach, lattice_.ny); ++j)
    for (int i = first(at.x() - reach, lattice_.nx); i <= first(at.x() + reach, lattice_.nx); ++i)
      if (const int root = first_triangle(i, j); root >= 0) open.insert(open.end(), {root + 1, root});
  while (!open.empty()) {
    const int t = open.back();
    open.pop_back();
    const Triangle& triangle = this->triangle(t);
    if (!touches(triangle, at, reach)) continue;
    if (triangle.child < 0)
      leaves.push_back(t);
    else
      open.insert(open.end(), {triangle.child + 1, triangle.child});
  }
}

void Triangulation::make_around(const Point<2>& at, double reach) {
  const auto cell = [](double x, int n) { return std::clamp(static_cast<int>(std::floor(x)), 0, n - 1); };
  for (int j = cell(at.y() - reach, lattice_.ny); j <= cell(at.y() + reach, lattice_.ny); ++j)
    for (int i = cell(at.x() - reach, lattice_.nx); i <= cell(at.x() + reach, lattice_.nx); ++i)
      if (first_triangle(i, j) < 0) make_cell(i, j);
}

}  // namespace seesaw
