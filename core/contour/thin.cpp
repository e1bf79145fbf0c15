#include "core/contour/thin.h"

#include <algorithm>
#include <cmath>

namespace seesaw {
namespace {

// A vertex nearer than this to the one before it, relative to its edge, crowds it.
constexpr double crowded = 0.02;
// How far a vertex in a straight run may be from the chord, relative to its edge.
constexpr double straight = 0.01;

bool on_side(const Point<2>& p, const Box<2>& box) {
  return (p.array() == box.min().array()).any() || (p.array() == box.max().array()).any();
}

// Without nodes that coincide with a neighbor and, if `tidy`, those that crowd one.
std::vector<Node> spaced(const std::vector<Node>& nodes, bool closed, const ThinLimits& limits, bool tidy) {
  std::vector<Node> out;
  const auto too_near = [&](const Node& loose, const Node& other) {
    const double reach =
        tidy && !loose.keep ? std::max(limits.coincident, crowded * loose.edge_length) : limits.coincident;
    return (loose.at - other.at).norm() <= reach;
  };
  for (Node node : nodes) {
    if (tidy && node.shadowed && !node.keep) continue;
    while (!out.empty() && !out.back().keep && too_near(out.back(), node) && (node.keep || out.size() > 1))
      out.pop_back();
    if (!out.empty() && too_near(node, out.back())) {
      // A seed exactly on the box and the curve's end there are one vertex: the end, at the seed.
      if (out.back().on_box && node.keep && on_side(node.at, limits.box)) out.back().at = node.at;
      if (!node.on_box) continue;
      if (on_side(out.back().at, limits.box)) node.at = out.back().at;
      out.pop_back();
    }
    out.push_back(node);
  }
  if (closed) {
    while (out.size() > 1 && !out.back().keep && too_near(out.back(), out.front())) out.pop_back();
    while (out.size() > 1 && too_near(out.front(), out.back())) out.erase(out.begin());
  }
  return out;
}

// Without the inner nodes of straight runs. From each node that stays, the next is the farthest whose
// direction lies within the cone that every node between allows (Reumann and Witkam's idea, as a funnel).
std::vector<Node> straightened(const std::vector<Node>& nodes, const ThinLimits& limits) {
  std::vector<Node> out;
  std::size_t from = 0;
  while (from < nodes.size()) {
    const Node& a = nodes[from];
    out.push_back(a);
    std::size_t to = from + 1;
    Point<2> low = Point<2>::Zero(), high = Point<2>::Zero();
    double reached = 0;
    for (std::size_t k = from + 1; k + 1 < nodes.size(); ++k) {
      // May node k be left out, and the chord lead to the one after it?
      const Node &skipped = nodes[k], &end = nodes[k + 1];
      const Point<2> to_skipped = skipped.at - a.at, to_end = end.at - a.at;
      const double distance = to_skipped.norm(), slack = straight * skipped.edge_length;
      if (skipped.keep || skipped.edge_length > 0.5 * limits.longest || distance < reached) break;
      if (to_end.norm() > limits.longest) break;
      if (end.gradient.dot(a.gradient) <= limits.turn_cosine * end.gradient.norm() * a.gradient.norm()) break;
      reached = distance;
      if (distance > slack) {
        const double sine = slack / distance, cosine = std::sqrt(1 - sine * sine);
        const Point<2> right(cosine * to_skipped.x() + sine * to_skipped.y(),
                             cosine * to_skipped.y() - sine * to_skipped.x());
        const Point<2> left(cosine * to_skipped.x() - sine * to_skipped.y(),
                            cosine * to_skipped.y() + sine * to_skipped.x());
        if (low.isZero(0) || cross(low, right) > 0) low = right;
        if (high.isZero(0) || cross(high, left) < 0) high = left;
      }
      if (!low.isZero(0) && (cross(low, to_end) < 0 || cross(high, to_end) > 0 || low.dot(to_end) <= 0))
        break;
      to = k + 1;
    }
    from = to;
  }
  return out;
}

}  // namespace

std::vector<Node> thinned(const std::vector<Node>& nodes, bool closed, const ThinLimits& limits) {
  const std::size_t least = closed ? 3 : 2;
  std::vector<Node> tidy = straightened(spaced(nodes, closed, limits, true), limits);
  return tidy.size() >= least ? tidy : spaced(nodes, closed, limits, false);
}

}  // namespace seesaw
