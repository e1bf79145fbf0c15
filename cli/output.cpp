#include "cli/output.h"

#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <iostream>
#include <utility>

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

Progress percent(std::string doing) {
  if (!::isatty(STDERR_FILENO)) return {};
  using Clock = std::chrono::steady_clock;
  return [doing = std::move(doing), start = Clock::now(), last = -1](double fraction) mutable {
    const int now = static_cast<int>(100 * fraction);
    if (now == last || (last < 0 && (now == 100 || Clock::now() - start < std::chrono::milliseconds(300))))
      return true;
    last = now;
    const std::string line = doing + " " + std::to_string(now) + " %";
    std::cerr << '\r' << (now == 100 ? std::string(line.size(), ' ') + '\r' : line) << std::flush;
    return true;
  };
}

}  // namespace seesaw
