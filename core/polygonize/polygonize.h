// From a field to a mesh: the surface f = 0 as triangles, by Bloomenthal's continuation.
//
// Before it: any Field<3>, and the boundary constraints it was asked to pass through ("seeds").
// After it: core/mesh (checks, files), core/raytrace, pictures.
//
// T&O 2002, section 7.1, after Bloomenthal 1988 and 1994: space is a lattice of cubes. A cube whose corners
// are not all on one side is crossed by the surface; from it one goes to those of its six neighbors that
// share a crossed face, and so crawls over the whole component without ever looking at the rest of space. We
// start in the cubes of *every* seed, so a component that passes through a constraint is found. One file a
// step:
//
//   lattice.h        where the cubes are, and their numbers
//   continuation.h   waves of cubes: new corners of a wave are evaluated in one batch, each corner once
//   scan.h           the exhaustive mode: all cubes of the box
//   cube_table.h     one cube's polygons for each of its 256 patterns of signs, made by walking its faces
//   assemble.h       cubes to triangles: a closed, oriented manifold by construction
//   edge_roots.h     where f = 0 on a lattice edge
//   specks.h         what has nothing inside is no surface
//   seeds.h          walks seeds onto f = 0; does the mesh pass there, facing the right way?
//   small.h          looks with finer lattices for the small component that a seed stands on
//   improve.h        no needles, by three moves (of a working_mesh.h, in parallel by moves.h):
//   collapse.h       short edges, and edges of needles that are left, collapse
//   flip.h           edges flip
//   slide.h          vertices slide along the surface
//   project.h        Newton along the gradient: vertices onto f = 0, and their normals
//
// The sign rule is that of field.h: f >= 0 is inside (-0.0 too), everything else outside, also what is not a
// finite number. T&O interpolants are exactly zero at their constraints, and constraints love lattice
// corners. Whatever the values are, the mesh is an oriented manifold whose only boundary lies on the faces of
// the box. A vertex on a lattice edge whose inside end is exactly zero lies at that end.
//
// What is promised: a manifold mesh, closed but for cuts on the box; vertices on f = 0 to |f| / |grad f| <=
// 1e-12 of the box wherever Newton or bisection can get there; the same bits whatever the number of threads.
// What is not: a component through no seed is not looked for (unless `exhaustive`), and one smaller than a
// cube may then escape the lattice, too. A sheet or a gap thinner than one and a half cubes may get holes
// that no seed sees. Sharp creases of f are cut off at the size of a cube.
#pragma once

#include <cstddef>
#include <optional>

#include "core/base/progress.h"
#include "core/implicit/field.h"
#include "core/mesh/triangle_mesh.h"

namespace seesaw {

struct PolygonizeOptions {
  /// Cubes across, 1 to 65536: along the longest side of `box`; where there is none, of the box around the
  /// seeds (but at least a quarter of the field's own bounding box); without seeds of the field's box.
  int cells = 100;
  /// Cut the surface at this box. None: the surface is followed through field.bounding_box(); where it leaves
  /// that but closes within a box of twice the size, it is followed there, and otherwise it is cut at
  /// field.bounding_box().
  std::optional<Box<3>> box = std::nullopt;
  /// Look into every cube of the box: finds components that pass through no seed. Costs cells^3 evaluations.
  /// Without seeds there is no other way, and this is done unasked.
  bool exhaustive = false;
  /// Collapse short edges, flip and slide, so that no triangle is a needle. Changes no topology.
  bool improve = true;
  /// Where a seed stands on a surface thinner than a cube, everything is done again with half the cube, at
  /// most so many times. A small closed component alone is meshed finely by itself and costs no halving.
  int halvings = 2;
  /// Bytes that the work may take; beyond, it is refused with an Error that says what to do.
  std::size_t memory_limit = std::size_t{2} << 30;
};

/// Where the time went, wall seconds.
struct PolygonizeTimes {
  double lattice = 0;   ///< continuation or scan: values at the corners
  double assemble = 0;  ///< cubes to triangles, roots on edges
  double seeds = 0;     ///< walking to, and checking on, the seeds; small components
  double improve = 0;
  double polish = 0;  ///< vertices onto f = 0, normals
};

struct Polygonization {
  TriangleMesh mesh;  ///< outward normals, from the gradient

  // Facts about it.
  Index components = 0;           ///< connected pieces
  bool clipped = false;           ///< the surface was cut by the box: the mesh has a boundary
  double cell = 0;                ///< longest side of a cube, scene units (after halvings)
  double smallest_angle_raw = 0;  ///< degrees, over all triangles, as the lattice made them
  double smallest_angle = 0;      ///< degrees, of `mesh`; 0 for no triangles

  // What became of the seeds: on_surface + outside + nowhere + missed is their number.
  /// A quarter of a cube from a triangle that faces as f does there; on a ridge, which a mesh cuts off, up to
  /// three quarters; on a crease or a cone's tip, one (seeds.h).
  Index seeds_on_surface = 0;
  Index seeds_outside = 0;     ///< beyond the box
  Index seeds_nowhere = 0;     ///< f has no surface there: not near zero, or zero only in a point or a sheet
  Index seeds_missed = 0;      ///< there is a surface, and the mesh has it not: too thin for the halvings
  Index small_components = 0;  ///< closed components less than a cube or two across, meshed by themselves

  // What it took.
  Index evaluations = 0;           ///< points at which the field was evaluated
  Index gradient_evaluations = 0;  ///< how many of them with their gradient
  Index nonfinite = 0;             ///< evaluations that gave no finite number; they count as outside
  Index cubes = 0;                 ///< cubes that the surface crosses
  Index unpolished = 0;  ///< vertices that stand where the sign changes but not to rounding on f = 0
  int halved = 0;        ///< how often the cube was halved
  PolygonizeTimes times;
};

/// The surface f = 0. `seeds` is 3 x N: points known to be on it, the boundary constraints; a seed on which f
/// is not quite zero is moved along the gradient until it is, if that is near. The result does not depend on
/// the number of threads. An empty or unbounded box has no surface. Throws Cancelled; Error where
/// `memory_limit` does not suffice.
Polygonization polygonize(const Field<3>& field, const PointsRef<3>& seeds,
                          const PolygonizeOptions& options = {}, const Progress& progress = {});

}  // namespace seesaw
