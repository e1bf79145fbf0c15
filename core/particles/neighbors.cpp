#include "core/particles/neighbors.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/base/check.h"
#include "core/base/parallel.h"

namespace seesaw {
namespace {

constexpr std::size_t leaf_size = 16;

// Two zeros between any two of the lowest 19 bits.
std::uint64_t spread_bits(std::uint64_t x) {
  x &= 0x7ffff;
  x = (x | x << 32) & 0x001f00000000ffff;
  x = (x | x << 16) & 0x001f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

// Radii of a population at rest differ by some tens of percent; counted from the median, in steps of four,
// they all fall into one class.
std::uint64_t class_of(double reach, double median) {
  if (!(reach > 0) || !(median > 0)) return 0;
  return static_cast<std::uint64_t>(std::clamp(32 + std::round(0.5 * std::log2(reach / median)), 1.0, 63.0));
}

double squared_distance(const Box<3>& a, const Box<3>& b) {
  const Point<3> gap = (a.min() - b.max()).cwiseMax(b.min() - a.max()).cwiseMax(0.0);
  return gap.squaredNorm();
}

}  // namespace

Neighbors::Neighbors(const PointsRef<3>& positions, const Eigen::Ref<const Values>& reaches)
    : positions_(positions), reaches_(reaches), order_(static_cast<std::size_t>(positions.cols())) {
  SEESAW_CHECK_EQ(positions_.cols(), reaches_.size());
  if (!order_.empty()) build();
}

void Neighbors::build() {
  const Index n = positions_.cols();
  std::vector<double> sorted(reaches_.begin(), reaches_.end());
  std::nth_element(sorted.begin(), sorted.begin() + n / 2, sorted.end());
  const double median = sorted[static_cast<std::size_t>(n / 2)];
  const Box<3> box = bounding_box_of<3>(positions_);
  const double longest = box.sizes().maxCoeff();
  const double scale = longest > 0 ? 524287.0 / longest : 0.0;
  std::vector<std::pair<std::uint64_t, int>> keys(order_.size());
  parallel_blocks(n, 4096, [&](Index begin, Index end) {
    for (Index i = begin; i < end; ++i) {
      const Point<3> at = scale * (positions_.col(i) - box.min());
      std::uint64_t key = class_of(reaches_[i], median) << 57;
      for (int d = 0; d < 3; ++d) key |= spread_bits(static_cast<std::uint64_t>(at[d])) << d;
      keys[static_cast<std::size_t>(i)] = {key, static_cast<int>(i)};
    }
  });
  std::sort(keys.begin(), keys.end());
  for (std::size_t k = 0; k < keys.size(); ++k) order_[k] = keys[k].second;

  levels_.emplace_back((order_.size() + leaf_size - 1) / leaf_size);
  for (std::size_t leaf = 0; leaf < levels_[0].size(); ++leaf)
    for (const int i : members(leaf)) {
      levels_[0][leaf].box.extend(Point<3>(positions_.col(i)));
      levels_[0][leaf].reach = std::max(levels_[0][leaf].reach, reaches_[i]);
    }
  while (levels_.back().size() > 1) {
    const std::vector<Node>& below = levels_.back();
    std::vector<Node> level((below.size() + 1) / 2);
    for (std::size_t k = 0; k < below.size(); ++k) {
      level[k / 2].box.extend(below[k].box);
      level[k / 2].reach = std::max(level[k / 2].reach, below[k].reach);
    }
    levels_.push_back(std::move(level));
  }
}

std::span<const int> Neighbors::members(std::size_t leaf) const {
  const std::size_t begin = leaf * leaf_size;
  return std::span<const int>(order_).subspan(begin, std::min(leaf_size, order_.size() - begin));
}

void Neighbors::for_each_leaf(
    const std::function<void(std::span<const int>, std::span<const int>)>& work) const {
  if (order_.empty()) return;
  parallel_blocks(static_cast<Index>(levels_[0].size()), 8, [&](Index first, Index last) {
    std::vector<int> candidates;
    std::vector<std::pair<std::size_t, std::size_t>> open;  // level, node
    for (Index leaf = first; leaf < last; ++leaf) {
      const Node& mine = levels_[0][static_cast<std::size_t>(leaf)];
      candidates.clear();
      open.assign(1, {levels_.size() - 1, 0});
      while (!open.empty()) {
        const auto [level, k] = open.back();
        open.pop_back();
        const Node& node = levels_[level][k];
        const double reach = std::max(mine.reach, node.reach);
        if (squared_distance(mine.box, node.box) > reach * reach) continue;
        if (level == 0) {
          const std::span<const int> found = members(k);
          candidates.insert(candidates.end(), found.begin(), found.end());
          continue;
        }
        if (2 * k + 1 < levels_[level - 1].size()) open.emplace_back(level - 1, 2 * k + 1);
        open.emplace_back(level - 1, 2 * k);
      }
      work(members(static_cast<std::size_t>(leaf)), candidates);
    }
  });
}

double Neighbors::nearest_squared(const Point<3>& point, Index but,
                                  const std::function<bool(int)>& accept) const {
  double best = infinity;
  if (order_.empty()) return best;
  struct Open {
    std::size_t level, k;
    double distance;
  };
  std::vector<Open> open = {{levels_.size() - 1, 0, 0.0}};
  while (!open.empty()) {
    const Open top = open.back();
    open.pop_back();
    if (top.distance >= best) continue;
    if (top.level == 0) {
      for (const int i : members(top.k)) {
        const double distance = (positions_.col(i) - point).squaredNorm();
        if (i != but && distance < best && (!accept || accept(i))) best = distance;
      }
      continue;
    }
    const std::vector<Node>& below = levels_[top.level - 1];
    Open children[2];
    int count = 0;
    for (std::size_t k = 2 * top.k; k < std::min(2 * top.k + 2, below.size()); ++k)
      children[count++] = {top.level - 1, k, below[k].box.squaredExteriorDistance(point)};
    // The nearer one last, so that it is opened first.
    if (count == 2 && children[0].distance < children[1].distance) std::swap(children[0], children[1]);
    for (int c = 0; c < count; ++c) open.push_back(children[c]);
  }
  return best;
}

}  // namespace seesaw
