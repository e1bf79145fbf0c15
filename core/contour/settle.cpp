// What becomes of seeds that no bisection could prove: settle_seeds of seeds.h.
#include "core/contour/place.h"

namespace seesaw {
namespace {

// Where a spike is looked for, as fractions of the way from its tip to where it was cut off; and how wide it
// may be.
constexpr double on_axis[] = {0.7, 0.5, 0.35};
constexpr double beside_axis[] = {0.7, 0.35, 0.1, 0.01, 1e-3};
constexpr double spike_width = 0.2;

// Is the seed the tip of a spike that was cut off at leaf t's passage, because it grows thinner than any
// triangle? Then a line from the seed to the passage runs inside the spike, and points well to both sides of
// it are not.
bool is_tip(Crossings& curve, const Seed& seed, int t) {
  const Passage passage = curve.passage(t);
  const Point<2> axis = 0.5 * (curve[passage.from].position + curve[passage.to].position) - seed.at;
  // The spike is cut where it is about as wide as its triangle; where in that width its axis runs is tried
  // out.
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

// Points of the curve beside a seed through which it passes unseen: a sharp corner's sides, sought between
// its axis, which is the gradient, and the square to that.
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
  return find_roots(curve.sampler(), inside, outside, inside_values, outside_values, curve.tolerance())
      .positions;
}

}  // namespace

bool settle_seeds(Crossings& curve, std::vector<Seed>& seeds) {
  bool added = false;
  const std::size_t count = seeds.size();
  for (std::size_t k = 0; k < count; ++k) {
    if (seeds[k].state != Seed::State::exhausted) continue;
    const double size = place_of(curve.mesh(), seeds[k]).size;
    // What was bisected since may have brought the curve here.
    seeds[k].triangle = nearest_passage(curve, seeds[k], last_reach * size);
    if (seeds[k].triangle >= 0) {
      seeds[k].state = Seed::State::satisfied;
      continue;
    }
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

}  // namespace seesaw
