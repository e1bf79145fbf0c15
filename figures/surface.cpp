#include "figures/surface.h"

#include <chrono>

#include "core/scene/document_json.h"

namespace seesaw {

SurfacePointer fit_surface(Constraints<3> constraints, const PolygonizeOptions& options,
                           const FitOptions& fit_options) {
  Fit<3> fitted = fit(constraints, fit_options);
  const auto start = std::chrono::steady_clock::now();
  Polygonization polygons = polygonize(fitted.function, boundary_points(constraints), options);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const MeshReport report = check_mesh(polygons.mesh);
  return std::make_shared<FittedSurface>(
      FittedSurface{std::move(constraints), std::move(fitted), std::move(polygons), report, seconds});
}

Document<3> scene_named(const FigureContext& context, const std::string& name) {
  return read_document<3>(context.scenes / (name + ".json"));
}

void add_mesh_facts(Facts& facts, const MeshReport& report) {
  facts["components"] = report.components;
  facts["euler_characteristic"] = report.euler_characteristic;
  facts["genus"] = report.genus;
  facts["boundary_edges"] = report.boundary_edges;
  facts["area"] = report.area;
  facts["volume"] = report.volume;
  facts["vertices"] = report.vertices;
  facts["faces"] = report.faces;
  facts["smallest_angle_degrees"] = report.smallest_angle;
}

Facts surface_facts(const FittedSurface& surface) {
  Facts facts = fit_facts(surface.fitted.report);
  facts["polygonize_seconds"] = surface.polygonize_seconds;
  add_mesh_facts(facts, surface.report);
  return facts;
}

void check_topology(Figure& figure, const std::string& panel, const MeshReport& report, Index components,
                    Index genus) {
  figure.checks.push_back(equal(panel + ": closed, manifold and oriented",
                                report.closed && report.manifold && report.oriented ? 1 : 0, 1));
  figure.checks.push_back(equal(panel + ": boundary edges", static_cast<double>(report.boundary_edges), 0));
  figure.checks.push_back(
      equal(panel + ": components", static_cast<double>(report.components), static_cast<double>(components)));
  figure.checks.push_back(
      equal(panel + ": genus", static_cast<double>(report.genus), static_cast<double>(genus)));
}

}  // namespace seesaw
