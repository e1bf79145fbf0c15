#include "core/contour/contour.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "core/base/tolerances.h"
#include "core/contour/hidden.h"
#include "core/contour/refine.h"
#include "core/contour/trace.h"

namespace seesaw {
namespace {

class Stopwatch {
 public:
  /// Seconds since the last call.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> passed = now - last_;
    last_ = now;
    return passed.count();
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

bool has_room(const Box<2>& box) {
  return !box.isEmpty() && box.min().allFinite() && box.max().allFinite() && box.sizes().allFinite() &&
         box.sizes().minCoeff() > 0;
}

// A passage that led through a seed may have been left out, having nothing inside it: f touches zero there
// from below.
void find_seeds_left_out(const Crossings& curve, const std::vector<Polyline>& polylines,
                         std::vector<Seed>& seeds) {
  const Lattice& lattice = curve.mesh().lattice();
  const double near = 2 * std::max(tolerance::on_curve * lattice.extent, lattice.grain);
  std::vector<std::pair<double, double>> vertices;
  for (const Polyline& polyline : polylines)
    for (Index i = 0; i < polyline.vertices.cols(); ++i)
      vertices.emplace_back(polyline.vertices(0, i), polyline.vertices(1, i));
  std::sort(vertices.begin(), vertices.end());
  for (Seed& seed : seeds) {
    if (seed.state != Seed::State::satisfied || !seed.given) continue;
    bool found = false;
    const std::pair<double, double> first(seed.at.x() - near, seed.at.y() - near);
    for (auto v = std::lower_bound(vertices.begin(), vertices.end(), first);
         !found && v != vertices.end() && v->first <= seed.at.x() + near; ++v)
      found = std::abs(v->second - seed.at.y()) <= near;
    if (found) continue;
    const Passage passage = curve.passage(seed.triangle);
    const bool on_zero_edge = curve[passage.from].corner >= 0 && curve[passage.to].corner >= 0;
    seed.state = on_zero_edge || seed.gradient.isZero(0) ? Seed::State::off_curve : Seed::State::lost;
  }
}

void count_seeds(const std::vector<Seed>& seeds, Contour& result) {
  for (const Seed& seed : seeds) {
    if (!seed.given) continue;
    switch (seed.state) {
      case Seed::State::satisfied:
        ++result.seeds_on_curve;
        break;
      case Seed::State::outside_box:
        ++result.seeds_outside_box;
        break;
      case Seed::State::off_curve:
        ++result.seeds_off_curve;
        break;
      case Seed::State::pending:
      case Seed::State::exhausted:
      case Seed::State::lost:
        ++result.seeds_lost;
        break;
    }
  }
}

// Everything after the lattice is known.
Contour contour_of(const Lattice& lattice, Sampler& sampler, const PointsRef<2>& points,
                   const ContourOptions& options, const Progress& progress, double from) {
  Contour result;
  Stopwatch watch;
  // Two bisections halve a triangle.
  const int turns =
      static_cast<int>(std::lround(2 * std::log2(static_cast<double>(options.finest_cells) / options.cells)));
  Triangulation triangulation(lattice, std::clamp(turns, 2, 60));
  Crossings curve(triangulation, sampler);
  std::vector<Seed> seeds = make_seeds(curve, points);
  result.times.refine = watch.lap();
  if (options.find_hidden) {
    for (Seed& seed : make_seeds(curve, hidden_points(lattice, sampler, curve.tolerance()))) {
      seed.given = false;
      seeds.push_back(seed);
    }
    result.times.hidden = watch.lap();
  }
  result.complete = refine(curve, seeds, options, progress, from);
  result.times.refine += watch.lap();
  attach_seeds(curve, seeds);
  result.polylines = trace(curve, seeds, options.angle_tolerance);
  result.area = inside_area(curve, result.polylines);
  result.components = static_cast<Index>(result.polylines.size());
  for (const Polyline& polyline : result.polylines) {
    result.closed += polyline.closed;
    result.vertices += polyline.vertices.cols();
    result.length += length(polyline);
  }
  find_seeds_left_out(curve, result.polylines, seeds);
  count_seeds(seeds, result);
  result.times.trace = watch.lap();
  return result;
}

std::vector<Contour> contours(const Field<2>& field, const Box<2>& box, const PointsRef<2>& seeds,
                              const std::vector<double>& levels, const ContourOptions& options,
                              const Progress& progress) {
  SEESAW_CHECK_LE(1, options.cells);
  SEESAW_CHECK_LE(options.cells, 8192);
  SEESAW_CHECK_LE(1, options.finest_cells);
  std::vector<Contour> results(levels.size());
  if (!has_room(box)) {
    for (Contour& result : results) result.seeds_outside_box = seeds.cols();
    return results;
  }
  Stopwatch watch;
  Lattice shared = make_lattice(box, options.cells);
  Sampler plain(field, 0);
  const double lattice_share = 0.7;
  evaluate(shared, plain, progress, 0, lattice_share);
  const double lattice_time = watch.lap();
  for (std::size_t k = 0; k < levels.size(); ++k) {
    Sampler sampler(field, levels[k]);
    Lattice lattice = shared;
    lattice.values.array() -= levels[k];
    const double from =
        lattice_share + (1 - lattice_share) * static_cast<double>(k) / static_cast<double>(levels.size());
    Contour& result = results[k] = contour_of(lattice, sampler, seeds, options, progress, from);
    result.times.lattice = lattice_time;
    result.evaluations = plain.evaluations + sampler.evaluations;
    result.gradient_evaluations = sampler.gradient_evaluations;
    result.nonfinite = plain.nonfinite + sampler.nonfinite;
  }
  report(progress, 1);
  return results;
}

}  // namespace

Contour contour(const Field<2>& field, const Box<2>& box, const PointsRef<2>& seeds,
                const ContourOptions& options, const Progress& progress) {
  return std::move(contours(field, box, seeds, {options.level}, options, progress).front());
}

Contour contour(const Field<2>& field, const Box<2>& box, const ContourOptions& options,
                const Progress& progress) {
  return contour(field, box, Points<2>(2, 0), options, progress);
}

std::vector<Contour> isolines(const Field<2>& field, const Box<2>& box, const std::vector<double>& levels,
                              const ContourOptions& options, const Progress& progress) {
  return contours(field, box, Points<2>(2, 0), levels, options, progress);
}

}  // namespace seesaw
