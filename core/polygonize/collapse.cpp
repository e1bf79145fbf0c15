#include "core/polygonize/collapse.h"

#include "core/polygonize/moves.h"
#include "core/polygonize/triangle_quality.h"

namespace seesaw {

namespace {

// A short edge's collapse makes no triangle worse than this, 17 degrees, or than the worst was before.
constexpr double good_for_short = 0.09;
// By what factor a needle's collapse must better the worst triangle.
constexpr double gain_for_needle = 1.1;

struct Collapse {
  double urgency;  // the smaller, the sooner
  int edge;        // by which it was found
  int h;           // its target vanishes; the same edge
  bool swap;       // and its origin becomes what the target was
  Point<3> to;     // where the origin goes

  bool operator<(const Collapse& other) const {
    return urgency < other.urgency || (urgency == other.urgency && edge < other.edge);
  }
};

class Collapser {
 public:
  explicit Collapser(WorkingMesh& work) : work_(work), net_(work.net) {}

  std::optional<Collapse> look_at_short(int h) const;
  std::optional<Collapse> look_at_needle(int h) const;
  void make(const Collapse& move, VertexSet& changed);
  double squared_length(int h) const {
    return (work_.at(net_.origin(h)) - work_.at(net_.target(h))).squaredNorm();
  }

 private:
  std::optional<Collapse> look_into(int edge, int h) const;
  bool may_become(int v, int other) const;
  // The worst quality of the triangles around the edge of h, as they are.
  double worst_before(int h) const {
    return std::min(work_.worst_around(net_.origin(h)), work_.worst_around(net_.target(h)));
  }
  bool stays_good(int v, const Point<3>& to, int h, double least, double& worst) const;
  std::optional<double> worst_after(int h, const Point<3>& to, double least) const;

  WorkingMesh& work_;
  HalfEdges& net_;
};

// A vertex on a face of the range may go only where it stays on that face.
bool Collapser::may_become(int v, int other) const {
  const std::vector<std::uint8_t>& planes = work_.mesh.on_range;
  return (planes[static_cast<std::size_t>(v)] & ~planes[static_cast<std::size_t>(other)]) == 0;
}

// Whether no triangle around v, but those at h, turns over or becomes worse than `least` when v goes `to`.
// `worst` becomes the quality of the worst, if that is less.
bool Collapser::stays_good(int v, const Point<3>& to, int h, double least, double& worst) const {
  const int dying = h / 3, dying_too = net_.twin(h) >= 0 ? net_.twin(h) / 3 : -1;
  const Point<3> from = work_.at(v);
  return !net_.any_leaving(v, [&](int g) {
    if (g / 3 == dying || g / 3 == dying_too) return false;
    const Point<3> b = work_.at(net_.target(g)), c = work_.at(net_.origin(HalfEdges::previous(g)));
    const Point<3> before = normal_of(from, b, c), after = normal_of(to, b, c);
    worst = std::min(worst, quality_of(to, b, c, after));
    return worst < least || (!before.isZero(0) && !within(before, after, largest_turn));
  });
}

// The worst quality when the edge of h collapses and its ends go `to`; nothing if a triangle turns over or
// becomes worse than `least`.
std::optional<double> Collapser::worst_after(int h, const Point<3>& to, double least) const {
  double worst = 1;
  for (const int v : {net_.origin(h), net_.target(h)})
    if (!stays_good(v, to, h, least, worst)) return {};
  return worst;
}

std::optional<Collapse> Collapser::look_into(int edge, int h) const {
  const int a = net_.origin(h), b = net_.target(h);
  const bool swap = net_.twin(h) < 0 && !may_become(b, a);  // then b is who stays, under the name of a
  if (!(swap ? may_become(a, b) : may_become(b, a))) return {};
  const Point<3> p = work_.at(a), q = work_.at(b);
  const Point<3> to = swap ? q : work_.is_fixed(a) ? p : Point<3>(0.5 * (p + q));
  if (!worst_after(h, to, std::min(worst_before(h), good_for_short)) || !net_.can_collapse(h)) return {};
  return Collapse{squared_length(h), edge, h, swap, to};
}

// One way or the other.
std::optional<Collapse> Collapser::look_at_short(int h) const {
  const int t = net_.twin(h);
  if (t < 0) return look_into(h, h);  // a boundary edge has one way only: see half_edges.h
  const bool origin_is_fixed = work_.is_fixed(net_.origin(h)),
             target_is_fixed = work_.is_fixed(net_.target(h));
  const int first = target_is_fixed ? t : h;
  if (const std::optional<Collapse> found = look_into(h, first)) return found;
  return origin_is_fixed || target_is_fixed ? look_into(h, first == h ? t : h) : std::nullopt;
}

// The best way: into either end, or into the middle.
std::optional<Collapse> Collapser::look_at_needle(int h) const {
  std::optional<Collapse> best;
  const double before = worst_before(h);
  double least = gain_for_needle * before;
  for (const int g : {h, net_.twin(h)}) {
    if (g < 0) continue;
    const int a = net_.origin(g), b = net_.target(g);
    if (!may_become(b, a) || !net_.can_collapse(g)) continue;
    for (const double way : {0.0, 0.5}) {
      if (way > 0 && work_.is_fixed(a)) continue;
      const Point<3> to = work_.at(a) + way * (work_.at(b) - work_.at(a));
      const std::optional<double> worst = worst_after(g, to, least);
      if (!worst || *worst <= least) continue;
      least = *worst;
      best = Collapse{before, h, g, false, to};
    }
  }
  return best;
}

void Collapser::make(const Collapse& move, VertexSet& changed) {
  const int a = net_.origin(move.h), b = net_.target(move.h), t = net_.twin(move.h);
  net_.collapse(move.h);
  if (move.swap) work_.mesh.copy_vertex(b, a);
  work_.mesh.positions.col(a) = move.to;
  work_.renew(move.h / 3);
  if (t >= 0) work_.renew(t / 3);
  changed.add(a);
  net_.for_each_leaving(a, [&](int h) {
    work_.renew(h / 3);
    changed.add(net_.target(h));
    changed.add(net_.origin(HalfEdges::previous(h)));
  });
}

}  // namespace

void collapse_short_edges(WorkingMesh& work, double length) {
  Collapser collapser(work);
  // Another look where much has changed; for edges of no length, where anything has.
  const Index few = length == 0 ? 0 : work.net.size() / 3 / 50;
  Index made = few + 1;
  for (VertexSet changed(work.net.vertices(), true); made > few;) {
    made = 0;
    changed = make_moves<Collapse>(
        work.net,
        [&](int h) {
          const bool asked = collapser.squared_length(h) <= length * length && is_near(changed, work.net, h);
          return asked ? collapser.look_at_short(h) : std::nullopt;
        },
        [&](const Collapse& move, VertexSet& now) {
          collapser.make(move, now);
          ++made;
        });
  }
}

void collapse_needles(WorkingMesh& work) {
  Collapser collapser(work);
  make_moves<Collapse>(
      work.net,
      [&](int h) { return work.worse_at(h) < good_enough ? collapser.look_at_needle(h) : std::nullopt; },
      [&](const Collapse& move, VertexSet& changed) { collapser.make(move, changed); });
}

}  // namespace seesaw
