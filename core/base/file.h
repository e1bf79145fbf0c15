// Whole files in and out. Writing is all or nothing: a crash or a power cut in mid-save leaves the old file
// as it was, and one after it the new file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace seesaw {

/// The bytes of the file. Throws FileError: missing, a folder, unreadable, or larger than `limit` bytes.
std::string read_file(const std::filesystem::path& path, std::size_t limit = std::size_t{1} << 31);

/// Writes a temporary file beside `path`, flushes it to disk, renames it over `path`, then flushes the folder
/// too, so that the name is as safe as the bytes (where the file system can do that). Throws FileError.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// The ending of a file's name with its dot, in lower case: ".png"; empty when it has none.
std::string ending_of(const std::filesystem::path& path);

/// Throws FileError when no file can be made at `path`: its folder is missing, or it is itself a folder.
/// Asked before long work, not after it.
void refuse_unless_writable(const std::filesystem::path& path);

/// A folder that a program reads when it runs: PREFIX/share/seesaw/`name` where the program is PREFIX/bin/...
/// and has one, else `source`/`name`, of the source tree that it was built from.
std::filesystem::path shipped_folder(const std::string& name, const std::filesystem::path& source);

}  // namespace seesaw
