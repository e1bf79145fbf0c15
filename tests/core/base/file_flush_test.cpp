// What is told to go to the disk, and when: this program's fsync writes down what it was called for.
#ifdef __linux__

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/file.h"
#include "tests/support/scratch_folder.h"

namespace {

namespace flushed_fs = std::filesystem;

struct Flushes {
  flushed_fs::path watched;        // what a flush of its folder should find there
  std::vector<std::string> calls;  // "file", or "folder with ..." what `watched` held then
  int folder_error = 0;            // given back for folders
};
Flushes* flushes = nullptr;

}  // namespace

extern "C" int fsync(int file) {
  struct ::stat status = {};
  if (flushes && ::fstat(file, &status) == 0) {
    const bool folder = S_ISDIR(status.st_mode);
    const bool there = flushed_fs::exists(flushes->watched);
    flushes->calls.push_back(
        !folder ? "file" : "folder with " + (there ? seesaw::read_file(flushes->watched) : "none"));
    if (folder && flushes->folder_error != 0) {
      errno = flushes->folder_error;
      return -1;
    }
  }
  return static_cast<int>(::syscall(SYS_fsync, file));
}

namespace seesaw {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class FileFlush : public testing::Test {
 protected:
  void SetUp() override {
    log.watched = folder / "a";
    flushes = &log;
  }
  void TearDown() override {
    flushes = nullptr;
    flushed_fs::permissions(folder, flushed_fs::perms::owner_all);
  }
  ScratchFolder scratch;
  flushed_fs::path folder = scratch.path();
  Flushes log;
};

TEST_F(FileFlush, TheBytesBeforeTheNameAndTheNameAfterwards) {
  write_file(folder / "a", "new");
  EXPECT_THAT(log.calls, ElementsAre("file", "folder with new"));
  log.calls.clear();
  write_file(folder / "a", "newer");
  EXPECT_THAT(log.calls, ElementsAre("file", "folder with newer"));
}

TEST_F(FileFlush, ThroughALinkItIsTheFilesFolder) {
  flushed_fs::create_directory(folder / "far");
  log.watched = folder / "far" / "a";
  write_file(log.watched, "1");
  flushed_fs::create_symlink(log.watched, folder / "link");
  log.calls.clear();
  write_file(folder / "link", "2");
  EXPECT_THAT(log.calls, ElementsAre("file", "folder with 2"));
}

TEST_F(FileFlush, ANameWithoutAFolderIsInTheCurrentOne) {
  const flushed_fs::path before = flushed_fs::current_path();
  flushed_fs::current_path(folder);
  EXPECT_NO_THROW(write_file("a", "here"));
  flushed_fs::current_path(before);
  EXPECT_THAT(log.calls, ElementsAre("file", "folder with here"));
}

TEST_F(FileFlush, AFolderThatCannotBeFlushedIsNoErrorButABadDiskIs) {
  log.folder_error = EINVAL;
  EXPECT_NO_THROW(write_file(folder / "a", "1"));
  log.folder_error = EIO;
  try {
    write_file(folder / "a", "2");
    ADD_FAILURE() << "no error";
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("a: cannot be written: flushing its folder"));
  }
}

TEST_F(FileFlush, AFolderThatCannotBeReadCanBeWrittenTo) {
  flushed_fs::permissions(folder, flushed_fs::perms::owner_write | flushed_fs::perms::owner_exec);
  EXPECT_NO_THROW(write_file(folder / "a", "1"));
  EXPECT_EQ(read_file(folder / "a"), "1");
}

}  // namespace
}  // namespace seesaw

#endif
