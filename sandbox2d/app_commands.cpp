// What a program does and a desk cannot: files, dialogs, the window's looks.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "core/base/file.h"
#include "core/image/png.h"
#include "core/window/ui.h"
#include "sandbox2d/app.h"

namespace seesaw {

namespace {

const std::vector<FileKind>& scene_kinds() {
  static const std::vector<FileKind> kinds = {{".json", "Scene or session"}};
  return kinds;
}

}  // namespace

void App::act_on(std::optional<DeskCommand> command) {
  if (command) act(*command);
}

void App::act(DeskCommand command) {
  using C = DeskCommand;
  changed_ = true;
  if (playback_.running()) {
    playback_.stop(desk_);
    if (command == C::cancel) return desk_.say("stopped; what was done can be undone");
  }
  // What is left over is for here.
  const std::optional<C> mine = desk_.perform(command);
  if (command == C::fit) {
    plate_.rescale();
    shown_view_ = desk_.view();
  }
  if (!mine) return;
  switch (*mine) {
    case C::edit_values:
      return values_.ask(desk_);
    case C::toggle_weights:
      shown_.weights = !shown_.weights;
      return;
    case C::toggle_plate:
      shown_.plate = !shown_.plate;
      return;
    case C::toggle_panels:
      panels_ = !panels_;
      return;
    case C::toggle_dark:
      return window_.set_dark(!window_.dark());
    case C::larger_letters:
    case C::smaller_letters: {
      const double step = command == C::larger_letters ? 1.125 : 1 / 1.125;
      const double scale = window_.scale() * step;
      // Through 1 exactly, on the way there and back.
      window_.set_scale(std::abs(scale - 1) < 0.05 ? 1.0 : scale);
      return desk_.say("letters at " + std::to_string(std::lround(100 * window_.scale())) + " %");
    }
    case C::gallery:
      return gallery_.ask([this](const GalleryEntry& entry) { show_entry(entry); });
    case C::tour:
      return when_kept([this] { tour_to(0); });
    case C::new_document:
      return when_kept([this] {
        tour_.stop();
        Document<2> fresh;
        fresh.display.field = fresh.display.isolines = fresh.display.scale_bar = true;
        fresh.display.view = Box<2>(Point<2>(-2, -2), Point<2>(2, 2));
        desk_.start(std::move(fresh));
        new_document_shown();
        desk_.say("empty: B, I and E place boundary, interior and exterior constraints");
      });
    case C::open:
      return when_kept([this] { ask_open(); });
    case C::save:
      return save();
    case C::save_as:
      return ask_save();
    case C::export_picture:
      return ask_export();
    case C::export_window:
      return ask_export_window();
    case C::record:
      return toggle_recording();
    case C::replay:
      return when_kept([this] { ask_replay(); });
    case C::help:
      return help_.ask();
    case C::full_screen:
      return window_.set_full_screen(!window_.full_screen());
    case C::quit:
      return when_kept([this] { done_ = true; });
    default:
      return;
  }
}

void App::new_document_shown() {
  if (!desk_.display().view) shown_view_ = desk_.view();
  plate_.rescale();
  plate_.reset_view();
  profile_range_.reset();
  changed_ = true;
}

void App::open(const std::filesystem::path& path) {
  if (!desk_.open(path)) {
    recent_.remove(path);
    return;
  }
  tour_.stop();
  std::error_code error;
  const auto absolute = std::filesystem::absolute(path, error);
  recent_.add(error ? path : absolute);
  new_document_shown();
}

void App::show_entry(const GalleryEntry& entry) {
  const auto show = [this, &entry] {
    try {
      Document<2> document = read_scene(entry);
      tour_.stop();
      if (desk_.path().empty() && desk_.editor().size() > 0)
        desk_.exchange(std::move(document));
      else
        desk_.start(std::move(document));
      desk_.set_profile(entry.profile);
      if (entry.plate) shown_.plate = true;
      desk_.say(std::string("Try: ") + entry.try_this);
      new_document_shown();
    } catch (const Error& error) {
      desk_.say(error.what(), true);
    }
  };
  // A figure in place of a figure is a step that can be undone; a file is not left without a word.
  if (desk_.path().empty())
    show();
  else
    when_kept(show);
}

void App::tour_to(int step) {
  try {
    tour_.go_to(step, desk_);
    tour_seen_ = true;
    const TourStep& now = tour_steps()[static_cast<std::size_t>(tour_.step())];
    shown_.plate = now.plate;
    if (now.plate) panels_ = true;  // the lever is there
    desk_.say("");
    new_document_shown();
  } catch (const Error& error) {
    desk_.say(error.what(), true);
  }
}

void App::when_kept(std::function<void()> then) {
  // It would go on in the document that comes.
  if (playback_.running()) playback_.stop(desk_);
  desk_.let_go();
  if (desk_.recording()) return when_recorded([this, then] { when_kept(then); });
  if (!desk_.unsaved()) return then();
  std::string name = desk_.name();
  if (!name.empty() && name.back() == '*') name.pop_back();
  questions_.ask({"Unsaved changes",
                  name + " has changes that are not saved.",
                  {{"Save", [this, then] { save(then); }}, {"Don't save", then}, {"Cancel", {}}}});
}

void App::save(std::function<void()> then) {
  if (desk_.path().empty()) return ask_save(std::move(then));
  if (!desk_.save(desk_.path())) return;
  recent_.add(desk_.path());
  if (then) then();
}

void App::ask_save(std::function<void()> then) {
  std::error_code error;
  std::filesystem::path suggested = settings_.settings().last_folder / "scene.json";
  if (!desk_.path().empty()) suggested = std::filesystem::absolute(desk_.path(), error);
  files_.set_places(places());
  files_.ask_save("Save", {{".json", "Scene"}}, suggested, [this, then](const std::filesystem::path& path) {
    if (!desk_.save(path)) throw Error(desk_.message().text);
    recent_.add(path);
    if (then) then();
  });
}

FilePlaces App::places() const {
  const char* home = std::getenv("HOME");
  return {.home = home ? std::filesystem::path(home) : std::filesystem::path(),
          .shortcuts = {{"Figures", scenes_folder()}},
          .recent = recent_.list()};
}

void App::ask_open() {
  files_.set_places(places());
  std::error_code error;
  std::filesystem::path folder;
  if (!desk_.path().empty()) folder = std::filesystem::absolute(desk_.path(), error).parent_path();
  if (folder.empty()) folder = settings_.settings().last_folder;
  files_.ask_open("Open", scene_kinds(), folder, [this](const std::filesystem::path& path) {
    if (!desk_.open(path)) throw Error(desk_.message().text);
    tour_.stop();
    recent_.add(path);
    new_document_shown();
  });
}

void App::ask_replay() {
  files_.set_places(places());
  files_.ask_open("Replay a session", {{".json", "Session"}}, settings_.settings().last_folder,
                  [this](const std::filesystem::path& path) {
                    Session<2> session = read_session<2>(path);
                    tour_.stop();
                    playback_.start(std::move(session), desk_, window_.clock().time());
                    new_document_shown();
                  });
}

void App::ask_export() {
  if (!desk_.shape().function) return desk_.say("there is no curve to export yet", true);
  files_.set_places(places());
  std::error_code error;
  std::filesystem::path suggested = settings_.settings().last_folder / "curve.png";
  if (!desk_.path().empty()) suggested = std::filesystem::absolute(desk_.path(), error);
  suggested.replace_extension(".png");
  files_.ask_save(
      "Export", export_kinds(), suggested,
      [this](const std::filesystem::path& path) {
        Document<2> shown = desk_.to_save();
        // A figure that was not moved is exported in its own proportions, as `figures` makes it.
        if (!shows_as_saved()) shown.display.view = desk_.view().scene();
        export_document(path, shown, *desk_.shape().function, {.pixels_per_point = export_scale_});
        const bool none = ending_of(path) == ".csv" && painter_.picture().curve.polylines.empty();
        desk_.say("exported " + path.string() + (none ? "; there is no curve in it" : ""));
      },
      [this](const FileKind& kind) {
        if (kind.ending != ".png") return;
        ui::slider("pixels a point", export_scale_, 0.5, 8, {.format = "%.1f"});
      });
}

void App::ask_export_window() {
  files_.set_places(places());
  static const std::vector<FileKind> kinds = {{".png", "Picture"}};
  files_.ask_save("Export the window", kinds, settings_.settings().last_folder / "window.png",
                  [this](const std::filesystem::path& path) {
                    refuse_unless_writable(path);
                    window_picture_ = path;  // when the dialog is gone and all is drawn smooth
                  });
}

void App::export_window(bool dialog) {
  window_.stay_awake();
  if (dialog || !settled()) return;
  window_.hand_over([this, path = std::exchange(window_picture_, {})](const Image& picture) {
    try {
      write_png(path, picture);
      desk_.say("exported " + path.string());
    } catch (const Error& error) {
      desk_.say(error.what(), true);
    }
  });
}

void App::toggle_recording() {
  if (!desk_.recording()) {
    desk_.start_recording();
    return desk_.say("recording: everything that is done can be done again; Ctrl+R ends it");
  }
  when_recorded({});
}

void App::when_recorded(std::function<void()> then) {
  if (!desk_.recording()) return then ? then() : void();
  const std::size_t commands = desk_.recorded();
  const auto stop = [this, then](const char* words) {
    desk_.stop_recording();
    desk_.say(words);
    if (then) then();
  };
  if (commands == 0) return stop("nothing was recorded");
  questions_.ask(
      {"Recording",
       std::to_string(commands) + (commands == 1 ? " command was" : " commands were") + " recorded.",
       {{"Save\u2026", [this, then] { ask_save_recording(then); }},
        {"Discard", [stop] { stop("the recording is discarded"); }},
        {"Go on recording", {}}}});
}

void App::ask_save_recording(std::function<void()> then) {
  files_.set_places(places());
  files_.ask_save("Save the session", {{".json", "Session"}},
                  settings_.settings().last_folder / "session.json",
                  [this, then](const std::filesystem::path& path) {
                    const std::size_t commands = desk_.recorded();
                    desk_.save_recording(path);
                    desk_.say("recorded " + std::to_string(commands) + " commands in " + path.string() +
                              "; opening it does them again");
                    if (then) then();
                  });
}

void App::offer_recovered() {
  recovered_ = find_recovered(autosave_folder_);
  if (recovered_.empty()) return;
  const Recovered first = recovered_.front();
  const auto* document = std::get_if<Document<2>>(&first.kept.document);
  if (!document) return;
  const std::string of = first.kept.of.empty() ? "a document without a file" : first.kept.of.string();
  questions_.ask({"Recovered",
                  "Seesaw ended unexpectedly while " + of +
                      " had changes that were not saved. There is a copy of " +
                      std::to_string(document->constraints.size()) + " constraints.",
                  {{"Recover",
                    [this, first] {
                      desk_.recover(std::get<Document<2>>(first.kept.document), first.kept.of);
                      discard_when_saved_ = first;
                      new_document_shown();
                    }},
                   {"Discard", [first] { discard(first); }},
                   {"Later", {}}}});
}

}  // namespace seesaw
