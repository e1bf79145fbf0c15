#include "core/particles/walk.h"

#include <algorithm>
#include <cmath>

#include "core/particles/adhesion.h"

namespace seesaw {
namespace {

constexpr double longest_piece = 0.5;  // of the grain
constexpr double checked_piece = 0.2;  // of the grain: longer ones are looked at half-way, too
constexpr double least_facing = -0.6;  // n . n' across a piece
constexpr int shortest = 2;            // halvings of a piece before it is given up

struct Walker {
  Index index = 0;
  Point<3> rest = Point<3>::Zero();   // of the way
  Point<3> piece = Point<3>::Zero();  // under trial
  int halvings = 0;
  bool still = false;  // no more way: only the surface is looked for
};

Point<3> piece_of(const Walker& walker, double grain) {
  if (walker.still) return Point<3>::Zero();
  const double length = walker.rest.norm();
  const double most = longest_piece * grain / (1 << walker.halvings);
  return length > most ? Point<3>(most / length * walker.rest) : walker.rest;
}

// For pieces that end on the surface: is it near half-way, too, and does it look the same way?
std::vector<char> connected(const Field<3>& field, const Points<3>& from, const Points<3>& to,
                            const std::vector<Index>& asked) {
  std::vector<char> result(static_cast<std::size_t>(from.cols()), 1);
  if (asked.empty()) return result;
  const Points<3> middles = 0.5 * (from + to)(Eigen::all, asked);
  const Contact contact = touch(field, middles);
  for (std::size_t k = 0; k < asked.size(); ++k) {
    const Index column = static_cast<Index>(k);
    const double length = (to.col(asked[k]) - from.col(asked[k])).norm();
    result[static_cast<std::size_t>(asked[k])] =
        std::abs(contact.values[column]) <= 0.5 * length * contact.gradients.col(column).norm();
  }
  return result;
}

}  // namespace

Walked walk(const Field<3>& field, const Ways& ways) {
  const Index n = ways.from.cols();
  Walked result = {ways.from, ways.normals, std::vector<char>(static_cast<std::size_t>(n), 0)};
  std::vector<Walker> walkers;
  for (Index i = 0; i < n; ++i) {
    const Point<3> by = ways.by.col(i);
    const double length = by.norm(), most = longest_way * ways.grain[i];
    Walker walker;
    walker.index = i;
    walker.rest = length > most ? Point<3>(most / length * by) : by;
    walker.still = !(length > 0);
    walkers.push_back(walker);
  }
  // Every round a piece is walked or a trial is given up; the bound only ends what should not happen.
  for (int round = 0; round < 64 && !walkers.empty(); ++round) {
    const Index count = std::ssize(walkers);
    Points<3> from(3, count), to(3, count);
    Values leashes(count), tolerances(count);
    for (Index k = 0; k < count; ++k) {
      Walker& walker = walkers[static_cast<std::size_t>(k)];
      const Index i = walker.index;
      walker.piece = piece_of(walker, ways.grain[i]);
      from.col(k) = result.positions.col(i);
      to.col(k) = from.col(k) + walker.piece;
      // Once it has been found, the surface is where the floater is.
      leashes[k] =
          0.75 * walker.piece.norm() + (result.on[static_cast<std::size_t>(i)] ? 0.0 : ways.leashes[i]);
      tolerances[k] = walk_tolerance * ways.grain[i];
      leashes[k] = std::max(leashes[k], tolerances[k]);
    }
    const PutOn put = put_on(field, to, leashes, tolerances);
    std::vector<Index> asked;
    for (Index k = 0; k < count; ++k)
      if (put.on[static_cast<std::size_t>(k)] &&
          walkers[static_cast<std::size_t>(k)].piece.norm() >
              checked_piece * ways.grain[walkers[static_cast<std::size_t>(k)].index])
        asked.push_back(k);
    const std::vector<char> same = connected(field, from, put.positions, asked);

    std::vector<Walker> next;
    for (Index k = 0; k < count; ++k) {
      Walker walker = walkers[static_cast<std::size_t>(k)];
      const Index i = walker.index;
      const std::size_t row = static_cast<std::size_t>(k);
      char& on = result.on[static_cast<std::size_t>(i)];
      const Point<3> normal = -put.gradients.col(k).normalized();
      if (put.on[row] && same[row] && normal.dot(result.normals.col(i)) > least_facing) {
        on = 1;
        result.positions.col(i) = put.positions.col(k);
        result.normals.col(i) = normal;
        const double length = walker.rest.norm() - walker.piece.norm();
        const Point<3> rest = walker.rest - normal.dot(walker.rest) * normal;
        walker.halvings = 0;
        if (walker.still || !(length > 1e-9 * ways.grain[i]) || !(rest.norm() > 0)) continue;
        walker.rest = length * rest.normalized();
        next.push_back(walker);
      } else if (!walker.still && walker.halvings < shortest) {
        ++walker.halvings;
        next.push_back(walker);
      } else if (!walker.still && !on) {
        walker.still = true;
        next.push_back(walker);
      }
    }
    walkers = std::move(next);
  }
  return result;
}

}  // namespace seesaw
