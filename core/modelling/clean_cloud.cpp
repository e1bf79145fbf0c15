#include "core/modelling/clean_cloud.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/modelling/triangle_tree.h"
#include "core/modelling/unit_cube.h"

namespace seesaw {

namespace {

constexpr int neighbors = 16, fourth = 3;

/// The neighbors of one point, nearest first.
struct Ring {
  std::array<int, neighbors> index;
  std::array<double, neighbors> distance;
};

/// Of all points. The search begins well below `usual`, which a dense patch would make the whole of it.
std::vector<Ring> rings_of(const Points<3>& points, double usual) {
  Faces faces(3, points.cols());
  for (Index i = 0; i < faces.cols(); ++i) faces.col(i).setConstant(static_cast<int>(i));
  const TriangleTree tree(points, faces);
  std::vector<Ring> rings(static_cast<std::size_t>(points.cols()));
  parallel_blocks(points.cols(), 256, [&](Index begin, Index end) {
    std::vector<std::pair<double, int>> found;
    for (Index i = begin; i < end; ++i) {
      for (double radius = usual / 32; static_cast<int>(found.size()) < neighbors; radius *= 2) {
        found.clear();
        tree.visit_within(points.col(i), radius, [&](int other) {
          if (other != i) found.emplace_back((points.col(other) - points.col(i)).norm(), other);
        });
      }
      std::partial_sort(found.begin(), found.begin() + neighbors, found.end());
      for (std::size_t k = 0; k < neighbors; ++k) {
        rings[static_cast<std::size_t>(i)].distance[k] = found[k].first;
        rings[static_cast<std::size_t>(i)].index[k] = found[k].second;
      }
      found.clear();
    }
  });
  return rings;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

bool is_known(const Point<3>& normal) { return normal.allFinite() && normal.cwiseAbs().maxCoeff() > 0; }

bool is_contradicted(const PointCloud& cloud, Index i, const Ring& ring) {
  const Point<3> mine = cloud.normals.col(i);
  if (!is_known(mine)) return false;
  int against = 0, asked = 0;
  for (const int other : ring.index) {
    const Point<3> theirs = cloud.normals.col(other);
    if (!is_known(theirs)) continue;
    ++asked;
    against += mine.normalized().dot(theirs.normalized()) < 0;
  }
  return asked >= 8 && 4 * against > 3 * asked;
}

}  // namespace

CleanCloud cleaned(const PointCloud& cloud) {
  const Index n = cloud.points.cols();
  if (n < 50) return {cloud};
  const Points<3> unit = UnitCube::of(bounding_box_of<3>(cloud.points)).apply(cloud.points);
  // As far as neighbors would be if the points were spread over a square.
  const std::vector<Ring> rings = rings_of(unit, 2 / std::sqrt(static_cast<double>(n)));
  std::vector<double> reach(rings.size());
  for (std::size_t i = 0; i < rings.size(); ++i) reach[i] = rings[i].distance[fourth];
  const double usual = median(reach);

  // Strays are few: what would throw out more than 3 in 100 has mistaken a thinly scanned part for them.
  std::vector<bool> stray(rings.size(), false);
  const auto apply = [&](const auto& is_astray) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < rings.size(); ++i)
      if (is_astray(i)) found.push_back(i);
    if (100 * found.size() <= 3 * rings.size())
      for (const std::size_t i : found) stray[i] = true;
  };
  // Where points share one place there is no distance to compare with.
  apply([&](std::size_t i) { return usual > 0 && reach[i] > 8 * usual; });
  apply([&](std::size_t i) {
    std::vector<double> theirs;
    for (const int other : rings[i].index) theirs.push_back(reach[static_cast<std::size_t>(other)]);
    const double local = median(std::move(theirs));
    return local > 0 && reach[i] > 4 * local;
  });

  CleanCloud result;
  std::vector<Index> kept;
  Points<3> normals = cloud.normals;
  for (Index i = 0; i < n; ++i) {
    if (stray[static_cast<std::size_t>(i)]) {
      ++result.strays;
      continue;
    }
    kept.push_back(i);
    if (!cloud.has_normals() || !is_contradicted(cloud, i, rings[static_cast<std::size_t>(i)])) continue;
    normals.col(i).setZero();
    ++result.contradicted;
  }
  result.cloud.points.resize(3, static_cast<Index>(kept.size()));
  if (cloud.has_normals()) result.cloud.normals.resize(3, static_cast<Index>(kept.size()));
  for (std::size_t k = 0; k < kept.size(); ++k) {
    result.cloud.points.col(static_cast<Index>(k)) = cloud.points.col(kept[k]);
    if (cloud.has_normals()) result.cloud.normals.col(static_cast<Index>(k)) = normals.col(kept[k]);
  }
  return result;
}

}  // namespace seesaw
