// Where is the model nearest to a point, and what does a ray hit first? A tree of boxes around triangles.
//
// Before it: a mesh, or a cloud as triangles of no size.  After it: model_constraints.h asks both.
//
// The triangles are halved at the median of their middles along the longest side of the box around these,
// until four are left. Both searches then open the nearer box first and drop every box that cannot beat what
// is known: about log F boxes for a scattered mesh. The answers are those of looking at all triangles.
#pragma once

#include <functional>
#include <vector>

#include "core/mesh/triangle_mesh.h"

namespace seesaw {

class TriangleTree {
 public:
  /// Of F >= 0 triangles (`faces` 3 x F into `vertices` 3 x V), which are copied. Triangles of no area count
  /// as the segments or points they are. O(F log F).
  TriangleTree(const PointsRef<3>& vertices, const Faces& faces);

  /// A test of faces that must not count: true leaves the face out. Empty: all count.
  using Ignore = std::function<bool(int face)>;

  struct Nearest {
    int face = -1;  ///< -1: nothing within `within`
    Point<3> point = Point<3>::Zero();
    double distance = infinity;
  };
  /// The point of the triangles nearest to `point`, if it is nearer than `within`. Of equally near faces the
  /// one with the lowest number.
  Nearest nearest(const Point<3>& point, double within = infinity, const Ignore& ignore = {}) const;

  struct Hit {
    int face = -1;  ///< -1: nothing
    double distance = infinity;
  };
  /// The first triangle, seen from either side, that the ray from `origin` along the unit vector `direction`
  /// meets at a distance of 0 or more and less than `within`. A ray through an edge or a vertex hits (to a
  /// billionth of the triangle's size). Triangles without area are never hit.
  Hit first_hit(const Point<3>& origin, const Point<3>& direction, double within = infinity,
                const Ignore& ignore = {}) const;

  /// Calls `visit(face)` for each face that has a point within `radius` of `point`, in the tree's order.
  void visit_within(const Point<3>& point, double radius, const std::function<void(int face)>& visit) const;

 private:
  struct Node {
    Box<3> box;
    int begin = 0, end = 0;  // of order_
    int right = -1;          // the second child, or -1 in a leaf; the first child stands next to its parent
  };
  void build(int begin, int end, const Points<3>& middles);
  Point<3> corner(int face, int k) const { return vertices_.col(faces_(k, face)); }

  Points<3> vertices_;
  Faces faces_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

/// The point of the triangle a b c nearest to `point`; a, b, c may lie on a line or be one point.
Point<3> nearest_in_triangle(const Point<3>& point, const Point<3>& a, const Point<3>& b, const Point<3>& c);

/// The distance along the unit vector `direction` at which the ray meets the triangle, or infinity.
double ray_hits_triangle(const Point<3>& origin, const Point<3>& direction, const Point<3>& a,
                         const Point<3>& b, const Point<3>& c);

}  // namespace seesaw
