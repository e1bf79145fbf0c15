#include "core/mesh/weld.h"

#include <algorithm>
#include <numeric>

namespace seesaw {

std::vector<int> first_of_equals(const Eigen::Ref<const Points<3>>& points) {
  std::vector<int> order(static_cast<std::size_t>(points.cols()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int i, int j) {
    for (int d = 0; d < 3; ++d)
      if (points(d, i) != points(d, j)) return points(d, i) < points(d, j);
    return i < j;
  });
  std::vector<int> first(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool equal = i > 0 && points.col(order[i]) == points.col(order[i - 1]);
    first[static_cast<std::size_t>(order[i])] =
        equal ? first[static_cast<std::size_t>(order[i - 1])] : order[i];
  }
  return first;
}

}  // namespace seesaw
