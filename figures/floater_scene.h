// Floaters and constraints as the papers draw them: a surface of discs, thicker red discs for boundary
// constraints, spikes for normals.
//
// Before it: core/particles, core/rbf/constraints.h.  After it: figures/studio.h, which takes the picture.
#pragma once

#include "core/mesh/triangle_mesh.h"
#include "core/particles/measures.h"
#include "core/raytrace/scene.h"
#include "core/rbf/constraints.h"
#include "figures/figure.h"

namespace seesaw {

/// Discs that nearly touch where floaters are at rest.
DiscsObject floater_discs(const Floaters& floaters, const Color& color = surface::blue);
/// Floaters of radii above `wide`, scene units, apart from the rest: the settlers of empty land.
std::vector<DiscsObject> floater_discs_by_radius(const Floaters& floaters, double wide);

/// Those that face the eye: the far side of a surface does not show through the gaps of the near one.
DiscsObject facing(const DiscsObject& discs, const Point<3>& eye);

/// Adds a thick disc of `radius` (scene units) for each boundary constraint that faces the eye, tangent to f
/// = 0, and a spike for each normal.
void add_constraint_discs(Scene& scene, const Field<3>& field, const Constraints<3>& constraints,
                          double radius, const Point<3>& eye);
/// The same for points alone, such as control points.
void add_discs(Scene& scene, const Field<3>& field, const PointsRef<3>& points, double radius,
               const Point<3>& eye, const Color& color = surface::marker);

/// Adds floaters, neighbor_distance (mean, least, variation), largest_gap, most_off_surface, births, deaths.
/// `surface`: points dense on it, for the gap.
void add_floater_facts(Facts& facts, const Floaters& floaters, const Field<3>& field,
                       const PointsRef<3>& surface);

}  // namespace seesaw
