// A panel made from a scene file: fit it, draw it, measure its curve. What most 2D figures consist of.
#pragma once

#include <memory>

#include "core/scene/picture.h"
#include "figures/facts.h"
#include "figures/figure.h"

namespace seesaw {

/// A scene with its function and its curve. Shared, because panels are drawn after the figure was made.
struct FittedScene {
  Document<2> document;
  Fit<2> fitted;
  Box<2> view;
  Contour curve;  ///< in `view`, finely

  const Interpolant<2>& function() const { return fitted.function; }
};
using ScenePointer = std::shared_ptr<const FittedScene>;

ScenePointer fit_scene(Document<2> document);
/// The scene `name`.json of the context's folder. Throws FileError.
ScenePointer fit_scene_file(const FigureContext& context, const std::string& name);

/// The panel that shows it, with facts of fit and curve.
Panel scene_panel(const ScenePointer& scene, const std::string& name, const std::string& title,
                  const PictureOptions& options = {});

}  // namespace seesaw
