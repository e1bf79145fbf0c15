#include "core/contour/trace.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/tolerances.h"
#include "core/contour/thin.h"

namespace seesaw {
namespace {

// A run of nodes along the curve. An end that is not on the box is where a dropped passage was cut out; there
// the node is a zero corner, and another piece goes on from it.
struct Piece {
  std::vector<Node> nodes;
  bool starts_on_box = false, ends_on_box = false, closed = false;
};

class Tracer {
 public:
  Tracer(const Crossings& curve, const std::vector<Seed>& seeds)
      : curve_(curve), mesh_(curve.mesh()), seeds_(seeds) {
    for (std::size_t k = 0; k < seeds.size(); ++k)
      if (seeds[k].triangle >= 0) attached_.emplace_back(seeds[k].triangle, k);
    std::sort(attached_.begin(), attached_.end());
    done_.assign(static_cast<std::size_t>(mesh_.size()), false);
  }

  std::vector<Piece> pieces() {
    // Curves that come in from the box first, whole; what is left is closed.
    for (const bool from_box : {true, false})
      for (int t = 0; t < mesh_.size(); ++t)
        if (!done_[static_cast<std::size_t>(t)] && mesh_.is_leaf(t) && mesh_.is_mixed(t) &&
            (!from_box || curve_.before(t) < 0))
          walk(t, from_box);
    return std::move(pieces_);
  }

 private:
  // Between two zero corners with f < 0 on both sides, the curve would run up one side and down the other of
  // nothing.
  bool is_whisker(int t, const Passage& passage) const {
    if (curve_[passage.from].corner < 0 || curve_[passage.to].corner < 0) return false;
    const int k = 3 - passage.entry_edge - passage.exit_edge;  // the edge that joins the two
    const int other = mesh_.triangle(t).neighbor[static_cast<std::size_t>(k)];
    if (other < 0) return false;
    const int apex = mesh_.triangle(other).vertex[static_cast<std::size_t>(mesh_.edge_toward(other, t))];
    return !mesh_.inside(apex);
  }

  Node node(int crossing, bool on_box) const {
    const Crossing& c = curve_[crossing];
    return {c.position, c.gradient, c.edge_length, c.corner, on_box, on_box};
  }

  void walk(int start, bool from_box) {
    // A loop that will be cut starts at a cut, so that every piece of it is whole.
    if (!from_box) {
      int t = start;
      do {
        if (is_whisker(t, curve_.passage(t))) {
          start = t;
          break;
        }
        t = curve_.after(t);
      } while (t != start);
    }
    Piece piece;
    piece.starts_on_box = from_box;
    bool cut = false;
    int t = start;
    do {
      done_[static_cast<std::size_t>(t)] = true;
      const Passage passage = curve_.passage(t);
      const bool first = t == start && from_box, last = curve_.after(t) < 0;
      if (curve_.is_point(passage)) {
        // Where the curve enters or leaves the box exactly through a zero corner.
        if (first) piece.nodes.push_back(node(passage.from, true));
        if (last && !piece.nodes.empty()) piece.nodes.back().keep = piece.nodes.back().on_box = true;
      } else if (is_whisker(t, passage)) {
        finish(piece, false);
        cut = true;
      } else {
        if (piece.nodes.empty()) piece.nodes.push_back(node(passage.from, first));
        add_passage(piece, t, passage, last);
      }
      t = curve_.after(t);
    } while (t >= 0 && t != start);
    piece.closed = t == start && !cut;
    finish(piece, t < 0);
  }

  void add_passage(Piece& piece, int t, const Passage& passage, bool last) const {
    const Point<2> from = curve_[passage.from].position, along = curve_[passage.to].position - from;
    std::vector<std::pair<double, std::size_t>> order;
    for (auto at = std::lower_bound(attached_.begin(), attached_.end(), std::pair<int, std::size_t>(t, 0));
         at != attached_.end() && at->first == t; ++at)
      order.emplace_back((seeds_[at->second].at - from).dot(along) / along.squaredNorm(), at->second);
    std::sort(order.begin(), order.end());
    Node to = node(passage.to, last);
    for (const auto& [where, k] : order) {
      if (where <= 0) piece.nodes.back().shadowed = true;
      if (where >= 1) to.shadowed = true;
      if (seeds_[k].given)
        piece.nodes.push_back({seeds_[k].at, seeds_[k].gradient, to.edge_length, -1, true});
    }
    piece.nodes.push_back(to);
  }

  void finish(Piece& piece, bool on_box) {
    piece.ends_on_box = on_box;
    if (piece.nodes.size() > 1) pieces_.push_back(std::move(piece));
    piece = Piece();
  }

  const Crossings& curve_;
  const Triangulation& mesh_;
  const std::vector<Seed>& seeds_;
  std::vector<std::pair<int, std::size_t>> attached_;
  std::vector<bool> done_;
  std::vector<Piece> pieces_;
};

// Joins pieces at the zero corners where whiskers were cut off. As many pieces start at such a corner as end
// there.
std::vector<Piece> joined(std::vector<Piece> pieces) {
  std::multimap<int, std::size_t> starts;
  for (std::size_t k = 0; k < pieces.size(); ++k)
    if (!pieces[k].closed && !pieces[k].starts_on_box) starts.emplace(pieces[k].nodes.front().corner, k);
  if (starts.empty()) return pieces;
  std::vector<bool> used(pieces.size(), false);
  std::vector<Piece> result;
  for (const bool from_box : {true, false})
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      if (used[k] || (from_box && !pieces[k].starts_on_box && !pieces[k].closed)) continue;
      used[k] = true;
      Piece chain = pieces[k];
      while (!chain.closed && !chain.ends_on_box) {
        const int corner = chain.nodes.back().corner;
        const auto [first, last] = starts.equal_range(corner);
        const auto next = std::find_if(first, last, [&](const auto& start) { return !used[start.second]; });
        if (next == last) {
          chain.closed = true;
        } else {
          const Piece& more = pieces[next->second];
          used[next->second] = true;
          chain.nodes.insert(chain.nodes.end(), more.nodes.begin() + 1, more.nodes.end());
          chain.ends_on_box = more.ends_on_box;
        }
      }
      result.push_back(std::move(chain));
    }
  return result;
}

}  // namespace

std::vector<Polyline> trace(const Crossings& curve, const std::vector<Seed>& seeds, double angle_tolerance) {
  const Lattice& lattice = curve.mesh().lattice();
  const ThinLimits limits{std::max(tolerance::on_curve * lattice.extent, lattice.grain), 0.5 * lattice.cell,
                          std::cos(0.25 * angle_tolerance), lattice.box};
  std::vector<Polyline> polylines;
  for (const Piece& piece : joined(Tracer(curve, seeds).pieces())) {
    const std::vector<Node> nodes = thinned(piece.nodes, piece.closed, limits);
    if (nodes.size() < (piece.closed ? 3u : 2u)) continue;
    Polyline polyline;
    polyline.closed = piece.closed;
    polyline.vertices.resize(2, static_cast<Index>(nodes.size()));
    for (std::size_t k = 0; k < nodes.size(); ++k) polyline.vertices.col(static_cast<Index>(k)) = nodes[k].at;
    polylines.push_back(std::move(polyline));
  }
  return polylines;
}

}  // namespace seesaw
