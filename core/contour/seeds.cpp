#include "core/contour/seeds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace seesaw {
namespace {

constexpr double at_once = 1e-9;      // Seeds this near the zero set, relative to the extent, are taken as they are.
constexpr double chord_cosine = 0.978;  // 12 degrees
constexpr double sample_cosine = 0.866;  // 30 degrees
constexpr double size_factor = 3;
// Where the trials look, as fractions of the way from the seed to A or B. The last is 2e-7.
constexpr double first_trial[] = {0.5, 0.125, 0x1p-6};
constexpr double second_trial[] = {0x1p-6, 0x1p-9, 0x1p-12, 0x1p-15, 0x1p-18, 0x1p-22};
// Where a spike is looked for, as fractions of the way from its tip to where it was cut off; and how wide it may be.
constexpr double on_axis[] = {0.7, 0.5, 0.35};
constexpr double beside_axis[] = {0.7, 0.35, 0.1, 0.01, 1e-3};
constexpr double spike_width = 0.2;
// Points beside the chords, this far from the seed (as a fraction of the chord) and off it by `aside` of that. A loop
// through the seed is betrayed by points at 0.6 to 7 times its radius, so factors of 11 leave none out.
constexpr double side_fractions[] = {0.1, 9e-3, 8e-4, 7e-5, 6e-6};
constexpr double aside = 0.3;

Point<2> left_of(const Point<2>& v) { return {-v.y(), v.x()}; }

double cosine(const Point<2>& a, const Point<2>& b) {
  const double norms = a.norm() * b.norm();
  return norms > 0 ? a.dot(b) / norms : 0;
}

double distance_to_segment(const Point<2>& p, const Point<2>& a, const Point<2>& b) {
  const Point<2> along = b - a;
  const double squared = along.squaredNorm();
  const double t = squared > 0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (a + t * along - p).norm();
}

// Length of the leaf's longest side, in scene units.
double size_of(const Triangulation& mesh, int t) {
  const auto [a, b] = mesh.edge(t, 0);
  return (mesh.position(a) - mesh.position(b)).norm();
}

// Rounding in a seed's lattice coordinates.
double uv_grain(const Lattice& lattice) {
  return 4e-16 * std::max(lattice.nx, lattice.ny) + 4 * lattice.grain / lattice.extent * std::max(lattice.nx, lattice.ny);
}

// The leaves a seed lies in (several when on an edge), made if need be, and the longest side of the smallest.
struct Place {
  std::vector<int> leaves;
  double size = std::numeric_limits<double>::infinity();
};

Place place_of(Triangulation& mesh, const Seed& seed) {
  Place place;
  const double grain = uv_grain(mesh.lattice());
  mesh.make_around(seed.uv, grain);
  mesh.leaves_near(seed.uv, grain, place.leaves);
  for (const int t : place.leaves) place.size = std::min(place.size, size_of(mesh, t));
  return place;
}

// The nearest passage within `reach` (scene units) of the seed that has its inside on the seed's side; -1 for none.
int nearest_passage(const Crossings& curve, const Seed& seed, double reach) {
  std::vector<int> leaves;
  curve.mesh().leaves_near(seed.uv, reach / curve.mesh().lattice().cell, leaves);
  int nearest = -1;
  double least = reach;
  for (const int t : leaves) {
    if (!curve.mesh().is_mixed(t)) continue;
    const Passage passage = curve.passage(t);
    if (curve.is_point(passage)) continue;
    const Point<2>&a = curve[passage.from].position, &b = curve[passage.to].position;
    const double distance = distance_to_segment(seed.at, a, b);
    if (distance > least || (distance == least && nearest >= 0)) continue;
    if (!seed.gradient.isZero(0) && left_of(b - a).dot(seed.gradient) <= 0) continue;
    least = distance;
    nearest = t;
  }
  return nearest;
}

// Walks along the curve from leaf `start` to the first crossing at least `away` from the seed; `crossing` is -1 when
// the curve meets the box before. False when there is none: the curve closes or crawls near the seed.
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

// A seed with its two chords: A-s and s-B.
struct Trial {
  Seed* seed;
  int triangle;       // whose passage it is
  int before, after;  // crossings A and B, -1 where the box cuts the curve off
};

enum class Verdict { fits, wrong_size, wrong };

// Judges the chords of each trial by the gradients at `fractions` of them, all in one batch. Sizes are compared with
// the seed's gradient, or, `among_themselves`, with the outermost one of the same chord.
std::vector<Verdict> judge(Crossings& curve, const std::vector<Trial>& trials, std::span<const double> fractions,
                           bool among_themselves) {
  std::vector<Point<2>> samples;
  for (const Trial& trial : trials)
    for (const int end : {trial.before, trial.after})
      if (end >= 0)
        for (const double fraction : fractions)
          samples.push_back(trial.seed->at + fraction * (curve[end].position - trial.seed->at));
  Points<2> at(2, static_cast<Index>(samples.size())), gradients;
  for (Index k = 0; k < at.cols(); ++k) at.col(k) = samples[static_cast<std::size_t>(k)];
  Values f;
  curve.sampler().evaluate(at, f, gradients);

  std::vector<Verdict> verdicts;
  Index first = 0;
  for (const Trial& trial : trials) {
    Verdict verdict = Verdict::fits;
    for (const int end : {trial.before, trial.after}) {
      if (end < 0) continue;
      const Point<2> to_end = curve[end].position - trial.seed->at;
      const Point<2> left = left_of(end == trial.after ? to_end : Point<2>(-to_end));
      if (!curve[end].gradient.isZero(0) && cosine(curve[end].gradient, left) < chord_cosine) verdict = Verdict::wrong;
      if (trial.seed->gradient.dot(left) <= 0) verdict = Verdict::wrong;
      const double size = among_themselves ? gradients.col(first).norm() : trial.seed->gradient.norm();
      for (std::size_t k = 0; k < fractions.size(); ++k, ++first) {
        const Point<2> gradient = gradients.col(first);
        if (cosine(gradient, left) < sample_cosine) verdict = Verdict::wrong;
        const double norm = gradient.norm();
        if (!(norm * size_factor >= size && norm <= size * size_factor) && verdict == Verdict::fits)
          verdict = Verdict::wrong_size;
      }
    }
    verdicts.push_back(verdict);
  }
  return verdicts;
}

// Inside lies left of the chords near the seed, outside right of them: true for a curve that runs along them, and
// wrong beside a loop that only touches them, or between two curves that cross at the seed.
std::vector<bool> sides_fit(Crossings& curve, const std::vector<Trial>& trials) {
  struct Sample {
    std::size_t trial;
    bool inside;
  };
  std::vector<Sample> expected;
  std::vector<Point<2>> samples;
  const Lattice& lattice = curve.mesh().lattice();
  for (std::size_t k = 0; k < trials.size(); ++k)
    for (const int end : {trials[k].before, trials[k].after}) {
      if (end < 0) continue;
      const Point<2> to_end = curve[end].position - trials[k].seed->at;
      const Point<2> left = left_of(end == trials[k].after ? to_end : Point<2>(-to_end));
      for (const double fraction : side_fractions)
        for (const double side : {aside, -aside}) {
          const Point<2> p = trials[k].seed->at + fraction * (to_end + side * left);
          // Beyond the box, or too near for the coordinates' digits, there is nothing to learn.
          if (!lattice.box.contains(p) || aside * fraction * to_end.norm() < 8 * lattice.grain) continue;
          samples.push_back(p);
          expected.push_back({k, side > 0});
        }
    }
  Points<2> at(2, static_cast<Index>(samples.size()));
  for (Index k = 0; k < at.cols(); ++k) at.col(k) = samples[static_cast<std::size_t>(k)];
  Values f;
  curve.sampler().evaluate(at, f);
  std::vector<bool> fit(trials.size(), true);
  for (std::size_t k = 0; k < expected.size(); ++k)
    if (is_inside(f[static_cast<Index>(k)]) != expected[k].inside) fit[expected[k].trial] = false;
  return fit;
}

// Is the seed the tip of a spike that was cut off at leaf t's passage, because it grows thinner than any triangle?
// Then a line from the seed to the passage runs inside the spike, and points well to both sides of it are not.
bool is_tip(Crossings& curve, const Seed& seed, int t) {
  const Passage passage = curve.passage(t);
  const Point<2> axis = 0.5 * (curve[passage.from].position + curve[passage.to].position) - seed.at;
  // The spike is cut where it is about as wide as its triangle; where in that width its axis runs is tried out.
  const Point<2> width = size_of(curve.mesh(), t) * left_of(axis).normalized();
  constexpr Index tries = 17;
  Points<2> at(2, tries * std::ssize(on_axis) + 2 * std::ssize(beside_axis));
  Index n = 0;
  for (const double fraction : on_axis)
    for (Index k = 0; k < tries; ++k)
      at.col(n++) = seed.at + fraction * (axis + 0.25 * static_cast<double>(k - tries / 2) * width);
  const Index beside = n;
  for (const double fraction : beside_axis)
    for (const double side : {spike_width, -spike_width})
      at.col(n++) = seed.at + fraction * (axis + side * left_of(axis));
  Values f;
  curve.sampler().evaluate(at, f);
  const bool around = is_inside(f[beside]);
  for (Index k = beside; k < n; ++k)
    if (is_inside(f[k]) != around) return false;
  for (Index first = 0; first < beside; first += tries) {
    bool found = false;
    for (Index k = first; k < first + tries; ++k) found = found || is_inside(f[k]) != around;
    if (!found) return false;
  }
  return true;
}

// Does f change sign across the exhausted seed, along its gradient?
bool curve_passes(Crossings& curve, const Seed& seed, double step) {
  if (seed.gradient.isZero(0)) return false;
  Points<2> sides(2, 2);
  sides << seed.at + step * seed.gradient.normalized(), seed.at - step * seed.gradient.normalized();
  const Box<2>& box = curve.mesh().lattice().box;
  if (!box.contains(Point<2>(sides.col(0))) || !box.contains(Point<2>(sides.col(1)))) return false;
  Values f;
  curve.sampler().evaluate(sides, f);
  return is_inside(f[0]) != is_inside(f[1]);
}

// Points of the curve beside a seed through which it passes unseen: a sharp corner's sides, sought between its axis,
// which is the gradient, and the square to that.
Points<2> scouts(Crossings& curve, const Seed& seed) {
  const Lattice& lattice = curve.mesh().lattice();
  const Point<2> along = 0.25 * lattice.cell * seed.gradient.normalized();
  Points<2> ends(2, 4);
  ends << seed.at + along, seed.at - along, seed.at + left_of(along), seed.at - left_of(along);
  Values f;
  curve.sampler().evaluate(ends, f);
  std::vector<std::pair<Index, Index>> pairs;
  for (const Index axis : {0, 1})
    for (const Index side : {2, 3})
      if (is_inside(f[axis]) != is_inside(f[side]) && lattice.box.contains(Point<2>(ends.col(axis))) &&
          lattice.box.contains(Point<2>(ends.col(side))))
        pairs.emplace_back(is_inside(f[axis]) ? axis : side, is_inside(f[axis]) ? side : axis);
  const Index n = std::ssize(pairs);
  Points<2> inside(2, n), outside(2, n);
  Values inside_values(n), outside_values(n);
  for (Index k = 0; k < n; ++k) {
    const auto [in, out] = pairs[static_cast<std::size_t>(k)];
    inside.col(k) = ends.col(in), outside.col(k) = ends.col(out);
    inside_values[k] = f[in], outside_values[k] = f[out];
  }
  return find_roots(curve.sampler(), inside, outside, inside_values, outside_values, curve.tolerance()).positions;
}

}  // namespace

double smallest_triangle(const Lattice& lattice) { return std::max(0x1p-31 * lattice.extent, 64 * lattice.grain); }

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
      const double reach = step == 0 || step == 11 ? at_once * lattice.extent + lattice.grain : curve.tolerance();
      const bool near = squared > 0 ? std::abs(f[k]) <= std::sqrt(squared) * reach : std::abs(f[k]) <= 1e-12 * largest;
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
      seed.triangle = nearest_passage(curve, seed, 2 * place.size);
      seed.state = seed.triangle >= 0 ? Seed::State::satisfied : Seed::State::exhausted;
      return;
    }
    leaves.insert(leaves.end(), place.leaves.begin(), place.leaves.end());
  };
  std::vector<Trial> trials;
  for (Seed& seed : seeds) {
    if (seed.state == Seed::State::satisfied && !mesh.is_leaf(seed.triangle)) seed.state = Seed::State::pending;
    if (seed.state != Seed::State::pending) continue;
    const Place place = place_of(mesh, seed);
    const int t = seed.gradient.isZero(0) ? -1 : nearest_passage(curve, seed, 0.25 * place.size);
    Trial trial{&seed, t, -1, -1};
    const double away = 0.1 * place.size;
    if (t >= 0 && walk(curve, seed, t, false, away, trial.before) && walk(curve, seed, t, true, away, trial.after) &&
        (trial.before >= 0 || trial.after >= 0))
      trials.push_back(trial);
    else
      refuse(seed);
  }
  if (trials.empty()) return;
  std::vector<Verdict> verdicts = judge(curve, trials, first_trial, false);
  std::vector<Trial> smooth, corners;
  for (std::size_t k = 0; k < trials.size(); ++k) {
    if (verdicts[k] == Verdict::wrong)
      refuse(*trials[k].seed);
    else
      (verdicts[k] == Verdict::fits ? smooth : corners).push_back(trials[k]);
  }
  if (!corners.empty()) {
    verdicts = judge(curve, corners, second_trial, true);
    std::vector<Trial> passed;
    for (std::size_t k = 0; k < corners.size(); ++k)
      verdicts[k] == Verdict::fits ? passed.push_back(corners[k]) : refuse(*corners[k].seed);
    corners = passed;
  }
  for (const std::vector<Trial>* left : {&smooth, &corners}) {
    if (left->empty()) continue;
    const std::vector<bool> fit = sides_fit(curve, *left);
    for (std::size_t k = 0; k < left->size(); ++k) {
      Seed& seed = *(*left)[k].seed;
      if (!fit[k]) {
        refuse(seed);
        continue;
      }
      seed.state = Seed::State::satisfied;
      seed.triangle = (*left)[k].triangle;
      seed.corner = left == &corners;
    }
  }
}

bool settle_seeds(Crossings& curve, std::vector<Seed>& seeds) {
  bool added = false;
  const std::size_t count = seeds.size();
  for (std::size_t k = 0; k < count; ++k) {
    if (seeds[k].state != Seed::State::exhausted) continue;
    const double size = place_of(curve.mesh(), seeds[k]).size;
    const bool passes = curve_passes(curve, seeds[k], size);
    if (!passes && !seeds[k].gradient.isZero(0)) {
      seeds[k].state = Seed::State::off_curve;
      continue;
    }
    seeds[k].triangle = nearest_passage(curve, seeds[k], curve.mesh().lattice().cell);
    if (seeds[k].triangle >= 0 && is_tip(curve, seeds[k], seeds[k].triangle)) {
      seeds[k].state = Seed::State::satisfied;
    } else if (passes && !seeds[k].scouted) {
      seeds[k].scouted = added = true;
      for (Seed& scout : make_seeds(curve, scouts(curve, seeds[k]))) {
        scout.given = false;
        seeds.push_back(scout);
      }
    } else {
      seeds[k].state = passes ? Seed::State::lost : Seed::State::off_curve;
    }
  }
  return added;
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
