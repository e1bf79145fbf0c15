#include "figures/paths.h"

namespace seesaw {

std::filesystem::path scenes_folder() {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed = program.parent_path().parent_path() / "share/seesaw/scenes";
  if (!error && fs::is_directory(installed, error)) return installed;
  return fs::path(SEESAW_FIGURES_DIR) / "scenes";
}

std::filesystem::path reference_folder() { return std::filesystem::path(SEESAW_FIGURES_DIR) / "reference"; }

}  // namespace seesaw
