// A model as its file has it: vertices and polygons, nothing repaired, nothing left out.
//
// Before it: one of the readers of mesh_readers.h.  After it: mesh_repair.h makes a TriangleMesh of it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/types.h"

namespace seesaw {

struct PolygonSoup {
  std::vector<double> coordinates;  ///< x, y, z of vertex 0, of vertex 1, ...; all finite
  /// Likewise the normals of the vertices, outward, of any length, or empty. NaN says "not known here".
  std::vector<double> normals;
  std::vector<int> corners;       ///< the vertices of polygon 0, of polygon 1, ...; all in range
  std::vector<std::size_t> ends;  ///< where in `corners` each polygon ends, and the next begins
  Index lines_and_points = 0;     ///< elements of fewer than three corners, which a surface has no use for

  Index vertices() const { return static_cast<Index>(coordinates.size() / 3); }
  Index polygons() const { return static_cast<Index>(ends.size()); }
  std::span<const int> polygon(Index i) const {
    const auto p = static_cast<std::size_t>(i);
    const std::size_t begin = p == 0 ? 0 : ends[p - 1];
    return {corners.data() + begin, ends[p] - begin};
  }
  Eigen::Map<const Points<3>> points() const { return {coordinates.data(), 3, vertices()}; }

  /// Ends the polygon whose corners were added last; one of fewer than three is counted and taken back.
  void end_polygon() {
    const std::size_t begin = ends.empty() ? 0 : ends.back();
    if (corners.size() - begin >= 3) {
      ends.push_back(corners.size());
    } else {
      ++lines_and_points;
      corners.resize(begin);
    }
  }
};

}  // namespace seesaw
