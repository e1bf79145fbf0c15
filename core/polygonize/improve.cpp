#include "core/polygonize/improve.h"

#include <algorithm>
#include <cmath>

#include "core/polygonize/half_edges.h"
#include "core/polygonize/project.h"

namespace seesaw {

namespace {

// An edge shorter than this many cubes collapses. Lattice edges' crossings are half a cube to 1.4 cubes apart
// where the lattice is at its best.
constexpr double short_edge = 0.45;
// Below a third of the equilateral triangle's, the sine of an angle may not be made smaller.
constexpr double good_sine = 0.3;
// Cosine of the largest turn of a triangle that a move may make, and of the fold across an edge that flips.
constexpr double largest_turn = 0.5;
constexpr double largest_fold = 0.8;
constexpr double slide = 0.3;  // farthest, in cubes
constexpr int rounds = 2;

using Vector = Point<3>;

Vector normal_of(const Vector& a, const Vector& b, const Vector& c) { return (b - a).cross(c - a); }

// The sine of a triangle's smallest angle: twice the area over the product of the two longer sides.
double sine_of(const Vector& a, const Vector& b, const Vector& c, double double_area) {
  const double x = (b - a).squaredNorm(), y = (c - b).squaredNorm(), z = (a - c).squaredNorm();
  const double product = x * y * z, shortest = std::min({x, y, z});
  return shortest > 0 ? double_area / std::sqrt(product / shortest) : 0.0;
}

class Improver {
 public:
  Improver(LatticeMesh& mesh, double cell) : mesh_(mesh), net_(mesh.faces, mesh.vertices()), cell_(cell) {}

  void collapse_below(double length);
  void flip_all();
  void slide_all(Sampler& sampler);
  // The mesh without what has collapsed.
  void finish() {
    mesh_.faces = net_.faces();
    mesh_.cube_start.clear();
    keep_faces(mesh_, std::vector<bool>(static_cast<std::size_t>(mesh_.faces.cols()), true));
  }

 private:
  Vector at(int v) const { return mesh_.positions.col(v); }
  bool is_fixed(int v) const {
    return mesh_.on_range[static_cast<std::size_t>(v)] != 0 || net_.is_boundary(v);
  }
  bool may_become(int v, int other) const;
  bool try_collapse(int h);
  bool try_collapse_into(int h);
  // Whether the triangles around v (but those of half-edge `without` and its twin, if any) may have v at
  // `to`. `least` is the smallest sine there, `fresh` what it would be.
  bool may_move(int v, const Vector& to, int without, double& least, double& fresh) const;

  LatticeMesh& mesh_;
  HalfEdges net_;
  double cell_;
};

bool Improver::may_move(int v, const Vector& to, int without, double& least, double& fresh) const {
  bool may = true;
  const int dead = without >= 0 ? without / 3 : -1,
            dead_too = without >= 0 && net_.twin(without) >= 0 ? net_.twin(without) / 3 : -1;
  const Vector from = at(v);
  net_.for_each_leaving(v, [&](int h) {
    if (!may || h / 3 == dead || h / 3 == dead_too) return;
    const Vector b = at(net_.target(h)), c = at(net_.origin(HalfEdges::previous(h)));
    const Vector before = normal_of(from, b, c), after = normal_of(to, b, c);
    const double old_area = before.norm(), new_area = after.norm();
    least = std::min(least, sine_of(from, b, c, old_area));
    fresh = std::min(fresh, sine_of(to, b, c, new_area));
    may = old_area == 0 || before.dot(after) > largest_turn * old_area * new_area;
  });
  return may;
}

// A vertex on a face of the range may go only where it stays on that face.
bool Improver::may_become(int v, int other) const {
  const unsigned planes = mesh_.on_range[static_cast<std::size_t>(v)];
  return (planes & ~static_cast<unsigned>(mesh_.on_range[static_cast<std::size_t>(other)])) == 0;
}

// Collapses the edge of h, one way or the other, if that does no harm.
bool Improver::try_collapse(int h) {
  const int t = net_.twin(h);
  if (t < 0) return try_collapse_into(h);  // a boundary edge has one way only: see half_edges.h
  return is_fixed(net_.target(h)) ? try_collapse_into(t) : try_collapse_into(h);
}

bool Improver::try_collapse_into(int h) {
  const int a = net_.origin(h), b = net_.target(h), t = net_.twin(h);
  const bool swap = t < 0 && !may_become(b, a);  // then it is b that stays, under the name of a
  if (!(swap ? may_become(a, b) : may_become(b, a))) return false;
  if ((t >= 0 && is_fixed(b)) || !net_.can_collapse(h)) return false;
  const Vector to = swap ? at(b) : is_fixed(a) ? at(a) : Vector(0.5 * (at(a) + at(b)));
  double least = 1, fresh = 1;
  if (!may_move(a, to, h, least, fresh) || !may_move(b, to, h, least, fresh)) return false;
  for (const int dying : {h, t}) {
    if (dying < 0) continue;
    const Vector x = at(net_.origin(dying)), y = at(net_.target(dying)),
                 z = at(net_.origin(HalfEdges::previous(dying)));
    least = std::min(least, sine_of(x, y, z, normal_of(x, y, z).norm()));
  }
  if (fresh < std::min(least, good_sine)) return false;
  net_.collapse(h);
  if (swap) mesh_.copy_vertex(b, a);
  mesh_.positions.col(a) = to;
  return true;
}

void Improver::collapse_below(double length) {
  struct Edge {
    double length;
    int h;
    bool operator<(const Edge& other) const {
      return length < other.length || (length == other.length && h < other.h);
    }
  };
  const double limit = length * length;
  for (bool again = true; again;) {
    std::vector<Edge> edges;
    for (int h = 0; h < net_.size(); ++h)
      if (net_.is_alive(h) && (net_.twin(h) > h || net_.twin(h) < 0)) {
        const double its = (at(net_.origin(h)) - at(net_.target(h))).squaredNorm();
        if (its <= limit) edges.push_back({its, h});
      }
    std::sort(edges.begin(), edges.end());
    Index collapsed = 0;
    for (const Edge& edge : edges) {
      if (!net_.is_alive(edge.h)) continue;
      if ((at(net_.origin(edge.h)) - at(net_.target(edge.h))).squaredNorm() > limit) continue;
      collapsed += try_collapse(edge.h) ? 1 : 0;
    }
    // Another look where much has changed; for edges of no length, where anything has.
    again = length == 0 ? collapsed > 0 : 50 * collapsed > net_.size() / 3;
  }
}

void Improver::flip_all() {
  for (int h = 0; h < net_.size(); ++h) {
    const int t = net_.is_alive(h) ? net_.twin(h) : -1;
    if (t < h) continue;
    const int p = net_.origin(h), q = net_.target(h), r = net_.origin(HalfEdges::previous(h)),
              s = net_.origin(HalfEdges::previous(t));
    const Vector a = at(p), b = at(q), c = at(r), d = at(s);
    const Vector n1 = normal_of(a, b, c), n2 = normal_of(b, a, d);
    const double area1 = n1.norm(), area2 = n2.norm();
    const double before = std::min(sine_of(a, b, c, area1), sine_of(b, a, d, area2));
    if (n1.dot(n2) < largest_fold * area1 * area2) continue;
    const Vector m1 = normal_of(d, c, a), m2 = normal_of(c, d, b);
    const double new1 = m1.norm(), new2 = m2.norm();
    const double after = std::min(sine_of(d, c, a, new1), sine_of(c, d, b, new2));
    if (after < 1.05 * before || after < before + 1e-3) continue;
    const Vector n = n1 + n2;
    if (m1.dot(m2) < largest_fold * new1 * new2 || m1.dot(n) < largest_fold * new1 * n.norm() ||
        m2.dot(n) < largest_fold * new2 * n.norm())
      continue;
    if (net_.can_flip(h)) net_.flip(h);
  }
}

void Improver::slide_all(Sampler& sampler) {
  std::vector<int> movable;
  for (int v = 0; v < static_cast<int>(mesh_.vertices()); ++v)
    if (net_.leaving(v) >= 0 && !is_fixed(v)) movable.push_back(v);
  Points<3> targets(3, static_cast<Index>(movable.size()));
  for (std::size_t i = 0; i < movable.size(); ++i) {
    const Vector here = at(movable[i]);
    Vector sum = Vector::Zero(), normal = Vector::Zero();
    double count = 0;
    net_.for_each_leaving(movable[i], [&](int h) {
      const Vector b = at(net_.target(h)), c = at(net_.origin(HalfEdges::previous(h)));
      normal += normal_of(here, b, c);
      sum += b - here;
      ++count;
    });
    Vector move = sum / count;
    if (const double size = normal.squaredNorm(); size > 0) move -= normal * (normal.dot(move) / size);
    if (const double size = move.norm(); size > slide * cell_) move *= slide * cell_ / size;
    targets.col(static_cast<Index>(i)) = here + move;
  }
  const Projected projected = project(sampler, targets, {}, {.leash = 0.25 * cell_, .steps = 1});
  for (std::size_t i = 0; i < movable.size(); ++i) {
    if (!projected.good[i]) continue;
    const Vector to = projected.positions.col(static_cast<Index>(i));
    double least = 1, fresh = 1;
    if (may_move(movable[i], to, -1, least, fresh) && fresh >= std::min(least, 0.5))
      mesh_.positions.col(movable[i]) = to;
  }
}

}  // namespace

double smallest_angle(const Points<3>& positions, const Faces& faces) {
  double least = 1;
  for (Index f = 0; f < faces.cols(); ++f) {
    const Vector a = positions.col(faces(0, f)), b = positions.col(faces(1, f)),
                 c = positions.col(faces(2, f));
    least = std::min(least, sine_of(a, b, c, normal_of(a, b, c).norm()));
  }
  return faces.cols() == 0 ? 0.0 : std::asin(least) * (180 / 3.14159265358979323846);
}

void collapse_empty_edges(LatticeMesh& mesh, double cell) {
  Improver improver(mesh, cell);
  improver.collapse_below(0);
  improver.finish();
}

void improve(LatticeMesh& mesh, Sampler& sampler, double cell) {
  Improver improver(mesh, cell);
  improver.collapse_below(0);
  improver.collapse_below(short_edge * cell);
  for (int round = 0; round < rounds; ++round) {
    improver.flip_all();
    improver.slide_all(sampler);
  }
  improver.flip_all();
  improver.finish();
}

}  // namespace seesaw
