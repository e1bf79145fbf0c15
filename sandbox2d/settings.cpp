#include "sandbox2d/settings.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"

namespace seesaw {

namespace {

constexpr std::string_view panel_prefix = "panel.";

std::optional<bool> switch_of(std::string_view text) {
  if (text == "on") return true;
  if (text == "off") return false;
  return {};
}

/// Within the bounds, whatever was there; nothing for what is no number.
std::optional<double> number_of(std::string_view text, double least, double most) {
  const std::optional<double> number = parse_number(text);
  if (!number || !std::isfinite(*number)) return {};
  return std::clamp(*number, least, most);
}

const char* word_of(bool on) { return on ? "on" : "off"; }

/// False for a name that is not known.
bool take_setting(Settings& settings, std::string_view name, std::string_view value) {
  const auto number = [&](double least, double most, auto& to) {
    using To = std::remove_reference_t<decltype(to)>;
    if (const auto read = number_of(value, least, most)) to = static_cast<To>(*read);
  };
  const auto on_or_off = [&](bool& to) { to = switch_of(value).value_or(to); };
  if (name == "scale")
    number(0.5, 4, settings.scale);
  else if (name == "dark")
    on_or_off(settings.dark);
  else if (name == "window_width")
    number(320, 16384, settings.window_width);
  else if (name == "window_height")
    number(320, 16384, settings.window_height);
  else if (name == "tour_seen")
    on_or_off(settings.tour_seen);
  else if (name == "last_folder")
    settings.last_folder = std::string(value);
  else if (name.starts_with(panel_prefix) && name.size() > panel_prefix.size()) {
    if (const auto shown = switch_of(value))
      settings.panels[std::string(name.substr(panel_prefix.size()))] = *shown;
  } else
    return false;
  return true;
}

}  // namespace

std::string settings_text(const Settings& settings, const std::vector<std::string>& unknown) {
  std::string text;
  const auto line = [&](const std::string& name, const std::string& value) {
    // A line feed would begin another setting.
    if ((name + value).find('\n') == std::string::npos) text += name + " " + value + "\n";
  };
  line("scale", to_text(settings.scale, 17));
  line("dark", word_of(settings.dark));
  line("window_width", std::to_string(settings.window_width));
  line("window_height", std::to_string(settings.window_height));
  line("tour_seen", word_of(settings.tour_seen));
  if (!settings.last_folder.empty()) line("last_folder", settings.last_folder.string());
  for (const auto& [name, shown] : settings.panels) line(std::string(panel_prefix) + name, word_of(shown));
  for (const std::string& each : unknown) text += each + "\n";
  return text;
}

Settings parse_settings(std::string_view text, std::vector<std::string>* unknown) {
  Settings settings;
  if (text.find('\0') != std::string_view::npos) return settings;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty()) continue;
    const std::size_t blank = std::min(line.find(' '), line.size());
    const std::string_view value = line.substr(std::min(blank + 1, line.size()));
    if (!take_setting(settings, line.substr(0, blank), value) && unknown) unknown->emplace_back(line);
  }
  return settings;
}

SettingsFile::SettingsFile(std::filesystem::path file) : file_(std::move(file)) {
  if (file_.empty()) return;
  try {
    settings_ = parse_settings(read_file(file_, std::size_t{1} << 20), &unknown_);
  } catch (const Error&) {
    settings_ = {};
  }
}

bool SettingsFile::keep(const Settings& settings) {
  if (settings == settings_) return true;
  settings_ = settings;
  if (file_.empty()) return true;
  std::error_code error;
  std::filesystem::create_directories(file_.parent_path(), error);
  try {
    write_file(file_, settings_text(settings, unknown_));
  } catch (const Error&) {
    return false;
  }
  return true;
}

}  // namespace seesaw
