// How the file dialog looks.
#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/window/ui.h"
#include "sandbox2d/file_dialog.h"

namespace seesaw {

namespace fs = std::filesystem;

namespace {

constexpr const char* new_folder_title = "New folder";

std::string part_name(const fs::path& folder) {
  return folder.has_relative_path() ? folder.filename().string() : folder.string();
}

/// The folders of recent files, each once.
std::vector<fs::path> folders_of(const std::vector<fs::path>& files) {
  std::vector<fs::path> folders;
  for (const fs::path& file : files)
    if (std::find(folders.begin(), folders.end(), file.parent_path()) == folders.end())
      folders.push_back(file.parent_path());
  return folders;
}

}  // namespace

void FileDialog::frame() {
  if (!shown_.empty() && (!open_ || shown_for_ != asked_)) {
    // Closed by the program, or asked for something else.
    if (const auto dialog = ui::dialog(shown_, 0, false)) ui::close_dialog();
    shown_.clear();
  }
  if (!open_) return;
  const double width = std::min(800 * ui::scale(), ui::window_width() - 32);
  if (const auto dialog = ui::dialog(title_, width, false)) {
    shown_ = title_;
    shown_for_ = asked_;
    draw();
    if (open_ && shown_for_ == asked_) return;
    ui::close_dialog();
    shown_.clear();
  } else if (!ui::any_dialog()) {
    // At first; and after a question of the program's, for which it made room.
    ui::open_dialog(title_);
  }
}

void FileDialog::draw() {
  const bool keys = ui::foremost();
  if (keys && ui::key_pressed(Key::escape)) return close();
  if (keys) walk();
  draw_way();
  ui::gap(2 * ui::scale());
  // As high as the window has room for, after all that stands above and below.
  const double height =
      std::clamp(ui::window_height() - 280 * ui::scale() - (more_ ? 2 * ui::line_height() : 0),
                 4 * ui::line_height(), 380 * ui::scale());
  const double places = std::min(170 * ui::scale(), 0.25 * ui::width_left());
  draw_places(places, height);
  ui::same_line();
  draw_list(height);
  draw_name();
  if (more_) more_(kinds_.empty() ? FileKind{} : kinds_[static_cast<std::size_t>(kind_)]);
  if (trouble_.empty())
    ui::soft_text(listing_.others == 0 ? " "
                  : listing_.others == 1
                      ? "1 file of another kind is not shown"
                      : std::to_string(listing_.others) + " files of other kinds are not shown");
  else
    ui::colored_text(trouble_, ui::colors().warning);
  draw_buttons();
  draw_new_folder();
  questions_.frame();
}

void FileDialog::draw_way() {
  const std::vector<fs::path> way = way_to(listing_.folder);
  const std::vector<std::string> tools = {new_folder_title, "Reload"};
  const double tools_width = ui::buttons_width(tools);
  // From the end, as many parts as there is room for; those before them go behind one button.
  const double space = 4 * ui::scale();
  double room = ui::width_left() - tools_width - ui::button_width("…") - 4 * space;
  std::size_t first = way.size();
  while (first > 0) {
    const double wide = ui::button_width(part_name(way[first - 1])) + space;
    if (wide > room && first < way.size()) break;
    room -= wide;
    --first;
  }
  fs::path clicked;
  if (first > 0) {
    if (ui::button("…")) clicked = way[first - 1];
    ui::tooltip(way[first - 1].string());
    ui::same_line(space);
  }
  for (std::size_t i = first; i < way.size(); ++i) {
    const auto id = ui::id(static_cast<long>(i));
    // A single name may be wider than the dialog.
    const std::string name = ui::shortened(part_name(way[i]), 0.5 * ui::window_width());
    if (ui::button(name)) clicked = way[i];
    ui::same_line(space);
  }
  ui::flush_right(tools_width);
  if (ui::button(new_folder_title)) {
    new_folder_.clear();
    new_folder_trouble_.clear();
    new_folder_caret_ = true;
    ui::open_dialog(new_folder_title);
  }
  ui::same_line();
  if (ui::button("Reload")) reload();
  ui::tooltip("Reads the folder again");
  if (!clicked.empty()) enter(clicked);
}

void FileDialog::draw_places(double width, double height) {
  fs::path to;
  std::string file;
  if (const auto area = ui::scroll_area("places", width, height)) {
    const auto line = [&](const std::string& name, const fs::path& folder, bool here) {
      const auto id = ui::id(name + "##" + folder.string());
      const bool pressed = ui::list_row(name, here).clicked;
      ui::tooltip(folder.string());
      return pressed;
    };
    if (!places_.home.empty() && line("Home", places_.home, listing_.folder == places_.home))
      to = places_.home;
    for (const Shortcut& each : places_.shortcuts)
      if (line(each.name, each.folder, listing_.folder == each.folder)) to = each.folder;
    if (!places_.recent.empty()) {
      ui::gap(4 * ui::scale());
      ui::soft_text("Recent");
    }
    if (mode_ == Mode::save) {
      for (const fs::path& folder : folders_of(places_.recent))
        if (line(part_name(folder), folder, false)) to = folder;
    } else {
      for (const fs::path& each : places_.recent)
        if ((kinds_.empty() || kind_of(each, kinds_) >= 0) && line(each.filename().string(), each, false)) {
          to = each.parent_path();
          file = each.filename().string();
        }
    }
  }
  if (to.empty() || !enter(to) || file.empty()) return;
  const auto entry = std::find_if(listing_.entries.begin(), listing_.entries.end(),
                                  [&](const FolderEntry& e) { return !e.folder && e.name == file; });
  if (entry == listing_.entries.end()) {
    trouble_ = file + " is no longer there";
    return;
  }
  choose(entry - listing_.entries.begin());
  reveal_ = chosen_;
}

void FileDialog::draw_list(double height) {
  Index clicked = -1;
  bool open_it = false;
  if (const auto area = ui::scroll_area("files", 0, height, true)) {
    const double dates = ui::text_width("0000-00-00 00:00"), sizes = ui::text_width("000.0 MB");
    // Names matter most.
    const bool narrow = ui::width_left() < 2 * (dates + sizes);
    ui::long_list(
        static_cast<Index>(listing_.entries.size()),
        [&](Index i) {
          const FolderEntry& each = listing_.entries[static_cast<std::size_t>(i)];
          std::vector<ui::RowFact> facts;
          if (!narrow)
            facts = {{each.folder ? "" : size_text(each.size), sizes}, {time_text(each.changed), dates}};
          const ui::RowUse use = ui::list_row(each.name, i == chosen_, facts, each.folder ? "▸" : " ");
          if (use.clicked) clicked = i;
          open_it = open_it || use.double_clicked;
        },
        reveal_);
    reveal_ = -1;
    if (listing_.entries.empty()) ui::soft_text("Nothing to show in this folder");
  }
  if (clicked < 0) return;
  choose(clicked);
  if (open_it) accept();
}

void FileDialog::draw_name() {
  const bool choose_kind = mode_ == Mode::save && kinds_.size() > 1;
  std::vector<std::string> names;
  double kinds_width = 0;
  if (choose_kind) {
    for (const FileKind& kind : kinds_) {
      names.push_back(kind.name + " (" + kind.ending + ")");
      kinds_width = std::max(kinds_width, ui::text_width(names.back()));
    }
    kinds_width += 48 * ui::scale();
  }
  {
    const auto width = ui::item_width(choose_kind ? -kinds_width - 8 * ui::scale() : -1);
    if (ui::foremost() && std::exchange(wants_caret_, false)) ui::focus_next();
    const auto id = ui::id(name_shown_);
    if (ui::text_field("##name", name_, "Name or path")) {
      trouble_.clear();
      chosen_ = -1;
      if (const int typed = kind_of(name_, kinds_); typed >= 0) kind_ = typed;
    }
  }
  if (!choose_kind) return;
  ui::same_line();
  const auto width = ui::item_width(-1);
  if (ui::choice("##kind", kind_, names)) {
    chosen_ = -1;
    show_name(with_kind(name_, kinds_, static_cast<std::size_t>(kind_)));
  }
}

void FileDialog::draw_buttons() {
  const std::string main = mode_ == Mode::open ? "Open" : "Save";
  ui::flush_right(ui::buttons_width({main, "Cancel"}));
  // Enter in the very frame in which the caret is on its way is Enter, too.
  const bool entered = ui::foremost() && ui::key_pressed(Key::enter);
  if (ui::main_button(main) || entered) accept();
  ui::same_line();
  if (ui::button("Cancel")) close();
}

void FileDialog::draw_new_folder() {
  const auto dialog =
      ui::dialog(new_folder_title, std::min(380 * ui::scale(), ui::window_width() - 32), false);
  if (!dialog) return;
  ui::paragraph("In " + listing_.folder.string());
  {
    const auto width = ui::item_width(-1);
    if (std::exchange(new_folder_caret_, false)) ui::focus_next();
    if (ui::text_field("##folder", new_folder_, "Name of the folder")) new_folder_trouble_.clear();
  }
  ui::colored_text(new_folder_trouble_.empty() ? " " : new_folder_trouble_, ui::colors().warning);
  ui::flush_right(ui::buttons_width({"Make", "Back"}));
  const bool make = ui::main_button("Make");
  ui::same_line();
  const bool back = ui::button("Back") || ui::key_pressed(Key::escape);
  try {
    if (make) enter(make_folder(listing_.folder, new_folder_));
    if (make || back) ui::close_dialog();
  } catch (const Error& error) {
    new_folder_trouble_ = error.what();
    new_folder_caret_ = true;
  }
}

}  // namespace seesaw
