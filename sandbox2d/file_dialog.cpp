#include "sandbox2d/file_dialog.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/window/ui.h"

namespace seesaw {

namespace fs = std::filesystem;

void FileDialog::begin(Mode mode, std::string title, std::vector<FileKind> kinds, Done done) {
  open_ = true;
  ++asked_;
  mode_ = mode;
  title_ = std::move(title);
  kinds_ = std::move(kinds);
  done_ = std::move(done);
  more_ = {};
  kind_ = 0;
  trouble_.clear();
  questions_.clear();
  show_name({});
}

void FileDialog::ask_open(std::string title, std::vector<FileKind> kinds, const fs::path& folder, Done done) {
  begin(Mode::open, std::move(title), std::move(kinds), std::move(done));
  const fs::path wanted = !folder.empty()            ? folder
                          : !listing_.folder.empty() ? listing_.folder
                                                     : places_.home;
  enter(nearest_folder(wanted.empty() ? fs::path(".") : wanted));
}

void FileDialog::ask_save(std::string title, std::vector<FileKind> kinds, const fs::path& suggested,
                          Done done, More more) {
  begin(Mode::save, std::move(title), std::move(kinds), std::move(done));
  more_ = std::move(more);
  const fs::path wanted = suggested.has_parent_path() ? suggested.parent_path()
                          : !listing_.folder.empty()  ? listing_.folder
                                                      : places_.home;
  enter(nearest_folder(wanted.empty() ? fs::path(".") : wanted));
  kind_ = std::max(0, kind_of(suggested, kinds_));
  show_name(suggested.filename().string());
}

void FileDialog::close() {
  open_ = false;
  done_ = {};
  more_ = {};
  questions_.clear();
}

bool FileDialog::enter(const fs::path& folder) {
  try {
    listing_ = list_folder(folder, kinds_);
    trouble_.clear();
  } catch (const Error& error) {
    fail(error.what());
    return false;
  }
  chosen_ = -1;
  reveal_ = 0;
  if (mode_ == Mode::open)
    show_name({});
  else
    show_name(fs::path(name_).filename().string());
  return true;
}

void FileDialog::reload() {
  const std::string chosen =
      chosen_ < 0 ? std::string() : listing_.entries[static_cast<std::size_t>(chosen_)].name;
  const std::string name = name_;
  if (!enter(listing_.folder)) return;
  show_name(name);
  for (std::size_t i = 0; i < listing_.entries.size(); ++i)
    if (!chosen.empty() && listing_.entries[i].name == chosen) chosen_ = reveal_ = static_cast<Index>(i);
}

void FileDialog::show_name(std::string name) {
  name_ = std::move(name);
  ++name_shown_;
  wants_caret_ = true;
}

void FileDialog::choose(Index entry) {
  chosen_ = entry;
  trouble_.clear();
  const FolderEntry& each = listing_.entries[static_cast<std::size_t>(entry)];
  if (!each.folder) {
    show_name(each.name);
    kind_ = std::max(kind_of(each.name, kinds_), 0);
  } else if (mode_ == Mode::open) {
    show_name({});
  }
}

/// The arrows move through the list whoever has the caret: one line of text has no use for them.
void FileDialog::walk() {
  const Index count = static_cast<Index>(listing_.entries.size());
  if (count == 0) return;
  Index to = chosen_;
  if (ui::key_pressed(Key::down, true)) to = chosen_ + 1;
  if (ui::key_pressed(Key::up, true)) to = chosen_ < 0 ? count - 1 : chosen_ - 1;
  if (ui::key_pressed(Key::page_down, true)) to = chosen_ + 10;
  if (ui::key_pressed(Key::page_up, true)) to = chosen_ - 10;
  to = std::clamp<Index>(to, to == chosen_ ? -1 : 0, count - 1);
  if (to == chosen_) return;
  choose(to);
  reveal_ = to;
}

void FileDialog::accept() {
  trouble_.clear();
  try {
    if (chosen_ >= 0 && listing_.entries[static_cast<std::size_t>(chosen_)].folder) {
      enter(listing_.folder / listing_.entries[static_cast<std::size_t>(chosen_)].name);
      return;
    }
    const FilePlace place = mode_ == Mode::open ? place_to_open(name_, listing_.folder, places_.home, kinds_)
                                                : place_to_save(name_, listing_.folder, places_.home, kinds_,
                                                                static_cast<std::size_t>(kind_));
    if (place.folder) {
      name_.clear();
      enter(place.path);
    } else if (mode_ == Mode::save && place.exists) {
      questions_.ask({"Replace the file?",
                      place.path.filename().string() + " exists already in " +
                          place.path.parent_path().string() + ". What it holds will be lost.",
                      {{"Replace", [this, path = place.path] { finish(path); }}, {"Keep"}}});
    } else {
      finish(place.path);
    }
  } catch (const Error& error) {
    fail(error.what());
  }
}

void FileDialog::fail(const std::string& what) {
  trouble_ = what;
  wants_caret_ = true;
}

void FileDialog::finish(const fs::path& path) {
  const long mine = asked_;
  // It may ask for the next file, which is then open and must stay so.
  const Done done = done_;
  try {
    if (done) done(path);
    if (asked_ == mine) close();
  } catch (const Error& error) {
    if (asked_ == mine) fail(error.what());
  }
}

}  // namespace seesaw
