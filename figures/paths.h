// Where the figures' scenes are: beside an installed program, or in the source tree it was built from.
#pragma once

#include <filesystem>

namespace seesaw {

/// PREFIX/share/seesaw/scenes if the running program is PREFIX/bin/figures, else figures/scenes of the source
/// tree.
std::filesystem::path scenes_folder();

/// figures/reference of the source tree: pictures that tests compare with.
std::filesystem::path reference_folder();

}  // namespace seesaw
