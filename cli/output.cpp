#include "cli/output.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "core/base/error.h"

namespace seesaw {

void print(std::string_view text) {
  while (!text.empty()) {
    const ::ssize_t n = ::write(STDOUT_FILENO, text.data(), text.size());
    if (n >= 0) {
      text.remove_prefix(static_cast<std::size_t>(n));
    } else if (errno == EPIPE) {
      throw ReaderLeft();
    } else if (errno != EINTR) {
      throw FileError("standard output", std::string("cannot be written: ") + std::strerror(errno));
    }
  }
}

}  // namespace seesaw
