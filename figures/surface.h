// A surface made for a figure: fitted, polygonized, measured. What most 3D figures consist of.
//
// Before it: constraints, from a scene file or from core/modelling.  After it: figures/studio.h, which makes
// its picture.
#pragma once

#include <memory>

#include "core/mesh/mesh_check.h"
#include "core/polygonize/polygonize.h"
#include "core/rbf/fit.h"
#include "core/scene/document.h"
#include "figures/facts.h"
#include "figures/figure.h"

namespace seesaw {

struct FittedSurface {
  Constraints<3> constraints;
  Fit<3> fitted;
  Polygonization polygons;
  MeshReport report;          ///< of polygons.mesh
  double polygonize_seconds;  ///< wall time

  const Interpolant<3>& function() const { return fitted.function; }
};
using SurfacePointer = std::shared_ptr<const FittedSurface>;

/// Fits and polygonizes, `cells` along the longest side of the function's box.
SurfacePointer fit_surface(Constraints<3> constraints, const PolygonizeOptions& options = {},
                           const FitOptions& fit_options = {});
/// The scene `name`.json of the context's folder. Throws FileError.
Document<3> scene_named(const FigureContext& context, const std::string& name);

/// Adds components, euler_characteristic, genus, boundary_edges, area, volume and the like.
void add_mesh_facts(Facts& facts, const MeshReport& report);
/// Facts of fit and surface.
Facts surface_facts(const FittedSurface& surface);

/// Adds the checks that every closed surface is held to: closed, manifold, oriented, so many components, that
/// genus.
void check_topology(Figure& figure, const std::string& panel, const MeshReport& report, Index components,
                    Index genus);

}  // namespace seesaw
