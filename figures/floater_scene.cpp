#include "figures/floater_scene.h"

#include "figures/facts.h"

namespace seesaw {

namespace {

// Over sigma: neighbors at rest are about 1.9 sigma apart.
constexpr double disc_size = 0.9;

DiscsObject chosen(const Discs& all, const std::vector<Index>& which, const Color& color) {
  return {.centers = all.centers(Eigen::all, which),
          .normals = all.normals(Eigen::all, which),
          .radii = all.radii(which),
          .material = {.color = color}};
}

Point<3> outward(const Field<3>& field, const Point<3>& at) {
  const Point<3> gradient = field.gradient(at);
  return gradient.norm() > 0 ? Point<3>(-gradient.normalized()) : Point<3>::UnitY();
}

}  // namespace

DiscsObject floater_discs(const Floaters& floaters, const Color& color) {
  const Discs discs = floaters.discs(disc_size);
  return {
      .centers = discs.centers, .normals = discs.normals, .radii = discs.radii, .material = {.color = color}};
}

std::vector<DiscsObject> floater_discs_by_radius(const Floaters& floaters, double wide) {
  const Discs discs = floaters.discs(disc_size);
  std::vector<Index> usual, settlers;
  for (Index i = 0; i < floaters.size(); ++i) (floaters.radii()[i] > wide ? settlers : usual).push_back(i);
  return {chosen(discs, usual, surface::blue), chosen(discs, settlers, surface::sand)};
}

DiscsObject facing(const DiscsObject& discs, const Point<3>& eye) {
  std::vector<Index> which;
  for (Index i = 0; i < discs.radii.size(); ++i)
    if (discs.normals.col(i).dot(eye - discs.centers.col(i)) > 0) which.push_back(i);
  return {.centers = discs.centers(Eigen::all, which),
          .normals = discs.normals(Eigen::all, which),
          .radii = discs.radii(which),
          .material = discs.material};
}

void add_discs(Scene& scene, const Field<3>& field, const PointsRef<3>& points, double radius,
               const Point<3>& eye, const Color& color) {
  for (Index i = 0; i < points.cols(); ++i) {
    const Point<3> at = points.col(i), normal = outward(field, at);
    if (!(normal.dot(eye - at) > 0)) continue;
    const double thickness = 0.35 * radius;
    scene.meshes.push_back({.mesh = disc_mesh(at - 0.3 * thickness * normal, normal, radius, thickness),
                            .material = {.color = color}});
  }
}

void add_constraint_discs(Scene& scene, const Field<3>& field, const Constraints<3>& constraints,
                          double radius, const Point<3>& eye) {
  for (const Constraint<3>& constraint : constraints) {
    if (constraint.kind != ConstraintKind::boundary) continue;
    add_discs(scene, field, constraint.at, radius, eye);
    if (!constraint.normal) continue;
    const Point<3> direction = constraint.normal->direction.normalized();
    scene.meshes.push_back(
        {.mesh = spike_mesh(constraint.at, constraint.at + 4.5 * radius * direction, 0.16 * radius),
         .material = {.color = surface::marker}});
  }
}

void add_floater_facts(Facts& facts, const Floaters& floaters, const Field<3>& field,
                       const PointsRef<3>& surface) {
  const FloaterMeasures measures = measure(floaters, field);
  facts["floaters"] = measures.floaters;
  facts["neighbor_distance"] = {{"mean", measures.spacing.mean},
                                {"least", measures.spacing.least},
                                {"variation", measures.spacing.variation}};
  facts["largest_gap"] = largest_gap(floaters.positions(), surface);
  facts["mean_radius"] = measures.mean_radius;
  facts["most_off_surface"] = measures.most_off;
  facts["births"] = measures.counts.births;
  facts["deaths"] = measures.counts.deaths;
  facts["lost"] = measures.counts.lost;
}

}  // namespace seesaw
