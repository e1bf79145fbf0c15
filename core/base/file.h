// Whole files in and out. Writing is all or nothing: a crash in mid-save leaves the old file as it was.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace seesaw {

/// The bytes of the file. Throws FileError: missing, a folder, unreadable, or larger than `limit` bytes.
std::string read_file(const std::filesystem::path& path, std::size_t limit = std::size_t{1} << 31);

/// Writes a temporary file beside `path`, flushes it to disk, then renames it over `path`. Throws FileError.
void write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace seesaw
