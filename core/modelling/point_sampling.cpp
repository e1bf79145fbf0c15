#include "core/modelling/point_sampling.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"
#include "core/base/parallel.h"

namespace seesaw {

PointSample farthest_points(const PointsRef<3>& points, Index count, const std::vector<Index>& start,
                            const Progress& progress) {
  PointSample sample;
  const Index n = points.cols();
  if (n == 0 || count <= 0) return sample;
  Values squares = Values::Constant(n, infinity);
  // Blocks keep their own farthest point, so that one pass updates and finds.
  constexpr Index block = 16384;
  const Index blocks = (n + block - 1) / block;
  std::vector<Index> farthest(static_cast<std::size_t>(blocks), 0);
  const auto take = [&](Index chosen) {
    sample.chosen.push_back(chosen);
    const Point<3> at = points.col(chosen);
    parallel_blocks(n, block, [&](Index begin, Index end) {
      for (Index first = begin; first < end; first += block) {
        const Index last = std::min(first + block, end);
        Index best = first;
        for (Index i = first; i < last; ++i) {
          squares[i] = std::min(squares[i], (points.col(i) - at).squaredNorm());
          if (squares[i] > squares[best]) best = i;
        }
        farthest[static_cast<std::size_t>(first / block)] = best;
      }
    });
  };
  const auto farthest_of_all = [&] {
    Index best = farthest[0];
    for (const Index each : farthest)
      if (squares[each] > squares[best]) best = each;
    return best;
  };

  for (const Index each : start) {
    SEESAW_CHECK_LE(0, each);
    SEESAW_CHECK_LT(each, n);
    if (static_cast<Index>(sample.chosen.size()) < count && squares[each] > 0) take(each);
  }
  if (sample.chosen.empty()) {
    const Point<3> middle = bounding_box_of<3>(points).center();
    Index first = 0;
    (points.colwise() - middle).colwise().squaredNorm().maxCoeff(&first);
    take(first);
  }
  while (static_cast<Index>(sample.chosen.size()) < count && squares[farthest_of_all()] > 0) {
    take(farthest_of_all());
    if (sample.chosen.size() % 64 == 0)
      report(progress, static_cast<double>(sample.chosen.size()) / static_cast<double>(count));
  }
  sample.covering_radius = std::sqrt(squares[farthest_of_all()]);
  return sample;
}

}  // namespace seesaw
