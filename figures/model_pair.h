// A polygon model beside the surface that interpolates its vertices: Figures 3 and 6 of Turk & O'Brien 2002.
#pragma once

#include "figures/studio.h"
#include "figures/surface.h"

namespace seesaw {

struct ModelPair {
  TriangleMesh model;  ///< scaled to the unit cube, closed
  SurfacePointer surface;
};

/// A boundary and a normal constraint for each of the model's vertices; adds the two panels "left" and
/// "right", their facts, and the checks that both figures share. `framing` decides where both are seen from.
ModelPair add_model_pair(Figure& figure, const FigureContext& context, TriangleMesh model, const Color& color,
                         const Framing& framing);

}  // namespace seesaw
