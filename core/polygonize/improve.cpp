#include "core/polygonize/improve.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/polygonize/half_edges.h"
#include "core/polygonize/project.h"

namespace seesaw {

namespace {

// An edge shorter than this many cubes collapses. Lattice edges' crossings are half a cube to 1.4 cubes apart
// where the lattice is at its best.
constexpr double short_edge = 0.45;
// Qualities are squared sines of the smallest angle: no roots in the inner loops. Below the first, 17
// degrees, an angle may not be made smaller by a collapse; the second, 30 degrees, is good enough for
// sliding.
constexpr double good_for_collapse = 0.09, good_for_slide = 0.25;
// A triangle better than this, 37 degrees, is left as it is.
constexpr double good_as_it_is = 0.36;
// Cosine of the largest turn of a triangle that a move may make, and of the fold across an edge that flips.
constexpr double largest_turn = 0.5;
constexpr double largest_fold = 0.8;
constexpr double slide = 0.3;  // farthest, in cubes
constexpr int rounds = 3;

using Vector = Point<3>;

Vector normal_of(const Vector& a, const Vector& b, const Vector& c) { return (b - a).cross(c - a); }

// The squared sine of a triangle's smallest angle: twice the area over the product of the two longer sides.
double quality_of(const Vector& a, const Vector& b, const Vector& c, const Vector& normal) {
  const double x = (b - a).squaredNorm(), y = (c - b).squaredNorm(), z = (a - c).squaredNorm();
  const double shortest = std::min({x, y, z});
  return shortest > 0 ? normal.squaredNorm() * shortest / (x * y * z) : 0.0;
}
double quality_of(const Vector& a, const Vector& b, const Vector& c) {
  return quality_of(a, b, c, normal_of(a, b, c));
}

// Whether the angle between a and b has a cosine of `cosine` > 0 or more.
bool within(const Vector& a, const Vector& b, double cosine) {
  const double dot = a.dot(b);
  return dot > 0 && dot * dot >= cosine * cosine * a.squaredNorm() * b.squaredNorm();
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
  void try_flip(int h);
  // Whether the triangles around v (but those of half-edge `without` and its twin, if any) may have v at
  // `to`. `least` is the worst quality there, `fresh` what it would be.
  bool may_move(int v, const Vector& to, int without, double& least, double& fresh) const;

  // The faces that are not good as they are, in order. Flips and slides look at no others: most of a mesh is
  // good from the start.
  std::vector<int> needy_faces() const;

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
    least = std::min(least, quality_of(from, b, c, before));
    fresh = std::min(fresh, quality_of(to, b, c, after));
    may = before.isZero(0) || within(before, after, largest_turn);
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
  if (is_fixed(net_.target(h))) return try_collapse_into(t) || try_collapse_into(h);
  return try_collapse_into(h) || (is_fixed(net_.origin(h)) && try_collapse_into(t));
}

bool Improver::try_collapse_into(int h) {
  const int a = net_.origin(h), b = net_.target(h), t = net_.twin(h);
  const bool swap = t < 0 && !may_become(b, a);  // then it is b that stays, under the name of a
  if (!(swap ? may_become(a, b) : may_become(b, a))) return false;
  if (!net_.can_collapse(h)) return false;
  const Vector to = swap ? at(b) : is_fixed(a) ? at(a) : Vector(0.5 * (at(a) + at(b)));
  double least = 1, fresh = 1;
  if (!may_move(a, to, h, least, fresh) || !may_move(b, to, h, least, fresh)) return false;
  for (const int dying : {h, t}) {
    if (dying < 0) continue;
    const Vector x = at(net_.origin(dying)), y = at(net_.target(dying)),
                 z = at(net_.origin(HalfEdges::previous(dying)));
    least = std::min(least, quality_of(x, y, z));
  }
  if (fresh < std::min(least, good_for_collapse)) return false;
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
    std::vector<double> lengths(static_cast<std::size_t>(net_.size()), 2 * limit + 1);
    parallel_blocks(net_.size(), 3 * 4096, [&](Index begin, Index end) {
      for (int h = static_cast<int>(begin); h < static_cast<int>(end); ++h)
        if (net_.is_alive(h) && (net_.twin(h) > h || net_.twin(h) < 0))
          lengths[static_cast<std::size_t>(h)] = (at(net_.origin(h)) - at(net_.target(h))).squaredNorm();
    });
    std::vector<Edge> edges;
    for (int h = 0; h < net_.size(); ++h)
      if (const double its = lengths[static_cast<std::size_t>(h)]; its <= limit) edges.push_back({its, h});
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

std::vector<int> Improver::needy_faces() const {
  const Index count = net_.size() / 3;
  std::vector<char> needy(static_cast<std::size_t>(count), 0);
  parallel_blocks(count, 4096, [&](Index begin, Index end) {
    for (int f = static_cast<int>(begin); f < static_cast<int>(end); ++f)
      if (net_.is_alive(3 * f))
        needy[static_cast<std::size_t>(f)] = quality_of(at(net_.origin(3 * f)), at(net_.origin(3 * f + 1)),
                                                        at(net_.origin(3 * f + 2))) < good_as_it_is;
  });
  std::vector<int> faces;
  for (int f = 0; f < static_cast<int>(count); ++f)
    if (needy[static_cast<std::size_t>(f)]) faces.push_back(f);
  return faces;
}

void Improver::flip_all() {
  for (const int face : needy_faces())
    for (int h = 3 * face; h < 3 * face + 3; ++h) try_flip(h);
}

void Improver::try_flip(int h) {
  const int t = net_.twin(h);
  if (t < 0) return;
  const int p = net_.origin(h), q = net_.target(h), r = net_.origin(HalfEdges::previous(h)),
            s = net_.origin(HalfEdges::previous(t));
  const Vector a = at(p), b = at(q), c = at(r), d = at(s);
  const Vector n1 = normal_of(a, b, c), n2 = normal_of(b, a, d);
  if (!within(n1, n2, largest_fold)) return;
  const double before = std::min(quality_of(a, b, c, n1), quality_of(b, a, d, n2));
  const Vector m1 = normal_of(d, c, a), m2 = normal_of(c, d, b);
  const double after = std::min(quality_of(d, c, a, m1), quality_of(c, d, b, m2));
  if (after < 1.1 * before || after < before + 1e-4) return;
  const Vector n = n1 + n2;
  if (!within(m1, m2, largest_fold) || !within(m1, n, largest_fold) || !within(m2, n, largest_fold)) return;
  if (net_.can_flip(h)) net_.flip(h);
}

void Improver::slide_all(Sampler& sampler) {
  std::vector<int> movable;
  for (const int f : needy_faces())
    for (int h = 3 * f; h < 3 * f + 3; ++h)
      if (!is_fixed(net_.origin(h))) movable.push_back(net_.origin(h));
  std::sort(movable.begin(), movable.end());
  movable.erase(std::unique(movable.begin(), movable.end()), movable.end());
  Points<3> targets(3, static_cast<Index>(movable.size()));
  const auto propose = [&](std::size_t i) {
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
  };
  parallel_blocks(targets.cols(), 1024, [&](Index begin, Index end) {
    for (Index i = begin; i < end; ++i) propose(static_cast<std::size_t>(i));
  });
  const Projected projected = project(sampler, targets, {}, {.leash = 0.25 * cell_, .steps = 1});
  for (std::size_t i = 0; i < movable.size(); ++i) {
    if (!projected.good[i]) continue;
    const Vector to = projected.positions.col(static_cast<Index>(i));
    double least = 1, fresh = 1;
    if (may_move(movable[i], to, -1, least, fresh) && fresh >= std::min(least, good_for_slide))
      mesh_.positions.col(movable[i]) = to;
  }
}

}  // namespace

double smallest_angle(const Points<3>& positions, const Faces& faces) {
  double least = 1;
  for (Index f = 0; f < faces.cols(); ++f)
    least = std::min(least, quality_of(positions.col(faces(0, f)), positions.col(faces(1, f)),
                                       positions.col(faces(2, f))));
  return faces.cols() == 0 ? 0.0 : std::asin(std::sqrt(least)) * (180 / 3.14159265358979323846);
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
