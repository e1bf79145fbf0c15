// Triangles, line segments or points on the graphics card, ready to be drawn many times.
//
// Before it: a TriangleMesh of core/polygonize, the plate of a function, constraints. After it: view_3d.h.
#pragma once

#include <utility>
#include <vector>

#include "core/base/types.h"
#include "core/image/color.h"
#include "core/mesh/triangle_mesh.h"

namespace seesaw {

class Drawable {
 public:
  enum class Kind { triangles, segments, points };

  /// Nothing to draw. Needs no window yet.
  Drawable() = default;
  ~Drawable();
  Drawable(Drawable&& other) noexcept { swap(other); }
  Drawable& operator=(Drawable&& other) noexcept {
    swap(other);
    return *this;
  }

  // Each replaces what was there; a Window must exist, now and when the Drawable goes. `colors` are one a
  // vertex, or empty for the color that it will be drawn in. Kept in single precision: scenes far from the
  // origin should be moved there.

  /// Smooth where the mesh has normals, in facets where it has none.
  void set_triangles(const TriangleMesh& mesh, const std::vector<Color>& colors = {});
  /// 3 x 2N: columns 2i and 2i + 1 are the ends of segment i.
  void set_segments(const PointsRef<3>& ends, const std::vector<Color>& colors = {});
  /// 3 x N joined one after the other; `closed` joins the last to the first. Colors are one a point.
  void set_polyline(const PointsRef<3>& points, bool closed = false, const std::vector<Color>& colors = {});
  /// 3 x N.
  void set_points(const PointsRef<3>& points, const std::vector<Color>& colors = {});

  bool empty() const { return count_ == 0; }
  Kind kind() const { return kind_; }
  bool has_colors() const { return has_colors_; }
  /// Of vertices that are drawn: three a triangle, two a segment.
  int count() const { return count_; }
  /// Draws with the shader in use; position, normal and color are its inputs 0, 1 and 2.
  void draw() const;

 private:
  void swap(Drawable& other) {
    std::swap(array_, other.array_);
    std::swap(vertices_, other.vertices_);
    std::swap(indices_, other.indices_);
    std::swap(count_, other.count_);
    std::swap(kind_, other.kind_);
    std::swap(has_colors_, other.has_colors_);
  }
  void set(Kind kind, const PointsRef<3>& points, const PointsRef<3>& normals,
           const std::vector<Color>& colors, const std::vector<unsigned>& indices);

  unsigned array_ = 0, vertices_ = 0, indices_ = 0;
  int count_ = 0;
  Kind kind_ = Kind::triangles;
  bool has_colors_ = false;
};

}  // namespace seesaw
