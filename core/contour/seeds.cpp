#include "core/contour/seeds.h"

#include <algorithm>
#include <cmath>

#include "core/contour/place.h"
#include "core/contour/trial.h"

namespace seesaw {
namespace {

// Seeds this near the zero set, relative to the extent, are taken as they are.
constexpr double at_once = 1e-9;

// Walks along the curve from leaf `start` to the first crossing at least `away` from the seed; `crossing` is
// -1 when the curve meets the box before. False when there is none: the curve closes or crawls near the seed.
bool walk(const Crossings& curve, const Seed& seed, int start, bool forward, double away, int& crossing) {
  int t = start;
  for (int step = 0; step < 24; ++step) {
    const Passage passage = curve.passage(t);
    crossing = forward ? passage.to : passage.from;
    if ((curve[crossing].position - seed.at).norm() >= away) return true;
    t = forward ? curve.after(t) : curve.before(t);
    if (t < 0) {
      crossing = -1;
      return true;
    }
    if (t == start) return false;
  }
  return false;
}

}  // namespace

double smallest_triangle(const Lattice& lattice) {
  return std::max(0x1p-31 * lattice.extent, 64 * lattice.grain);
}

std::vector<Seed> make_seeds(Crossings& curve, const PointsRef<2>& points) {
  const Lattice& lattice = curve.mesh().lattice();
  Values f;
  Points<2> gradients;
  Points<2> at = points;
  std::vector<Seed> seeds(static_cast<std::size_t>(at.cols()));
  std::vector<Index> moving;
  for (Index i = 0; i < at.cols(); ++i) {
    Seed& seed = seeds[static_cast<std::size_t>(i)];
    seed.at = at.col(i);
    seed.gradient.setZero();
    if (!seed.at.allFinite() || !lattice.box.contains(seed.at))
      seed.state = Seed::State::outside_box;
    else
      moving.push_back(i);
  }
  // What counts as zero where there is no gradient to turn a value into a distance.
  double largest = 0;
  for (const double value : lattice.values)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  for (int step = 0; step < 12 && !moving.empty(); ++step) {
    at.resize(2, static_cast<Index>(moving.size()));
    for (Index k = 0; k < at.cols(); ++k)
      at.col(k) = seeds[static_cast<std::size_t>(moving[static_cast<std::size_t>(k)])].at;
    curve.sampler().evaluate(at, f, gradients);
    std::size_t kept = 0;
    for (Index k = 0; k < at.cols(); ++k) {
      const Index i = moving[static_cast<std::size_t>(k)];
      Seed& seed = seeds[static_cast<std::size_t>(i)];
      seed.gradient = gradients.col(k);
      const double squared = seed.gradient.squaredNorm();
      // Once moved, a seed goes as near as any vertex, unless rounding in f forbids.
      const double reach =
          step == 0 || step == 11 ? at_once * lattice.extent + lattice.grain : curve.tolerance();
      const bool near =
          squared > 0 ? std::abs(f[k]) <= std::sqrt(squared) * reach : std::abs(f[k]) <= 1e-12 * largest;
      if (near) continue;
      seed.at -= f[k] / squared * seed.gradient;
      const bool lost_its_way = !(squared > 0) || !seed.at.allFinite() || !lattice.box.contains(seed.at) ||
                                (seed.at - points.col(i)).norm() > 2 * lattice.cell || step == 11;
      if (lost_its_way)
        seed.state = Seed::State::off_curve;
      else
        moving[kept++] = i;
    }
    moving.resize(kept);
  }
  for (Seed& seed : seeds) seed.uv = lattice.lattice_from_scene(seed.at);
  return seeds;
}

void check_seeds(Crossings& curve, std::vector<Seed>& seeds, std::vector<int>& leaves) {
  Triangulation& mesh = curve.mesh();
  // Above the limit of size the seed's leaves are to be bisected; at it, what passes is taken.
  const auto refuse = [&](Seed& seed) {
    const Place place = place_of(mesh, seed);
    if (place.size <= smallest_triangle(mesh.lattice())) {
      seed.triangle = nearest_passage(curve, seed, last_reach * place.size);
      seed.state = seed.triangle >= 0 ? Seed::State::satisfied : Seed::State::exhausted;
      return;
    }
    leaves.insert(leaves.end(), place.leaves.begin(), place.leaves.end());
  };
  std::vector<Trial> trials;
  for (Seed& seed : seeds) {
    if (seed.state == Seed::State::satisfied && !mesh.is_leaf(seed.triangle))
      seed.state = Seed::State::pending;
    if (seed.state != Seed::State::pending) continue;
    const Place place = place_of(mesh, seed);
    const int t = seed.gradient.isZero(0) ? -1 : nearest_passage(curve, seed, 0.25 * place.size);
    Trial trial{&seed, t, -1, -1};
    const double away = 0.1 * place.size;
    if (t >= 0 && walk(curve, seed, t, false, away, trial.before) &&
        walk(curve, seed, t, true, away, trial.after) && (trial.before >= 0 || trial.after >= 0))
      trials.push_back(trial);
    else
      refuse(seed);
  }
  const std::vector<bool> proved = prove(curve, trials);
  for (std::size_t k = 0; k < trials.size(); ++k) {
    if (!proved[k]) {
      refuse(*trials[k].seed);
      continue;
    }
    trials[k].seed->state = Seed::State::satisfied;
    trials[k].seed->triangle = trials[k].triangle;
  }
}

void attach_seeds(Crossings& curve, std::vector<Seed>& seeds) {
  for (Seed& seed : seeds) {
    if (seed.state == Seed::State::satisfied && curve.mesh().is_leaf(seed.triangle)) continue;
    if (seed.state == Seed::State::off_curve || seed.state == Seed::State::outside_box) continue;
    const Place place = place_of(curve.mesh(), seed);
    seed.triangle = nearest_passage(curve, seed, 0.25 * place.size);
    seed.state = seed.triangle >= 0 ? Seed::State::satisfied : Seed::State::lost;
  }
}

}  // namespace seesaw
