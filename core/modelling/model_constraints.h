// From a polygon model or a scan to constraints: every vertex says where the surface is and which way is out.
//
// Before it: a mesh or an oriented cloud (core/mesh), perhaps thinned by simplify.h or point_sampling.h.
// After it: core/rbf/fit.h makes the surface; blend.h mixes it with others.
//
// Turk & O'Brien 2002, section 4.3: one boundary constraint at each vertex, f = 0, and one normal constraint
// at
//     vertex - 0.01 normal,    f = 1,     "for objects that fit within a unit cube".
// Other models keep their place and size: the offset is 0.01 of the longest side of their box. Where so much
// would leave the model, the offset shrinks, and far down the value with it: room.h. How often, and how far,
// is reported.
//
//     const ModelConstraints made = constraints_from(mesh);
//     const Fit<3> fitted = fit(made.constraints);
//     made.report.shrunk;         // how many normal constraints the paper's offset would have misplaced
//
// A vertex without a usable normal gives a boundary constraint alone. Several vertices at one position each
// keep their normal. Vertices that crowd together closer than a solver can tell apart are thinned.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/mesh/triangle_mesh.h"
#include "core/modelling/unit_cube.h"
#include "core/rbf/constraints.h"

namespace seesaw {

/// On which side of the surface the companions of boundary constraints stand. The paper: inside;
/// "alternatively", outside (section 4.3). With `both`, those outside are exterior constraints.
enum class NormalSide { inside, outside, both };

struct ModelConstraintOptions {
  /// Only these vertices, in this order, such as point_sampling.h chooses; none: all.
  std::vector<Index> chosen = {};
  /// Of the normal constraints, as a fraction of the longest side of the model's box, > 0.
  double offset = 0.01;
  /// f there, > 0; outside its negative.
  double value = 1.0;
  NormalSide side = NormalSide::inside;
  /// False: the paper's fixed offset, whatever it runs into.
  bool shrink = true;
  /// Move and scale the model so that its box has its middle at the origin and longest side 1.
  bool to_unit_cube = false;
  /// Rows of the system nearer to each other than this, as a fraction of the longest side, but not at one
  /// position, are thinned. Measured with 1,000 vertices: at 1e-4 the solver keeps 7 digits, at 1e-5 it gives
  /// up.
  double crowded = 1e-4;
};

struct ModelConstraintReport {
  Index vertices = 0;         ///< points that were considered: of a mesh, those in faces
  Index boundary = 0;         ///< boundary constraints
  Index normal = 0;           ///< companions, inside and outside
  Index shrunk = 0;           ///< of them, how many stand nearer than asked for
  Index lowered = 0;          ///< of them, how many stand in a wedge and ask for a smaller value alone
  double smallest = 0;        ///< the smallest offset, as a fraction of the longest side; 0 for none
  Index normals_unknown = 0;  ///< zero or not finite: no companion
  Index no_room = 0;          ///< companions left out because less than `crowded` was left for them
  Index crowded = 0;          ///< vertices left out because another stands too near
  UnitCube cube;              ///< the model's center and longest side, in its own units
};

struct ModelConstraints {
  Constraints<3> constraints;
  ModelConstraintReport report;
};

/// One boundary constraint for every vertex of a mesh that is in a face, in their order; normals are the
/// mesh's own if it has some, else vertex_normals. Vertices must be finite. Throws Error for a mesh without
/// faces.
ModelConstraints constraints_from(const TriangleMesh& mesh, const ModelConstraintOptions& options = {},
                                  const Progress& progress = {});

/// The same for the points of a cloud. All of its points are asked where there is room, not only those that
/// were chosen. Throws Error for an empty cloud.
ModelConstraints constraints_from(const PointCloud& cloud, const ModelConstraintOptions& options = {},
                                  const Progress& progress = {});

}  // namespace seesaw
