#include "cli/output.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "core/base/error.h"

namespace seesaw {

namespace fs = std::filesystem;

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

std::string ending_of(const fs::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return ending;
}

void refuse_unless_writable(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) throw FileError(path.string(), "is a folder, not a file");
  const fs::path folder = path.parent_path();
  if (folder.empty() || fs::is_directory(folder, error)) return;
  throw FileError(path.string(), "cannot be written: " + (fs::exists(folder, error)
                                                              ? folder.string() + " is a file, not a folder"
                                                              : "there is no folder " + folder.string()));
}

}  // namespace seesaw
