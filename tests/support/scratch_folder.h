// A folder of a test's own, gone when it ends.
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "core/base/file.h"

namespace seesaw {

/// Its name is nobody else's, so that any number of runs may go at once. Where the environment has
/// SEESAW_KEEP it stays, for a person to look at the pictures in it.
class ScratchFolder {
 public:
  ScratchFolder() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string("seesaw_") + test->test_suite_name() + "_" + test->name() + "_XXXXXX";
    for (char& c : name)
      if (c == '/') c = '_';  // of tests with parameters
    name = (std::filesystem::path(::testing::TempDir()) / name).string();
    if (!::mkdtemp(name.data())) throw std::runtime_error("no folder can be made: " + name);
    path_ = name;
  }
  ~ScratchFolder() {
    if (std::getenv("SEESAW_KEEP")) return;
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::filesystem::path& name) const { return path_ / name; }
  /// A file there, its folder too.
  std::filesystem::path with(const std::string& name, const std::string& bytes = "bytes") const {
    std::filesystem::create_directories((path_ / name).parent_path());
    write_file(path_ / name, bytes);
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

/// Where a test that fails leaves a picture for a person.
inline std::filesystem::path picture_to_look_at(const std::string& name) {
  return std::filesystem::path(::testing::TempDir()) / ("seesaw_" + std::to_string(::getpid()) + "_" + name);
}

}  // namespace seesaw
