// The errors a user can cause: each says what is wrong, where, and what to do.
#pragma once

#include <stdexcept>
#include <string>

namespace seesaw {

/// Anything Seesaw refuses; `what()` is one sentence fit to show to a person.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Trouble with a file: `what()` reads "path:line: message", or "path: message" where no line can be blamed.
class FileError : public Error {
 public:
  FileError(const std::string& path, int line, const std::string& message)
      : Error(path + (line > 0 ? ":" + std::to_string(line) : "") + ": " + message),
        path_(path),
        line_(line) {}
  FileError(const std::string& path, const std::string& message) : FileError(path, 0, message) {}

  const std::string& path() const { return path_; }
  /// Counted from 1; 0 where no line can be blamed.
  int line() const { return line_; }

 private:
  std::string path_;
  int line_;
};

/// Long work that was asked to stop (core/base/progress.h).
class Cancelled : public Error {
 public:
  Cancelled() : Error("cancelled") {}
};

}  // namespace seesaw
