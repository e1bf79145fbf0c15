// What the program hands over: text on standard output, or a file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace seesaw {

/// Thrown by print() when whoever reads standard output has seen enough: the program ends without a word,
/// status 0.
struct ReaderLeft {};

/// Writes `text` to standard output. Throws ReaderLeft, or FileError (a full disk).
void print(std::string_view text);

/// The ending of a file's name with its dot, in lower case: ".png"; empty when it has none.
std::string ending_of(const std::filesystem::path& path);

/// Throws FileError when no file can be made at `path`: its folder is missing, or it is itself a folder.
/// Asked before long work, not after it.
void refuse_unless_writable(const std::filesystem::path& path);

}  // namespace seesaw
