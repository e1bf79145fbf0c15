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

}  // namespace seesaw
