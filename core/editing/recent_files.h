// The files that were opened or saved lately, the last one first.
//
// Before it: a folder for the program's state.  After it: a menu.
//
// One path a line in a text file that is written whole or not at all. A list that cannot be read is an empty
// list: it is a convenience, and never a reason not to start.
#pragma once

#include <filesystem>
#include <vector>

namespace seesaw {

/// Where a program keeps its state: $XDG_STATE_HOME/seesaw, or $HOME/.local/state/seesaw (the XDG Base
/// Directory Specification; what is not absolute is ignored). Null for what is not set. Empty where neither
/// is.
std::filesystem::path state_folder(const char* xdg_state_home, const char* home);

class RecentFiles {
 public:
  /// `file` holds the list. Empty for one that is not kept.
  explicit RecentFiles(std::filesystem::path file = {}, std::size_t most = 10);

  const std::vector<std::filesystem::path>& list() const { return list_; }
  /// Makes it the first, and writes the list. False where that is not possible; the list is still right.
  bool add(const std::filesystem::path& path);
  /// For a file that is no longer there.
  bool remove(const std::filesystem::path& path);

 private:
  bool write() const;

  std::filesystem::path file_;
  std::size_t most_;
  std::vector<std::filesystem::path> list_;
};

}  // namespace seesaw
