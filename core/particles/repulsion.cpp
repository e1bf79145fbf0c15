#include "core/particles/repulsion.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "core/base/check.h"
#include "core/base/parallel.h"
#include "core/particles/neighbors.h"
#include "core/particles/same_sheet.h"

namespace seesaw {
namespace {

// What one floater collects.
struct Sum {
  Point<3> push = Point<3>::Zero();
  double own = 0, others = 0, moment = 0, turn = 0, allowed = 1;
};

// What of the formulas belongs to one floater alone, computed once and not for every pair.
struct Widths {
  Values squares, exponents;  // (sigma / t)^2 and -1 / (2 (sigma / t)^2)

  explicit Widths(const Crowd& crowd) : squares(crowd.radii.array().square()) {
    if (crowd.scales.size() > 0) squares.array() /= crowd.scales.array().square();
    exponents = -0.5 * squares.cwiseInverse();
  }
};

void add_pair(const Crowd& crowd, const Widths& widths, const RepulsionOptions& options, Index i, Index j,
              double squared, Sum& sum) {
  const Point<3> r = crowd.positions.col(i) - crowd.positions.col(j);
  const double weight = same_sheet(r, crowd.normals.col(i), crowd.normals.col(j));
  if (weight == 0) return;
  double stretched = squared, factor = 1, moment = 1;
  if (crowd.scales.size() > 0) {
    const double ti = crowd.scales[i], tj = crowd.scales[j], stretch = 2 / (ti + tj);
    stretched *= stretch * stretch;
    factor = stretch * std::sqrt(ti * tj);  // t_i sqrt(t_j / t_i)
    moment = ti * ti;
    sum.allowed = std::min(sum.allowed, tj + options.grading * std::sqrt(squared));
  }
  constexpr double last = repulsion_reach * repulsion_reach;
  const double si = widths.squares[i], sj = widths.squares[j], scale = weight * options.amplitude;
  const double mine = stretched <= last * si ? scale * std::exp(stretched * widths.exponents[i]) : 0.0;
  const double theirs =
      options.mutual && stretched <= last * sj ? scale * std::exp(stretched * widths.exponents[j]) : 0.0;
  sum.push += factor * (mine - 2 * si * widths.exponents[j] * theirs) * r;
  sum.own += mine;
  sum.others += theirs;
  sum.moment += stretched * moment * mine;
  if (squared > 0)
    sum.turn += (mine + theirs) * (crowd.normals.col(i) - crowd.normals.col(j)).squaredNorm() / squared;
}

PairSums room_for(Index n) {
  return {Points<3>::Zero(3, n), Values::Zero(n), Values::Zero(n),
          Values::Zero(n),       Values::Zero(n), Values::Ones(n)};
}

void write(const Crowd& crowd, Index i, const Sum& sum, PairSums& sums) {
  const double radius = crowd.radii[i], all = sum.own + sum.others;
  sums.push.col(i) = sum.push;
  sums.energy[i] = all;
  sums.own[i] = sum.own;
  sums.allowed[i] = sum.allowed;
  sums.own_slope[i] = sum.moment / (radius * radius * radius);
  sums.curvature[i] = all > 0 ? std::sqrt(2 * sum.turn / all) : 0.0;
}

void check(const Crowd& crowd) {
  SEESAW_CHECK_EQ(crowd.positions.cols(), crowd.normals.cols());
  SEESAW_CHECK_EQ(crowd.positions.cols(), crowd.radii.size());
  if (crowd.scales.size() > 0) SEESAW_CHECK_EQ(crowd.scales.size(), crowd.radii.size());
}

// One leaf's candidates, coordinate by coordinate, so that distances are computed several at a time.
struct Table {
  std::vector<double> x, y, z, reach, squared;
  std::vector<std::size_t> found;

  void fill(const Crowd& crowd, std::span<const int> candidates) {
    for (std::vector<double>* column : {&x, &y, &z, &reach, &squared}) column->resize(candidates.size());
    found.resize(candidates.size());
    for (std::size_t k = 0; k < candidates.size(); ++k) {
      const Index j = candidates[k];
      x[k] = crowd.positions(0, j), y[k] = crowd.positions(1, j), z[k] = crowd.positions(2, j);
      reach[k] = repulsion_reach * repulsion_reach * crowd.radii[j] * crowd.radii[j];
    }
  }
  // squared[k] = |p - candidate k|^2.
  void measure(const Point<3>& p) {
    const double px = p[0], py = p[1], pz = p[2];
    double* const out = squared.data();
    const double *const xs = x.data(), *const ys = y.data(), *const zs = z.data();
    for (std::size_t k = 0; k < squared.size(); ++k) {
      const double dx = px - xs[k], dy = py - ys[k], dz = pz - zs[k];
      out[k] = dx * dx + dy * dy + dz * dz;
    }
  }
  // Those whose squared distance is at most their own squared reach, or `most`. No branch: a processor could
  // only guess it.
  std::span<const std::size_t> within(double most) {
    std::size_t count = 0;
    for (std::size_t k = 0; k < squared.size(); ++k) {
      found[count] = k;
      count += squared[k] <= std::max(most, reach[k]);
    }
    return {found.data(), count};
  }
};

}  // namespace

PairSums repulsion(const Crowd& crowd, const RepulsionOptions& options) {
  check(crowd);
  PairSums sums = room_for(crowd.radii.size());
  const Widths widths(crowd);
  const Neighbors neighbors(crowd.positions, repulsion_reach * crowd.radii);
  neighbors.for_each_leaf([&](std::span<const int> members, std::span<const int> candidates) {
    thread_local Table table;
    table.fill(crowd, candidates);
    for (const int i : members) {
      table.measure(crowd.positions.col(i));
      const double reach = repulsion_reach * repulsion_reach * crowd.radii[i] * crowd.radii[i];
      Sum sum;
      for (const std::size_t k : table.within(reach))
        if (candidates[k] != i) add_pair(crowd, widths, options, i, candidates[k], table.squared[k], sum);
      write(crowd, i, sum, sums);
    }
  });
  return sums;
}

PairSums repulsion_of_all_pairs(const Crowd& crowd, const RepulsionOptions& options) {
  check(crowd);
  const Index n = crowd.radii.size();
  PairSums sums = room_for(n);
  const Widths widths(crowd);
  parallel_blocks(n, 16, [&](Index begin, Index end) {
    for (Index i = begin; i < end; ++i) {
      Sum sum;
      for (Index j = 0; j < n; ++j) {
        const double squared = (crowd.positions.col(i) - crowd.positions.col(j)).squaredNorm();
        const double reach = repulsion_reach * std::max(crowd.radii[i], crowd.radii[j]);
        if (j != i && squared <= reach * reach) add_pair(crowd, widths, options, i, j, squared, sum);
      }
      write(crowd, i, sum, sums);
    }
  });
  return sums;
}

}  // namespace seesaw
