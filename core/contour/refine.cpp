#include "core/contour/refine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace seesaw {
namespace {

constexpr double other_curve_cosine = 0.707;  // 45 degrees
// A turn in so short a chord, relative to its triangle, belongs to something much smaller than the triangle.
constexpr double tiny_chord = 0.125;
constexpr double other_curve_size = 0x1p-20;  // of the extent

// The cosine of the angle between a gradient and a chord's left side; 1 where that says nothing: no gradient,
// or a chord across a mere corner of the triangle, too short to have a direction.
double chord_cosine(const Crossing& end, const Point<2>& chord) {
  const double length = chord.norm(), size = end.gradient.norm();
  if (!(size > 0) || length <= 1e-3 * end.edge_length) return 1;
  return end.gradient.dot(Point<2>(-chord.y(), chord.x())) / (size * length);
}

// The cosine of the largest angle between the gradients at the passage's ends and the left side of the chord,
// or of the chords to and from the seeds `on_it` (the first and last along the curve), where the curve may
// have a corner.
double worst_cosine(const Crossing& a, const Crossing& b, const std::array<const Seed*, 2>& on_it) {
  if (on_it[0] != nullptr)
    return std::min(chord_cosine(a, on_it[0]->at - a.position), chord_cosine(b, b.position - on_it[1]->at));
  const Point<2> chord = b.position - a.position;
  const double sizes = a.gradient.norm() * b.gradient.norm();
  const double turn = sizes > 0 ? a.gradient.dot(b.gradient) / sizes : 1;
  return std::min({turn, chord_cosine(a, chord), chord_cosine(b, chord)});
}

// Satisfied seeds at which the curve may have a corner, by the leaf of their passage.
class CornerSeeds {
 public:
  explicit CornerSeeds(const std::vector<Seed>& seeds) {
    for (const Seed& seed : seeds)
      if (seed.given && seed.corner && seed.state == Seed::State::satisfied)
        order_.emplace_back(seed.triangle, &seed);
    std::sort(order_.begin(), order_.end());
  }
  /// The first and last seed along `chord` on leaf t's passage; null for none.
  std::array<const Seed*, 2> on(int t, const Point<2>& chord) const {
    std::array<const Seed*, 2> ends{nullptr, nullptr};
    for (auto at = std::lower_bound(order_.begin(), order_.end(), std::pair<int, const Seed*>(t, nullptr));
         at != order_.end() && at->first == t; ++at) {
      const double where = at->second->at.dot(chord);
      if (ends[0] == nullptr || where < ends[0]->at.dot(chord)) ends[0] = at->second;
      if (ends[1] == nullptr || where > ends[1]->at.dot(chord)) ends[1] = at->second;
    }
    return ends;
  }

 private:
  std::vector<std::pair<int, const Seed*>> order_;
};

}  // namespace

bool refine(Crossings& curve, std::vector<Seed>& seeds, const ContourOptions& options,
            const Progress& progress, double from) {
  Triangulation& mesh = curve.mesh();
  const double smallest = std::max(other_curve_size * mesh.lattice().extent, 64 * mesh.lattice().grain);
  const double tolerance_cosine = std::cos(std::clamp(options.angle_tolerance, 1e-3, 3.0));
  std::vector<int> marked;
  int first = 0;
  bool bisected_since_check = false;
  for (;;) {
    marked.clear();
    const int made = mesh.size();
    check_seeds(curve, seeds, marked);
    const CornerSeeds corner_seeds(seeds);
    for (int t = first; t < made; ++t) {
      if (!mesh.is_leaf(t) || !mesh.is_mixed(t)) continue;
      const Passage passage = curve.passage(t);
      if (curve.is_point(passage)) continue;
      const Crossing &from_end = curve[passage.from], &to_end = curve[passage.to];
      const double cosine =
          worst_cosine(from_end, to_end, corner_seeds.on(t, to_end.position - from_end.position));
      if (cosine >= tolerance_cosine) continue;
      const auto [a, b] = mesh.edge(t, 0);
      const double size = (mesh.position(a) - mesh.position(b)).norm();
      const bool tiny = (to_end.position - from_end.position).norm() < tiny_chord * size;
      const bool may_be_another = (cosine < other_curve_cosine || tiny) && size > smallest;
      if (!may_be_another && mesh.triangle(t).turns_left <= 0) continue;
      if (!may_be_another) --mesh.triangle(t).turns_left;
      marked.push_back(t);
    }
    first = made;
    if (marked.empty() && bisected_since_check) {
      // What was bisected for other reasons may have changed what satisfied a seed.
      bisected_since_check = false;
      for (Seed& seed : seeds)
        if (seed.state == Seed::State::satisfied) seed.state = Seed::State::pending;
      check_seeds(curve, seeds, marked);
    }
    if (marked.empty()) {
      if (!settle_seeds(curve, seeds)) return true;
      check_seeds(curve, seeds, marked);
    }
    if (mesh.refined_vertices() + static_cast<Index>(marked.size()) > options.max_refined_vertices)
      return false;
    for (const int t : marked)
      if (mesh.is_leaf(t)) mesh.bisect(t);
    bisected_since_check = true;
    // `first` leaves were judged before this round; only what it made is new.
    curve.update(first);
    // How long it will take nobody knows; what is left shrinks as the vertices approach their limit.
    report(progress, from + (1 - from) * static_cast<double>(mesh.refined_vertices()) /
                                static_cast<double>(options.max_refined_vertices));
  }
}

}  // namespace seesaw
