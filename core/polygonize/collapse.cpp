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

// The worst quality of the triangles around, before and after.
struct Worst {
  double before = 1, after = 1;
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
  bool look_around(int v, const Point<3>& to, int h, Worst& worst) const;
  std::optional<Worst> worst_around(int h, const Point<3>& to) const;

  WorkingMesh& work_;
  HalfEdges& net_;
};

// A vertex on a face of the range may go only where it stays on that face.
bool Collapser::may_become(int v, int other) const {
  const std::vector<std::uint8_t>& planes = work_.mesh.on_range;
  return (planes[static_cast<std::size_t>(v)] & ~planes[static_cast<std::size_t>(other)]) == 0;
}

// The triangles around v, but those at h, when v goes `to`; false if one turns over.
bool Collapser::look_around(int v, const Point<3>& to, int h, Worst& worst) const {
  const int dying = h / 3, dying_too = net_.twin(h) >= 0 ? net_.twin(h) / 3 : -1;
  const Point<3> from = work_.at(v);
  return !net_.any_leaving(v, [&](int g) {
    if (g / 3 == dying || g / 3 == dying_too) return false;
    const Point<3> b = work_.at(net_.target(g)), c = work_.at(net_.origin(HalfEdges::previous(g)));
    const Point<3> before = normal_of(from, b, c), after = normal_of(to, b, c);
    worst.before = std::min(worst.before, quality_of(from, b, c, before));
    worst.after = std::min(worst.after, quality_of(to, b, c, after));
    return !before.isZero(0) && !within(before, after, largest_turn);
  });
}

// When the edge of h collapses and its ends go `to`; nothing if a triangle turns over.
std::optional<Worst> Collapser::worst_around(int h, const Point<3>& to) const {
  const int a = net_.origin(h), b = net_.target(h);
  Worst worst;
  if (!look_around(a, to, h, worst) || !look_around(b, to, h, worst)) return {};
  for (const int dying : {h, net_.twin(h)})
    if (dying >= 0)
      worst.before = std::min(worst.before, quality_of(work_.at(a), work_.at(b),
                                                       work_.at(net_.origin(HalfEdges::previous(dying)))));
  return worst;
}

std::optional<Collapse> Collapser::look_into(int edge, int h) const {
  const int a = net_.origin(h), b = net_.target(h);
  const bool swap = net_.twin(h) < 0 && !may_become(b, a);  // then b is who stays, under the name of a
  if (!(swap ? may_become(a, b) : may_become(b, a)) || !net_.can_collapse(h)) return {};
  const Point<3> p = work_.at(a), q = work_.at(b);
  const Point<3> to = swap ? q : work_.is_fixed(a) ? p : Point<3>(0.5 * (p + q));
  const std::optional<Worst> worst = worst_around(h, to);
  if (!worst || worst->after < std::min(worst->before, good_for_short)) return {};
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
  double best_quality = 0;
  for (const int g : {h, net_.twin(h)}) {
    if (g < 0) continue;
    const int a = net_.origin(g), b = net_.target(g);
    if (!may_become(b, a) || !net_.can_collapse(g)) continue;
    for (const double way : {0.0, 0.5}) {
      if (way > 0 && work_.is_fixed(a)) continue;
      const Point<3> to = work_.at(a) + way * (work_.at(b) - work_.at(a));
      const std::optional<Worst> worst = worst_around(g, to);
      if (!worst || worst->after <= std::max(best_quality, gain_for_needle * worst->before)) continue;
      best_quality = worst->after;
      best = Collapse{worst->before, h, g, false, to};
    }
  }
  return best;
}

void Collapser::make(const Collapse& move, VertexSet& changed) {
  const int a = net_.origin(move.h), b = net_.target(move.h);
  net_.collapse(move.h);
  if (move.swap) work_.mesh.copy_vertex(b, a);
  work_.mesh.positions.col(a) = move.to;
  changed.add(a);
  net_.for_each_leaving(a, [&](int h) {
    changed.add(net_.target(h));
    changed.add(net_.origin(HalfEdges::previous(h)));
  });
}

}  // namespace

void collapse_short_edges(WorkingMesh& work, double length) {
  Collapser collapser(work);
  VertexSet changed(work.mesh.vertices(), true);
  const auto look = [&](int h) {
    return collapser.squared_length(h) <= length * length ? collapser.look_at_short(h) : std::nullopt;
  };
  const auto make = [&](const Collapse& move) { collapser.make(move, changed); };
  // Another look where much has changed; for edges of no length, where anything has.
  const Index few = length == 0 ? 0 : work.net.size() / 3 / 50;
  while (make_moves<Collapse>(work.net, changed, look, make) > few) {
  }
}

VertexSet collapse_needles(WorkingMesh& work) {
  Collapser collapser(work);
  const std::vector<char> needles = work.faces_below(good_enough);
  VertexSet changed(work.mesh.vertices(), true);
  make_moves<Collapse>(
      work.net, changed,
      [&](int h) { return work.is_at(needles, h) ? collapser.look_at_needle(h) : std::nullopt; },
      [&](const Collapse& move) { collapser.make(move, changed); });
  return changed;
}

}  // namespace seesaw
