#include "core/particles/measures.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/particles/neighbors.h"
#include "core/particles/same_sheet.h"

namespace seesaw {

Spacing spacing_of(const PointsRef<3>& positions, const PointsRef<3>& normals) {
  const Index n = positions.cols();
  if (normals.cols() > 0) SEESAW_CHECK_EQ(normals.cols(), n);
  const Neighbors neighbors(positions, Values::Zero(n));
  Values nearest(n);
  parallel_blocks(n, 64, [&](Index begin, Index end) {
    for (Index i = begin; i < end; ++i) {
      const Point<3> at = positions.col(i);
      const auto on_sheet = [&](int j) {
        return same_sheet(at - positions.col(j), normals.col(i), normals.col(j)) > 0.5;
      };
      nearest[i] = std::sqrt(normals.cols() > 0 ? neighbors.nearest_squared(at, i, on_sheet)
                                                : neighbors.nearest_squared(at, i));
    }
  });
  Index count = 0;
  Spacing result;
  result.least = infinity;
  for (const double distance : nearest)
    if (std::isfinite(distance)) {
      ++count;
      result.mean += distance;
      result.least = std::min(result.least, distance);
    }
  if (count == 0) return {};
  result.mean /= static_cast<double>(count);
  double squares = 0;
  for (const double distance : nearest)
    if (std::isfinite(distance)) squares += (distance - result.mean) * (distance - result.mean);
  if (result.mean > 0) result.variation = std::sqrt(squares / static_cast<double>(count)) / result.mean;
  return result;
}

FloaterMeasures measure(const Floaters& floaters, const Field<3>& field) {
  FloaterMeasures result;
  result.floaters = floaters.size();
  result.counts = floaters.counts();
  result.astray = floaters.astray();
  if (floaters.size() == 0) return result;
  result.spacing = spacing_of(floaters.positions(), floaters.normals());
  result.mean_radius = floaters.radii().mean();
  const Values off = touch(field, floaters.positions()).distances();
  result.most_off = off.maxCoeff();
  result.most_off_radii = (off.array() / floaters.radii().array()).maxCoeff();
  const Values speeds = floaters.velocities().colwise().norm();
  result.mean_speed = speeds.mean();
  result.most_speed = speeds.maxCoeff();
  return result;
}

double largest_gap(const PointsRef<3>& positions, const PointsRef<3>& surface) {
  const Neighbors neighbors(positions, Values::Zero(positions.cols()));
  Values nearest(surface.cols());
  parallel_blocks(surface.cols(), 256, [&](Index begin, Index end) {
    for (Index i = begin; i < end; ++i) nearest[i] = neighbors.nearest_squared(surface.col(i));
  });
  return surface.cols() > 0 ? std::sqrt(nearest.maxCoeff()) : 0.0;
}

}  // namespace seesaw
