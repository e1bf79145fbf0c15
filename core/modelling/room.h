// How far may a normal constraint stand from its vertex without running into another part of the model?
//
// Before it: triangle_tree.h.  After it: model_constraints.h places normal constraints.
//
// The paper steps 0.01 along the normal, whatever is there (Turk & O'Brien 2002, section 4.3). In a blade
// thinner than that the point comes out on the other side, where it says "inside" of a place that the other
// sheet's own constraints call outside. Two things are measured instead, in the model's unit cube:
//
//   thickness   how far along the step the first other triangle is hit. The step is cut to a third of it, so
//               that the steps from both sheets end at a third and at two thirds.
//   clearance   how far the end of the step is from the nearest triangle. Where that is less than a third of
//               the step, because another sheet passes by (a fold), the step is halved, up to six times.
//
// At the rim of a blade nothing helps: the point stays in a wedge whose walls are as near as the angle says,
// at every scale. There the value is lowered instead: `value` is the share of its usual value that the
// constraint should ask for, 1 where nothing was in the way. It is also lowered for steps of less than a
// quarter of what was asked for, in proportion: f may rise four times as steeply as elsewhere, and no more.
// (Measured on thin ellipsoids and plates: without that limit knife edges throw f off far away from them;
// with the same slope everywhere the sheets of a plate hold f down between the vertices, and holes open.)
#pragma once

#include <vector>

#include "core/modelling/triangle_tree.h"

namespace seesaw {

struct RoomOptions {
  /// The step that is asked for, > 0.
  double step = 0.01;
  /// The fraction of the thickness that is safe, 0 < safe <= 1/2.
  double safe = 1.0 / 3.0;
  /// How many times steeper than elsewhere f may be, >= 1, before the value is lowered.
  double steepest = 4.0;
};

struct Room {
  double step = 0;   ///< how far to go: at most what was asked for
  double value = 1;  ///< 0 < value <= 1, see above
};

/// Of one mesh, in coordinates in which `step` is meant.
class MeshRoom {
 public:
  /// `vertices` 3 x V, `faces` 3 x F. Vertices at one position count as one vertex.
  MeshRoom(const PointsRef<3>& vertices, const Faces& faces);

  /// Going from vertex `vertex` along the unit vector `direction`. The faces around the vertex, between which
  /// the step begins, bound the value but never the step.
  Room measure(Index vertex, const Point<3>& direction, const RoomOptions& options) const;

 private:
  Points<3> vertices_;
  std::vector<int> same_;  // V: the first vertex at the same position
  Faces faces_;
  TriangleTree tree_;
};

/// Of a cloud, which has no triangles to run into, only points whose normals say that they are of another
/// sheet: those that look the other way. The largest ball that touches the surface at the point from this
/// side and has none of them within tells the thickness: for a flat plate its diameter.
class CloudRoom {
 public:
  /// `points` and unit `normals` 3 x N; a zero normal is not known, and its point no obstacle.
  CloudRoom(const PointsRef<3>& points, const PointsRef<3>& normals);

  /// As MeshRoom's.
  Room measure(Index point, const Point<3>& direction, const RoomOptions& options) const;

 private:
  Points<3> points_, normals_;
  TriangleTree tree_;
};

}  // namespace seesaw
