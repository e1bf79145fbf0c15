#include "core/polygonize/flip.h"

#include "core/polygonize/moves.h"
#include "core/polygonize/triangle_quality.h"

namespace seesaw {

namespace {

// Cosine of the largest fold across an edge that flips, before and after.
constexpr double largest_fold = 0.8;
// What a flip must gain: a factor, and a little more, so that rounding alone never flips.
constexpr double least_factor = 1.1, least_gain = 1e-4;

struct Flip {
  double quality;  // of the worse triangle, as it is
  int edge;

  bool operator<(const Flip& other) const {
    return quality < other.quality || (quality == other.quality && edge < other.edge);
  }
};

std::optional<Flip> look_at(const WorkingMesh& work, int h) {
  const HalfEdges& net = work.net;
  const int t = net.twin(h);
  if (t < 0) return {};
  const Point<3> a = work.at(net.origin(h)), b = work.at(net.target(h)),
                 c = work.at(net.origin(HalfEdges::previous(h))),
                 d = work.at(net.origin(HalfEdges::previous(t)));
  const Point<3> n1 = normal_of(a, b, c), n2 = normal_of(b, a, d);
  if (!within(n1, n2, largest_fold)) return {};
  const double before = work.worse_at(h);
  const Point<3> m1 = normal_of(d, c, a), m2 = normal_of(c, d, b);
  const double after = std::min(quality_of(d, c, a, m1), quality_of(c, d, b, m2));
  if (after < least_factor * before || after < before + least_gain) return {};
  const Point<3> n = n1 + n2;
  if (!within(m1, m2, largest_fold) || !within(m1, n, largest_fold) || !within(m2, n, largest_fold))
    return {};
  return net.can_flip(h) ? std::optional<Flip>({before, h}) : std::nullopt;
}

}  // namespace

void flip_edges(WorkingMesh& work) {
  make_moves<Flip>(
      work.net, [&](int h) { return work.worse_at(h) < good_as_it_is ? look_at(work, h) : std::nullopt; },
      [&](const Flip& move, VertexSet& changed) {
        const int h = move.edge, t = work.net.twin(h);
        work.net.flip(h);
        for (const int g : {h, t}) {
          work.renew(g / 3);
          changed.add(work.net.origin(g));
          changed.add(work.net.origin(HalfEdges::previous(g)));
        }
      });
}

}  // namespace seesaw
