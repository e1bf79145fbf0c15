#include "core/particles/integrals.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "core/base/parallel.h"
#include "core/particles/neighbors.h"
#include "core/particles/same_sheet.h"

namespace seesaw {
namespace {

// The width of the Gaussian in spacings, and how far it is followed in widths: there it is 3e-4, and the
// missing rest of its integral as much.
constexpr double spacings_wide = 0.75, widths_reached = 4.0;

}  // namespace

Values area_shares(const Crowd& crowd) {
  const Index n = crowd.radii.size();
  SEESAW_CHECK_EQ(crowd.positions.cols(), n);
  SEESAW_CHECK_EQ(crowd.normals.cols(), n);
  // At rest neighbors are 1.9 radii apart. Radii are smoother from floater to floater than distances are.
  const Values width = 1.9 * spacings_wide * crowd.radii;
  const double whole = 2 * std::numbers::pi * (1 - std::exp(-0.5 * widths_reached * widths_reached));
  Values shares(n);
  Neighbors(crowd.positions, widths_reached * width)
      .for_each_leaf([&](std::span<const int> members, std::span<const int> candidates) {
        for (const int i : members) {
          const Point<3> at = crowd.positions.col(i), normal = crowd.normals.col(i);
          double sum = 0, weights = 0, turn = 0, bend = 0;
          for (const int j : candidates) {
            const Point<3> r = at - crowd.positions.col(j);
            const double squared = r.squaredNorm(), square = width[j] * width[j];
            if (squared > widths_reached * widths_reached * square) continue;
            const Point<3> turned = normal - crowd.normals.col(j);
            const double weight = (i == j ? 1.0 : same_sheet(r, normal, crowd.normals.col(j))) *
                                  std::exp(-0.5 * squared / square);
            sum += weight / square;
            if (!(squared > 0)) continue;
            weights += weight;
            turn += weight * turned.squaredNorm() / squared;
            bend += weight * turned.dot(r) / squared;
          }
          // Averaged over directions, |n_i - n_j|^2 / |r|^2 is half of k1^2 + k2^2, and (n_i - n_j) . r /
          // |r|^2 half of k1 + k2.
          const double squares = weights > 0 ? 2 * turn / weights : 0,
                       both = weights > 0 ? 2 * bend / weights : 0;
          // The correction is a first term only; where it is not small it must not run away.
          const double excess = width[i] * width[i] * std::max(0.0, 2 * squares - both * both) / 8;
          shares[i] = whole / sum * (1 + excess / (1 + 2 * excess));
        }
      });
  return shares;
}

SurfaceIntegrals integrals(const Crowd& crowd) {
  if (crowd.radii.size() == 0) return {};
  const Values shares = area_shares(crowd);
  const Point<3> middle = crowd.positions.rowwise().mean();
  SurfaceIntegrals result = {shares.sum(), 0};
  for (Index i = 0; i < shares.size(); ++i)
    result.volume += shares[i] * (crowd.positions.col(i) - middle).dot(crowd.normals.col(i)) / 3;
  return result;
}

}  // namespace seesaw
