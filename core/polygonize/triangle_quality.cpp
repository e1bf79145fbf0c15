#include "core/polygonize/triangle_quality.h"

#include <cmath>
#include <vector>

#include "core/base/parallel.h"

namespace seesaw {

double smallest_angle(const Points<3>& positions, const Faces& faces) {
  if (faces.cols() == 0) return 0;
  constexpr Index block = 4096;
  std::vector<double> least(static_cast<std::size_t>((faces.cols() + block - 1) / block));
  parallel_blocks(faces.cols(), block, [&](Index begin, Index end) {
    for (; begin < end; begin += block) {
      double its = 1;
      for (Index f = begin; f < std::min(begin + block, end); ++f)
        its = std::min(its, quality_of(positions.col(faces(0, f)), positions.col(faces(1, f)),
                                       positions.col(faces(2, f))));
      least[static_cast<std::size_t>(begin / block)] = its;
    }
  });
  return std::asin(std::sqrt(*std::min_element(least.begin(), least.end()))) * (180 / 3.14159265358979323846);
}

}  // namespace seesaw
