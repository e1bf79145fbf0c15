#include "sandbox2d/folder_listing.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <ctime>

#include "core/base/error.h"
#include "core/base/text.h"

namespace seesaw {

namespace fs = std::filesystem;

namespace {

bool digit(char c) { return c >= '0' && c <= '9'; }

/// ASCII, and the letters of Latin-1 in UTF-8, whose second byte differs by 32 like those of ASCII.
std::string without_case(std::string_view text) {
  std::string result(text);
  for (std::size_t i = 0; i < result.size(); ++i) {
    const auto c = static_cast<unsigned char>(result[i]);
    const bool latin = i > 0 && static_cast<unsigned char>(result[i - 1]) == 0xC3 && c >= 0x80 && c <= 0x9E &&
                       c != 0x97;  // the sign for "times" has no small letter
    if ((c >= 'A' && c <= 'Z') || latin) result[i] = static_cast<char>(c + 32);
  }
  return result;
}

/// Negative, 0 or positive, as a comes before b.
int natural_order(std::string_view a, std::string_view b) {
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (digit(a[i]) && digit(b[j])) {
      while (i < a.size() && a[i] == '0') ++i;
      while (j < b.size() && b[j] == '0') ++j;
      std::size_t m = i, n = j;
      while (m < a.size() && digit(a[m])) ++m;
      while (n < b.size() && digit(b[n])) ++n;
      if (m - i != n - j) return m - i < n - j ? -1 : 1;
      if (const int order = a.substr(i, m - i).compare(b.substr(j, n - j))) return order;
      i = m, j = n;
    } else {
      const auto x = static_cast<unsigned char>(a[i++]), y = static_cast<unsigned char>(b[j++]);
      if (x != y) return x < y ? -1 : 1;
    }
  }
  return (i < a.size()) - (j < b.size());
}

/// Folders first.
bool entry_less(const FolderEntry& a, const FolderEntry& b) {
  return a.folder != b.folder ? a.folder : natural_less(a.name, b.name);
}

std::string_view without_blanks(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

bool is_folder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

/// "a/b/" and "a/b" are one folder.
fs::path tidy(const fs::path& path) {
  const fs::path normal = path.lexically_normal();
  return normal.has_filename() || normal == normal.root_path() ? normal : normal.parent_path();
}

}  // namespace

bool natural_less(std::string_view a, std::string_view b) {
  const int order = natural_order(without_case(a), without_case(b));
  return order != 0 ? order < 0 : a < b;
}

FolderListing list_folder(const fs::path& folder, const std::vector<FileKind>& kinds) {
  std::error_code error;
  FolderListing listing{tidy(fs::absolute(folder, error))};
  fs::directory_iterator entries(listing.folder, error);
  if (error) throw FileError(listing.folder.string(), "cannot be read: " + error.message());
  for (const fs::directory_iterator end; entries != end; entries.increment(error)) {
    const fs::directory_entry& each = *entries;
    FolderEntry entry{.name = each.path().filename().string()};
    if (entry.name.starts_with('.')) continue;
    std::error_code ignored;
    entry.folder = each.is_directory(ignored);
    if (!entry.folder) {
      if (!each.exists(ignored)) continue;
      if (!kinds.empty() && kind_of(each.path(), kinds) < 0) {
        ++listing.others;
        continue;
      }
      const std::uintmax_t size = each.file_size(ignored);
      entry.size = ignored ? 0 : size;
    }
    entry.changed = each.last_write_time(ignored);
    listing.entries.push_back(std::move(entry));
  }
  if (error) throw FileError(listing.folder.string(), "cannot be read to its end: " + error.message());
  std::sort(listing.entries.begin(), listing.entries.end(), entry_less);
  return listing;
}

fs::path full_path(std::string_view typed, const fs::path& folder, const fs::path& home) {
  typed = without_blanks(typed);
  if (!home.empty() && (typed == "~" || typed.starts_with("~/"))) {
    typed.remove_prefix(typed.size() > 1 ? 2 : 1);
    return tidy(home / fs::path(typed).relative_path());
  }
  return tidy(folder / fs::path(typed));
}

FilePlace place_to_open(std::string_view typed, const fs::path& folder, const fs::path& home,
                        const std::vector<FileKind>& kinds) {
  if (without_blanks(typed).empty()) throw Error("choose a file, or type its name");
  const fs::path path = full_path(typed, folder, home);
  if (is_folder(path)) return {path, true};
  std::error_code error;
  if (fs::exists(path, error)) return {path};
  for (const FileKind& kind : kinds) {
    const fs::path longer = path.string() + kind.ending;
    if (fs::exists(longer, error) && !is_folder(longer)) return {longer};
  }
  if (is_folder(path.parent_path()))
    throw Error("there is no file " + path.filename().string() + " in " + path.parent_path().string());
  throw Error("there is no folder " + path.parent_path().string());
}

FilePlace place_to_save(std::string_view typed, const fs::path& folder, const fs::path& home,
                        const std::vector<FileKind>& kinds, std::size_t chosen) {
  typed = without_blanks(typed);
  if (typed.empty()) throw Error("type a name for the file");
  fs::path path = full_path(typed, folder, home);
  if (is_folder(path)) return {path, true};
  if (typed.ends_with('/')) throw Error("there is no folder " + path.string());
  for (const FileKind& kind : kinds)
    if (path.filename() == kind.ending) throw Error("type a name before " + kind.ending);
  if (kind_of(path, kinds) < 0 && chosen < kinds.size()) path += kinds[chosen].ending;
  if (is_folder(path)) throw Error(path.string() + " is a folder");
  if (!is_folder(path.parent_path())) throw Error("there is no folder " + path.parent_path().string());
  if (::access(path.parent_path().c_str(), W_OK | X_OK) != 0)
    throw Error("nothing may be written in the folder " + path.parent_path().string());
  std::error_code error;
  return {path, false, fs::exists(path, error)};
}

int kind_of(const fs::path& name, const std::vector<FileKind>& kinds) {
  const std::string ending = without_case(name.extension().string());
  for (std::size_t i = 0; i < kinds.size(); ++i)
    if (kinds[i].ending == ending) return static_cast<int>(i);
  return -1;
}

std::string with_kind(const std::string& name, const std::vector<FileKind>& kinds, std::size_t kind) {
  if (name.empty()) return name;
  const int own = kind_of(name, kinds);
  const std::size_t kept =
      own < 0 ? name.size() : name.size() - kinds[static_cast<std::size_t>(own)].ending.size();
  return name.substr(0, kept) + kinds[kind].ending;
}

fs::path make_folder(const fs::path& folder, std::string_view name) {
  name = without_blanks(name);
  if (name.empty()) throw Error("type a name for the folder");
  if (name.find('/') != std::string_view::npos || name == "." || name == "..")
    throw Error("a folder's name has no / in it, and is not a dot or two");
  const fs::path path = folder / fs::path(name);
  std::error_code error;
  if (fs::exists(path, error)) throw Error(std::string(name) + " exists already");
  if (!fs::create_directory(path, error))
    throw FileError(path.string(), "cannot be made: " + error.message());
  return path;
}

fs::path nearest_folder(const fs::path& folder) {
  std::error_code error;
  fs::path path = tidy(fs::absolute(folder, error));
  while (path.has_relative_path()) {
    const fs::directory_iterator readable(path, error);
    if (!error) return path;
    path = path.parent_path();
  }
  return path.empty() ? fs::path("/") : path;
}

std::vector<fs::path> way_to(const fs::path& folder) {
  std::vector<fs::path> way = {folder};
  while (way.back().has_relative_path()) way.push_back(way.back().parent_path());
  std::reverse(way.begin(), way.end());
  return way;
}

std::string size_text(std::uintmax_t bytes) {
  if (bytes < 1000) return std::to_string(bytes) + " B";
  double value = static_cast<double>(bytes);
  const char* unit = "B";
  // What would be rounded to 1000 is 1 of the next.
  for (const char* next : {"kB", "MB", "GB", "TB"}) {
    if (value < 999.5) break;
    value /= 1000;
    unit = next;
  }
  return to_text(value, value < 99.5 ? 2 : 3) + " " + unit;
}

std::string time_text(fs::file_time_type time) {
  const auto system = fs::file_time_type::clock::to_sys(time);
  const std::time_t seconds = std::chrono::floor<std::chrono::seconds>(system).time_since_epoch().count();
  std::tm local{};
  char text[32] = "";
  if (::localtime_r(&seconds, &local)) std::strftime(text, sizeof text, "%Y-%m-%d %H:%M", &local);
  return text;
}

}  // namespace seesaw
