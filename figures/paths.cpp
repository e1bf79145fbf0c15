#include "figures/paths.h"

#include "core/base/file.h"

namespace seesaw {

std::filesystem::path scenes_folder() { return shipped_folder("scenes", SEESAW_FIGURES_DIR); }

std::filesystem::path data_folder() { return shipped_folder("data", SEESAW_FIGURES_DIR); }

std::filesystem::path sessions_folder() { return shipped_folder("sessions", SEESAW_FIGURES_DIR); }

FigureContext figure_context() { return {.scenes = scenes_folder(), .data = data_folder(), .sessions = sessions_folder()}; }

std::filesystem::path reference_folder() { return std::filesystem::path(SEESAW_FIGURES_DIR) / "reference"; }

}  // namespace seesaw
