// Moves of edges: looked for on all cores, made one after the other.
//
// Before it: working_mesh.h.  After it: collapse.h and flip.h, which say what the moves are.
//
// Whether a move does good is the costly question, and it only reads the mesh. So all edges are asked at
// once, and the moves that are found are then made, the most urgent first. One in the neighborhood of a move
// just made is looked at again before: what was found need not hold any more. The order is fixed, hence the
// result does not depend on the number of threads.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "core/base/parallel.h"
#include "core/polygonize/working_mesh.h"

namespace seesaw {

/// Whether a corner of the faces at the edge of h is in `set`.
inline bool is_near(const VertexSet& set, const HalfEdges& net, int h) {
  const int t = net.twin(h);
  return set.has(net.origin(h)) || set.has(net.target(h)) || set.has(net.origin(HalfEdges::previous(h))) ||
         (t >= 0 && set.has(net.origin(HalfEdges::previous(t))));
}

/// The moves that `look(h)`, an optional<Move>, finds for the edges, in the order of their half-edges h, one
/// for each edge. `look` runs in many threads.
template <class Move, class Look>
std::vector<Move> find_moves(const HalfEdges& net, const Look& look) {
  constexpr Index block = 3 * 1024;
  std::vector<std::vector<Move>> found(static_cast<std::size_t>((net.size() + block - 1) / block));
  parallel_blocks(net.size(), block, [&](Index begin, Index end) {
    for (int h = static_cast<int>(begin); h < static_cast<int>(end); ++h) {
      if (!net.is_alive(h) || (net.twin(h) >= 0 && net.twin(h) < h)) continue;
      if (const std::optional<Move> move = look(h))
        found[static_cast<std::size_t>(h / block)].push_back(*move);
    }
  });
  std::vector<Move> moves;
  for (const std::vector<Move>& its : found) moves.insert(moves.end(), its.begin(), its.end());
  return moves;
}

/// Looks at all edges and makes the moves found; returns the vertices whose faces are no longer what they
/// were. A Move knows its half-edge `edge` and which of two is more urgent, by <. `make(move, changed)` makes
/// it and adds those vertices. `look` may read no faces but those that share a vertex with the two at the
/// edge.
template <class Move, class Look, class Make>
VertexSet make_moves(const HalfEdges& net, const Look& look, const Make& make) {
  std::vector<Move> moves = find_moves<Move>(net, look);
  std::sort(moves.begin(), moves.end());
  VertexSet changed(net.vertices(), false);
  for (const Move& found : moves) {
    if (!net.is_alive(found.edge)) continue;
    const std::optional<Move> move = is_near(changed, net, found.edge) ? look(found.edge) : found;
    if (move) make(*move, changed);
  }
  return changed;
}

}  // namespace seesaw
