// What the program remembers from one run to the next: how large its letters are, which panels are shown.
//
// Before it: a file in the program's state folder (core/editing/recent_files.h).  After it: the window.
//
//     SettingsFile file(folder / "sandbox2d.settings");
//     Settings settings = file.settings();
//     window.set_scale(settings.scale);
//     ...
//     settings.dark = true;
//     file.keep(settings);    // as often as one likes: writes where something has changed
//
// One "name value" a line; a value reaches to the end of its line. Lines of names that are not known, of a
// later version perhaps, are kept. A value that makes no sense is the usual one, a file that is no text is
// the usual settings: they are a convenience, and never a reason not to start.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace seesaw {

struct Settings {
  double scale = 1;  ///< of letters and panels, 0.5 to 4
  bool dark = false;
  int window_width = 1280, window_height = 800;  ///< logical pixels, 320 to 16384
  bool tour_seen = false;
  std::filesystem::path last_folder = {};  ///< of the file dialog; empty for none
  /// Whether a panel is shown, by a name without blanks; those that were never shut or opened are not here.
  std::map<std::string, bool> panels = {};

  bool shows(const std::string& panel, bool otherwise = true) const {
    const auto found = panels.find(panel);
    return found == panels.end() ? otherwise : found->second;
  }
  bool operator==(const Settings&) const = default;
};

/// The text of a file that holds the settings, and the lines of it that are not known.
std::string settings_text(const Settings& settings, const std::vector<std::string>& unknown = {});
/// Whatever the text is. Lines of unknown names are added to `unknown`.
Settings parse_settings(std::string_view text, std::vector<std::string>* unknown = nullptr);

class SettingsFile {
 public:
  /// Empty for settings that are not kept.
  explicit SettingsFile(std::filesystem::path file = {});

  const Settings& settings() const { return settings_; }
  /// False where they cannot be written: then not again until they change.
  bool keep(const Settings& settings);

 private:
  std::filesystem::path file_;
  Settings settings_;
  std::vector<std::string> unknown_;
};

}  // namespace seesaw
