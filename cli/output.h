// What the program hands over on standard output. Files: core/base/file.h.
#pragma once

#include <string_view>

namespace seesaw {

/// Thrown by print() when whoever reads standard output has seen enough: the program ends without a word,
/// status 0.
struct ReaderLeft {};

/// Writes `text` to standard output. Throws ReaderLeft, or FileError (a full disk).
void print(std::string_view text);

}  // namespace seesaw
