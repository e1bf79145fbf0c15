// What a folder shows to a person who looks for a file in it, and what the name that they type means. The
// thinking half of the file dialog; it draws nothing.
//
// Before it: a folder, the kinds of files that are wanted.  After it: sandbox2d/file_dialog.h.
//
//     const FolderListing listing = list_folder("figures/scenes", {{".json", "Scene"}});
//     // folders first, then files; fig2 before fig10; no hidden ones
//     const FilePlace place = place_to_save("~/curve", listing.folder, home, kinds, 0);
//     // place.path is /home/ada/curve.json
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace seesaw {

/// A kind of file by its ending with the dot, in lower case, and what a person calls it: {".png", "Picture"}.
struct FileKind {
  std::string ending;
  std::string name;
};

struct FolderEntry {
  std::string name;
  bool folder = false;
  std::uintmax_t size = 0;  ///< bytes
  std::filesystem::file_time_type changed = {};
};

struct FolderListing {
  std::filesystem::path folder;  ///< in full
  /// Folders, then files, each in natural order.
  std::vector<FolderEntry> entries = {};
  /// Files that are none of the wanted kinds, and are left out.
  std::size_t others = 0;
};

/// The folders in `folder`, and the files whose ending is of one of `kinds`, in letters of any case; all
/// files where there are no kinds. Names that begin with a dot are left out, links to nothing too. Throws
/// FileError where it cannot be read.
FolderListing list_folder(const std::filesystem::path& folder, const std::vector<FileKind>& kinds);

/// Whether a name comes before another: numbers in them by their value, small and capital letters (of Latin,
/// umlauts too) as one. Names that are equal so far in the order of their bytes: a strict order.
bool natural_less(std::string_view a, std::string_view b);

/// The path in full that is meant by what was typed in `folder`: relative to it, absolute, or from `home` by
/// ~. Blanks around it do not count.
std::filesystem::path full_path(std::string_view typed, const std::filesystem::path& folder,
                                const std::filesystem::path& home);

/// Where the typed name leads: to a folder that can be entered, or to a file.
struct FilePlace {
  std::filesystem::path path;
  bool folder = false;
  bool exists = true;  ///< of a file to save: it will be replaced
};

/// A file to open, or a folder to enter. The ending may be left out. Throws Error, in words, where there is
/// no such file.
FilePlace place_to_open(std::string_view typed, const std::filesystem::path& folder,
                        const std::filesystem::path& home, const std::vector<FileKind>& kinds);

/// A file to save to, or a folder to enter. A name without one of the endings gets that of `kinds[chosen]`.
/// Throws Error where the name is empty, its folder is missing, or nothing may be written there.
FilePlace place_to_save(std::string_view typed, const std::filesystem::path& folder,
                        const std::filesystem::path& home, const std::vector<FileKind>& kinds,
                        std::size_t chosen);

/// The kind whose ending the name has, -1 for none.
int kind_of(const std::filesystem::path& name, const std::vector<FileKind>& kinds);
/// The name with the ending of `kind`, in the place of its own where that is of one of `kinds`.
std::string with_kind(const std::string& name, const std::vector<FileKind>& kinds, std::size_t kind);

/// Makes a folder in `folder`, and returns its path. Throws Error.
std::filesystem::path make_folder(const std::filesystem::path& folder, std::string_view name);

/// The nearest folder on the way up from `folder` that can be read; the root where there is none.
std::filesystem::path nearest_folder(const std::filesystem::path& folder);

/// The folders from the root to `folder`, for a line to click on.
std::vector<std::filesystem::path> way_to(const std::filesystem::path& folder);

/// "312 B", "4.1 kB", "12 MB": thousands, not 1024.
std::string size_text(std::uintmax_t bytes);
/// "2026-03-01 14:05", local time.
std::string time_text(std::filesystem::file_time_type time);

}  // namespace seesaw
