// A desk's document: files, the clipboard, recording.
#include <new>

#include "core/base/file.h"
#include "core/editing/desk.h"
#include "core/editing/replay.h"
#include "core/scene/document_json.h"
#include "core/scene/json_tape.h"

namespace seesaw {

void Desk::check_size(Index count, const std::string& name) const {
  if (count > options_.most_constraints)
    throw FileError(name, "has " + std::to_string(count) + " constraints; up to " +
                              std::to_string(options_.most_constraints) + " can be edited");
}

// The new editor is there before the old one goes: whatever is thrown, the open document stays.
void Desk::replace(Editor<2> next, std::filesystem::path path, bool saved) {
  let_go();
  revisions_before_ = revision() + 1;
  editor_ = std::move(next);
  recording_ = false;
  selection_.clear();
  profile_.reset();
  path_ = std::move(path);
  saved_state_ = saved ? std::optional<std::uint64_t>(0) : std::nullopt;
  display_ = saved_display_ = document().display;
  before_.reset();
  comparing_ = false;
  other_kernel_.reset();
  other_.reset();
  other_pending_ = false;
  show_as_saved();
}

std::variant<Document<2>, Session<2>> Desk::read(const std::filesystem::path& path) const {
  const std::string name = path.string(), text = read_file(path, JsonLimits{}.bytes);
  try {
    Document<2> document = parse_document<2>(text, name);
    check_size(static_cast<Index>(document.constraints.size()), name);
    return document;
  } catch (const FileError&) {
    if (text.find("\"seesaw_session\"") == std::string::npos) throw;
  }
  AnySession any = parse_session(text, name);
  auto* session = std::get_if<Session<2>>(&any);
  if (!session) throw FileError(name, "is a session of dimension 3; expected one of dimension 2");
  return std::move(*session);
}

bool Desk::says_why_not(const std::filesystem::path& path, const std::function<void()>& act) {
  try {
    act();
    return true;
  } catch (const Error& error) {
    say(error.what(), true);
  } catch (const std::bad_alloc&) {
    say(path.string() + ": there is not enough memory for it", true);
  }
  return false;
}

bool Desk::can_open(const std::filesystem::path& path) {
  return says_why_not(path, [&] { read(path); });
}

bool Desk::open(const std::filesystem::path& path) {
  return says_why_not(path, [&] {
    auto found = read(path);
    if (auto* document = std::get_if<Document<2>>(&found)) {
      replace(Editor<2>(std::move(*document), options_.editor), path, true);
      return say("opened " + path.string());
    }
    Editor<2> editor = replay(std::get<Session<2>>(found), {.editor = options_.editor});
    check_size(editor.size(), path.string());
    replace(std::move(editor), {}, false);
    say("did again what was recorded in " + path.string());
  });
}

bool Desk::save(const std::filesystem::path& path) {
  close_gesture();
  try {
    write_document(path, to_save());
  } catch (const Error& error) {
    say(error.what(), true);
    return false;
  }
  path_ = path;
  saved_state_ = editor_.state();
  saved_display_ = display_;
  say("saved " + path.string());
  return true;
}

void Desk::start(Document<2> document) { replace(Editor<2>(std::move(document), options_.editor), {}, true); }

void Desk::exchange(Document<2> document) {
  let_go();
  const bool was_saved = !unsaved();
  const Display<2> display = document.display;
  if (!(document == editor_.document()) && !did(Restore<2>{std::move(document)})) return;
  selection_.clear();
  profile_.reset();
  comparing_ = false;
  other_kernel_.reset();
  display_ = display;
  if (was_saved) {
    saved_state_ = editor_.state();
    saved_display_ = display_;
  }
  show_as_saved();
}

void Desk::recover(Document<2> document, const std::filesystem::path& path) {
  replace(Editor<2>(std::move(document), options_.editor), path, false);
  say("recovered; it is not saved yet");
}

Document<2> Desk::to_save() const {
  Document<2> document = editor_.document();
  document.display = display_;
  return document;
}

bool Desk::unsaved() const {
  return !saved_state_ || editor_.state() != *saved_state_ || !(display_ == saved_display_);
}

std::string Desk::name() const {
  const std::string plain = !path_.empty()              ? path_.filename().string()
                            : !document().title.empty() ? document().title
                                                        : "untitled";
  return plain + (unsaved() ? "*" : "");
}

std::string Desk::selection_text() const {
  Document<2> part = to_save();
  if (selection_.empty()) return to_json_text(part);
  std::vector<SceneConstraint<2>> chosen;
  for (const Index i : selection_.indices()) chosen.push_back(part.constraints[static_cast<std::size_t>(i)]);
  part.constraints = std::move(chosen);
  return to_json_text(part);
}

bool Desk::paste(const std::string& text) {
  let_go();
  try {
    Document<2> pasted = parse_document<2>(text, "the clipboard");
    if (pasted.constraints.empty()) throw Error("there is no constraint in the clipboard");
    if (!room_for(pasted.constraints.size())) return false;
    // Beside what they were copied from, and beside earlier copies.
    const Point<2> aside = beside();
    const auto doubles = [&] {
      Constraints<2> plain = constraints_of(pasted);
      return without_doubles(plain, document()).size() < without_doubles(plain, {}).size();
    };
    for (int tries = 0; tries < 100 && doubles(); ++tries)
      for (SceneConstraint<2>& each : pasted.constraints) each.constraint.at += aside;
    return did(Add<2>{std::move(pasted.constraints)});
  } catch (const Error& error) {
    say(error.what(), true);
    return false;
  }
}

bool Desk::paste_scene(const std::string& text) {
  let_go();
  try {
    Document<2> pasted = parse_document<2>(text, "the clipboard");
    check_size(static_cast<Index>(pasted.constraints.size()), "the clipboard");
    const Display<2> display = pasted.display;
    if (!did(Restore<2>{std::move(pasted)})) return false;
    display_ = display;
    show_as_saved();
    return true;
  } catch (const Error& error) {
    say(error.what(), true);
    return false;
  }
}

void Desk::start_recording() {
  let_go();
  editor_.listen({});
  session_ = std::make_unique<Session<2>>();
  record(editor_, *session_);
  recording_ = true;
}

std::optional<Session<2>> Desk::stop_recording() {
  let_go();
  if (recording_) editor_.listen({});
  recording_ = false;
  if (!session_) return std::nullopt;
  std::optional<Session<2>> result = std::move(*session_);
  session_.reset();
  return result;
}

void Desk::save_recording(const std::filesystem::path& path) {
  let_go();
  write_session(path, *session_);
  stop_recording();
}

bool Desk::do_again(const Command<2>& command) {
  if (hand_) let_go();
  if (const auto* action = std::get_if<Action<2>>(&command)) return did(*action);
  if (std::holds_alternative<BeginGesture>(command)) {
    close_gesture();
    editor_.begin_gesture();
    open_ = Open::slider;
  } else if (std::holds_alternative<CancelGesture>(command)) {
    cancel();
  } else {
    close_gesture();
    if (const auto* label = std::get_if<Label>(&command)) editor_.label(label->text);
    if (std::holds_alternative<Undo>(command)) undo_or_redo(true);
    if (std::holds_alternative<Redo>(command)) undo_or_redo(false);
  }
  return true;
}

}  // namespace seesaw
