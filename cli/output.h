// What the program hands over on standard output, and says meanwhile on a terminal. Files: core/base/file.h.
#pragma once

#include <string>
#include <string_view>

#include "core/base/progress.h"

namespace seesaw {

/// Thrown by print() when whoever reads standard output has seen enough: the program ends without a word,
/// status 0.
struct ReaderLeft {};

/// Writes `text` to standard output. Throws ReaderLeft, or FileError (a full disk).
void print(std::string_view text);

/// "solving 42 %" on standard error, in one line that is wiped when all is done, or empty where that is no
/// terminal. Work of less than a third of a second says nothing.
Progress percent(std::string doing);

}  // namespace seesaw
