// A dialog to choose a file: to open one, or to say where to save. There is no dialog of the system's that
// every desktop has, so this one is drawn by us, and looks and works the same everywhere.
//
// Before it: a menu's "Open ..." or "Save as ...".  After it: a function that gets the path.
//
//     FileDialog dialog;
//     dialog.set_places({.home = home, .shortcuts = {{"Examples", examples}}, .recent = recent.list()});
//     dialog.ask_save("Export", {{".png", "Picture"}, {".svg", "Drawing"}}, "figures/curve.png",
//                     [&](const auto& path) { export_document(path, ...); });
//     ... each frame, outside of all panels:  dialog.frame();
//
// A click chooses, a double click or Enter opens. The name may be a path, from ~ too, and one of a folder
// enters it. Up, down and the page keys walk through the list while a name is typed. What goes wrong is said
// in the dialog, which stays open; so is what the function throws (Error).
//
// What it knows about files is in sandbox2d/folder_listing.h.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sandbox2d/folder_listing.h"
#include "sandbox2d/message_boxes.h"

namespace seesaw {

/// A folder that can be reached with one click.
struct Shortcut {
  std::string name;
  std::filesystem::path folder;
};

struct FilePlaces {
  std::filesystem::path home;  ///< of ~; empty for none
  std::vector<Shortcut> shortcuts = {};
  std::vector<std::filesystem::path> recent = {};  ///< files, the last used first
};

class FileDialog {
 public:
  using Done = std::function<void(const std::filesystem::path&)>;
  /// Draws further widgets beneath the name; it is told the kind that is chosen.
  using More = std::function<void(const FileKind&)>;

  void set_places(FilePlaces places) { places_ = std::move(places); }

  /// Asks for a file of one of `kinds`. It begins in `folder`, or where the last dialog was left if empty.
  void ask_open(std::string title, std::vector<FileKind> kinds, const std::filesystem::path& folder,
                Done done);
  /// Asks for a file to write. `suggested` is a path or only a name. A file that exists is replaced after a
  /// question only.
  void ask_save(std::string title, std::vector<FileKind> kinds, const std::filesystem::path& suggested,
                Done done, More more = {});

  void frame();
  bool open() const { return open_; }
  void close();
  /// What went wrong last, as it is shown; empty for nothing.
  const std::string& trouble() const { return trouble_; }
  /// Where it is, or was when it was closed.
  const std::filesystem::path& folder() const { return listing_.folder; }

 private:
  enum class Mode { open, save };

  void begin(Mode mode, std::string title, std::vector<FileKind> kinds, Done done);
  /// False where it cannot be read: then says so and stays.
  bool enter(const std::filesystem::path& folder);
  void reload();
  void choose(Index entry);
  void walk();
  void show_name(std::string name);
  void accept();
  void finish(const std::filesystem::path& path);
  void fail(const std::string& what);

  // file_dialog_draw.cpp
  void draw();
  void draw_way();
  void draw_places(double width, double height);
  void draw_list(double height);
  void draw_name();
  void draw_buttons();
  void draw_new_folder();

  FilePlaces places_;
  bool open_ = false;
  long asked_ = 0;     // how often; tells a dialog from the one before it
  std::string shown_;  // the title of what is on the screen, and whose
  long shown_for_ = 0;
  Mode mode_ = Mode::open;
  std::string title_;
  std::vector<FileKind> kinds_;
  Done done_;
  More more_;

  FolderListing listing_;
  Index chosen_ = -1;  // of the entries
  Index reveal_ = -1;  // the entry that the list is scrolled to
  std::string name_;
  long name_shown_ = 0;  // a field that is typed into takes no other text, so a new text is a new field
  bool wants_caret_ = false;
  int kind_ = 0;
  std::string trouble_;

  std::string new_folder_, new_folder_trouble_;
  bool new_folder_caret_ = false;
  Questions questions_;
};

}  // namespace seesaw
