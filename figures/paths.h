// Where the figures' scenes, models and sessions are: beside an installed program, or in the source tree it was built
// from.
#pragma once

#include <filesystem>

#include "figures/figure.h"

namespace seesaw {

/// PREFIX/share/seesaw/scenes if the running program is PREFIX/bin/figures, else figures/scenes of the source
/// tree.
std::filesystem::path scenes_folder();
/// Likewise share/seesaw/data or figures/data.
std::filesystem::path data_folder();
/// Likewise share/seesaw/sessions or figures/sessions.
std::filesystem::path sessions_folder();
/// What a figure is given when nobody listens to its progress.
FigureContext figure_context();

/// figures/reference of the source tree: pictures that tests compare with.
std::filesystem::path reference_folder();

}  // namespace seesaw
