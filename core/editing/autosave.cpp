#include "core/editing/autosave.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>

#include "core/base/error.h"
#include "core/scene/document_json.h"
#include "core/scene/json_text.h"

namespace seesaw {

namespace {

constexpr const char* key_of_origin = "autosave_of";

std::filesystem::path lock_of(std::filesystem::path file) { return file.replace_extension(".lock"); }

/// A JSON string as the reader of documents understands it.
std::string text_of_json(const std::string& json) {
  return parse_document<2>(R"({"seesaw": 1, "dimension": 2, "constraints": [], "title": )" + json + "}")
      .title;
}

std::filesystem::path take_origin(AnyDocument& any) {
  return std::visit(
      [](auto& document) {
        std::filesystem::path of;
        for (const Extra& extra : document.extras)
          if (extra.key == key_of_origin) of = text_of_json(extra.json);
        std::erase_if(document.extras, [](const Extra& extra) { return extra.key == key_of_origin; });
        return of;
      },
      any);
}

/// True where no running program holds the lock.
bool is_abandoned(const std::filesystem::path& lock) {
  const int file = ::open(lock.c_str(), O_RDWR | O_CLOEXEC);
  if (file < 0) return errno == ENOENT;
  const bool held = ::flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(file);
  return !held;
}

}  // namespace

Autosave::Autosave(std::filesystem::path folder, double interval)
    : folder_(std::move(folder)), interval_(interval) {}

Autosave::~Autosave() {
  wait();
  if (lock_ < 0) return;
  if (!there_is_one_) {
    std::error_code error;
    std::filesystem::remove(lock_of(file_), error);
  }
  ::close(lock_);
}

bool Autosave::take_lock() {
  if (lock_ >= 0) return true;
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  std::string name = (folder_ / "autosave-XXXXXX.lock").string();
  lock_ = ::mkostemps(name.data(), 5, O_CLOEXEC);
  if (lock_ < 0) {
    trouble_ = "no autosave: nothing can be written to " + folder_.string() + ": " + std::strerror(errno);
    return false;
  }
  ::flock(lock_, LOCK_EX | LOCK_NB);
  file_ = std::filesystem::path(name).replace_extension(".json");
  return true;
}

void Autosave::collect() {
  if (!writing_.valid()) return;
  trouble_ = writing_.get();
  if (trouble_.empty()) said_.clear();
}

void Autosave::wait() { collect(); }

void Autosave::tick(bool unsaved, std::uint64_t revision, double now, const std::function<Keepsake()>& get) {
  if (folder_.empty()) return;
  if (!unsaved) {
    if (there_is_one_) clear();
    return;
  }
  if (writing_.valid()) {
    if (writing_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    collect();
  }
  if (revision == kept_ || now - last_ < interval_) return;
  last_ = now;
  if (!take_lock()) return;
  kept_ = revision;
  there_is_one_ = true;
  Keepsake keepsake = get();
  std::visit(
      [&](auto& document) {
        document.extras.push_back({key_of_origin, json_string(keepsake.of.string())});
      },
      keepsake.document);
  writing_ = std::async(std::launch::async, [document = std::move(keepsake.document), file = file_] {
    try {
      write_document(file, document);
    } catch (const std::exception& error) {
      return std::string("no autosave: ") + error.what();
    }
    return std::string();
  });
}

void Autosave::clear() {
  wait();
  kept_ = ~std::uint64_t{0};
  last_ = -1e300;
  if (!there_is_one_) return;
  std::error_code error;
  std::filesystem::remove(file_, error);
  there_is_one_ = false;
}

std::string Autosave::trouble() {
  if (trouble_.empty() || trouble_ == said_) return {};
  said_ = trouble_;
  return trouble_;
}

std::vector<Recovered> find_recovered(const std::filesystem::path& folder) {
  std::vector<Recovered> found;
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) files.push_back(entry.path());
  for (const std::filesystem::path& file : files) {
    const std::string name = file.filename().string();
    if (!name.starts_with("autosave-")) continue;
    const std::size_t json = name.find(".json");
    const std::filesystem::path lock = file.parent_path() / (name.substr(0, name.find('.')) + ".lock");
    if (json == std::string::npos || !is_abandoned(lock)) continue;
    if (!name.ends_with(".json")) {
      std::filesystem::remove(file, error);
      continue;
    }
    try {
      Recovered recovered{file, {read_document(file), {}}, std::filesystem::last_write_time(file, error)};
      recovered.kept.of = take_origin(recovered.kept.document);
      found.push_back(std::move(recovered));
    } catch (const Error&) {
      // Left where it is: a person may still want to look at it.
    }
  }
  std::ranges::sort(found, [](const Recovered& a, const Recovered& b) {
    return a.when != b.when ? a.when > b.when : a.file < b.file;
  });
  return found;
}

void discard(const Recovered& recovered) {
  std::error_code error;
  std::filesystem::remove(recovered.file, error);
  std::filesystem::remove(lock_of(recovered.file), error);
}

}  // namespace seesaw
