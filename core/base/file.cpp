#include "core/base/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "core/base/error.h"

namespace seesaw {

namespace fs = std::filesystem;

namespace {

// A rename is an entry in a folder, and that is in memory like everything else until it is told to go to the
// disk. False, with errno, where the disk failed; not every file system and not every folder can be told.
bool flush_folder(const fs::path& folder) {
  const int file = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) return true;
  const bool flushed = ::fsync(file) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS;
  const int why = errno;
  ::close(file);
  errno = why;
  return flushed;
}

}  // namespace

std::string read_file(const fs::path& path, std::size_t limit) {
  std::error_code error;
  if (!fs::exists(path, error)) throw FileError(path.string(), "no such file");
  if (fs::is_directory(path, error)) throw FileError(path.string(), "is a folder, not a file");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw FileError(path.string(), std::string("cannot be read: ") + std::strerror(errno));
  // Read in blocks and not by the size that the file system claims: pipes and /dev/stdin have none.
  std::string bytes;
  std::string block(std::size_t{1} << 16, '\0');
  while (in) {
    in.read(block.data(), static_cast<std::streamsize>(block.size()));
    bytes.append(block, 0, static_cast<std::size_t>(in.gcount()));
    if (bytes.size() > limit)
      throw FileError(path.string(), "is larger than the " + std::to_string(limit) + " bytes that are read");
  }
  return bytes;
}

void write_file(const fs::path& path, std::string_view bytes) {
  const auto fail = [&](const std::string& what) {
    throw FileError(path.string(), "cannot be written: " + what + ": " + std::strerror(errno));
  };
  std::error_code error;
  // A pipe or /dev/stdout cannot be replaced by a rename: write to it as it stands.
  if (fs::exists(path, error) && !fs::is_regular_file(path, error)) {
    std::ofstream out(path, std::ios::binary);
    if (!out.write(bytes.data(), static_cast<std::streamsize>(bytes.size())).flush())
      fail("it is not a file");
    return;
  }
  // Through a symbolic link, so that saving keeps the link.
  const fs::path target = fs::is_symlink(path, error) ? fs::weakly_canonical(path, error) : path;
  std::string temporary = target.string() + ".XXXXXX";
  const int file = ::mkstemp(temporary.data());
  if (file < 0) fail("no file can be made in its folder");
  const auto give_up = [&](const char* what) {
    const int why = errno;
    ::close(file);
    ::unlink(temporary.c_str());
    errno = why;
    fail(what);
  };
  for (std::size_t done = 0; done < bytes.size();) {
    const ::ssize_t n = ::write(file, bytes.data() + done, bytes.size() - done);
    if (n < 0 && errno != EINTR) give_up("writing");
    if (n > 0) done += static_cast<std::size_t>(n);
  }
  // mkstemp makes a private file; give it the permissions a new file would have, or the old one's.
  const ::mode_t mask = ::umask(0);
  ::umask(mask);
  const fs::perms kept = fs::exists(target, error) ? fs::status(target, error).permissions()
                                                   : static_cast<fs::perms>(0666 & ~mask);
  fs::permissions(temporary, kept, error);
  if (::fsync(file) != 0) give_up("flushing");
  const auto give_up_closed = [&](const char* what) {
    const int why = errno;
    ::unlink(temporary.c_str());
    errno = why;
    fail(what);
  };
  if (::close(file) != 0) give_up_closed("closing");
  if (::rename(temporary.c_str(), target.c_str()) != 0) give_up_closed("renaming");
  if (!flush_folder(target.parent_path())) fail("flushing its folder");
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

fs::path shipped_folder(const std::string& name, const fs::path& source) {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed = program.parent_path().parent_path() / "share/seesaw" / name;
  return !error && fs::is_directory(installed, error) ? installed : source / name;
}

}  // namespace seesaw
