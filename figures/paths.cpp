#include "figures/paths.h"

namespace seesaw {

namespace {

std::filesystem::path folder_named(const char* name) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed = program.parent_path().parent_path() / "share/seesaw" / name;
  if (!error && fs::is_directory(installed, error)) return installed;
  return fs::path(SEESAW_FIGURES_DIR) / name;
}

}  // namespace

std::filesystem::path scenes_folder() { return folder_named("scenes"); }

std::filesystem::path data_folder() { return folder_named("data"); }

std::filesystem::path sessions_folder() { return folder_named("sessions"); }

FigureContext figure_context() { return {.scenes = scenes_folder(), .data = data_folder(), .sessions = sessions_folder()}; }

std::filesystem::path reference_folder() { return std::filesystem::path(SEESAW_FIGURES_DIR) / "reference"; }

}  // namespace seesaw
