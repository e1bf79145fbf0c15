#include "core/editing/recent_files.h"

#include <sstream>

#include "core/base/error.h"
#include "core/base/file.h"

namespace seesaw {

namespace {

/// Another name for the same file is the same name.
std::filesystem::path in_full(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::path full = std::filesystem::weakly_canonical(path, error);
  return error ? path.lexically_normal() : full;
}

}  // namespace

std::filesystem::path state_folder(const char* xdg_state_home, const char* home) {
  const std::filesystem::path state(xdg_state_home ? xdg_state_home : "");
  if (state.is_absolute()) return state / "seesaw";
  const std::filesystem::path own(home ? home : "");
  if (own.is_absolute()) return own / ".local" / "state" / "seesaw";
  return {};
}

RecentFiles::RecentFiles(std::filesystem::path file, std::size_t most) : file_(std::move(file)), most_(most) {
  if (file_.empty()) return;
  try {
    std::istringstream lines(read_file(file_, std::size_t{1} << 20));
    for (std::string line; list_.size() < most_ && std::getline(lines, line);)
      if (!line.empty() && line.find('\0') == std::string::npos) list_.emplace_back(line);
  } catch (const Error&) {
    list_.clear();
  }
}

bool RecentFiles::add(const std::filesystem::path& path) {
  const std::filesystem::path full = in_full(path);
  if (full.string().find('\n') != std::string::npos) return false;
  std::erase(list_, full);
  list_.insert(list_.begin(), full);
  if (list_.size() > most_) list_.resize(most_);
  return write();
}

bool RecentFiles::remove(const std::filesystem::path& path) {
  std::erase(list_, path);
  std::erase(list_, in_full(path));
  return write();
}

bool RecentFiles::write() const {
  if (file_.empty()) return true;
  std::string text;
  for (const std::filesystem::path& each : list_) text += each.string() + "\n";
  std::error_code error;
  std::filesystem::create_directories(file_.parent_path(), error);
  try {
    write_file(file_, text);
  } catch (const Error&) {
    return false;
  }
  return true;
}

}  // namespace seesaw
