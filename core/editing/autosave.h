// What is not saved yet survives a crash: a copy of it is kept in a folder for the program's state.
//
// Before it: an editor whose document has changed.  After it: the next start finds what is left of a program
// that is no longer there, and offers it.
//
//     Autosave autosave(state_folder(...) / "autosave");
//     ... each frame: autosave.tick(desk.unsaved(), desk.revision(), now, [&] { return ...; });
//     ... saved, or thrown away on purpose: autosave.clear();
//
// A copy is a document like any other, with one more key that says of which file it is. It is written whole
// or not at all, by a thread of its own. Beside it stands a lock that the system takes away when the program
// ends, however it ends: that is how the copy of a crash is told from that of a program still running.
#pragma once

#include <filesystem>
#include <functional>
#include <future>
#include <string>
#include <vector>

#include "core/scene/document.h"

namespace seesaw {

/// What is to be kept: the document, and the file that it is of; empty for none.
struct Keepsake {
  AnyDocument document;
  std::filesystem::path of;
};

class Autosave {
 public:
  /// The folder is made when there is something to keep. `interval` is the shortest time between two copies,
  /// seconds. An empty folder keeps nothing.
  explicit Autosave(std::filesystem::path folder, double interval = 5);
  /// Waits for what is being written. The copy stays: where nothing is to be kept, call clear() before.
  ~Autosave();
  Autosave(const Autosave&) = delete;
  Autosave& operator=(const Autosave&) = delete;

  /// Keeps a copy where the document is unsaved, has changed since the last one, and it is time; drops it
  /// where everything is saved. `now` in seconds, never less than before. `get` is asked only when needed.
  void tick(bool unsaved, std::uint64_t revision, double now, const std::function<Keepsake()>& get);
  /// Nothing is to be kept (any more).
  void clear();
  /// Until what is being written is written.
  void wait();

  /// The copy's file; empty before there was one.
  const std::filesystem::path& file() const { return file_; }
  /// What went wrong, said once; empty for nothing.
  std::string trouble();

 private:
  bool take_lock();
  void collect();

  std::filesystem::path folder_, file_;
  double interval_;
  int lock_ = -1;
  double last_ = -1e300;
  std::uint64_t kept_ = ~std::uint64_t{0};
  bool there_is_one_ = false;
  std::future<std::string> writing_;
  std::string trouble_, said_;
};

/// A copy that a program left behind which is no longer there.
struct Recovered {
  std::filesystem::path file;
  Keepsake kept;
  std::filesystem::file_time_type when = {};
};

/// The newest first. Copies of programs that are still running are not among them, nor what cannot be read;
/// pieces of copies that were never finished are removed.
std::vector<Recovered> find_recovered(const std::filesystem::path& folder);
/// When it was taken over and saved, or is not wanted.
void discard(const Recovered& recovered);

}  // namespace seesaw
