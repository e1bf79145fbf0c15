// A recorded editing session: the document it began with, and everything that was done.
//
// Before it: an Editor that is listened to, or a person with a text editor. After it: core/editing/replay.h
// does it all again, without a window; figures take their pictures at its labels.
//
//     {
//       "seesaw_session": 1,
//       "dimension": 3,
//       "title": "A torus",
//       "start": { a document, core/scene/document_json.h },
//       "actions": [
//         {"do": "add_on_surface", "from": [0, 0, 5], "direction": [0, 0, -1]},
//         {"do": "begin"},
//         {"do": "move", "which": [12], "by": [0.01, 0, 0]},
//         {"do": "end"},
//         {"do": "label", "text": "after the first drag"}
//       ]
//     }
//
// The actions, with what they may leave away in parentheses:
//     add {constraints}          add_on_surface {from, in 3D direction}
//     move {which, by}           move_to {which, to}           delete {which}
//     set_value {which, value}   set_kind {which, kind, (value)}
//     add_normal {which, (offset)}   set_normal {which, normal, offset, value}
//     turn_normal {which, direction, (value)}   remove_normal {which}
//     set_kernel {kernel}        set_smoothing {smoothing}     restore {document}
//     begin  end  cancel  undo  redo  label {text}
// `which` is an index, or an array of indices where core/editing/action.h has several. A recorder writes the
// answers of add_on_surface and add_normal (an add, a set_normal), a person may write the questions. Any
// object may have a "comment"; every other key that is not listed is refused, as a misspelled one would
// change the shape in silence. In the start document unknown keys are kept, as in any document.
//
// Numbers are written as the shortest that read back to the same bits. Errors name the line and the path:
//     torus.json:12: actions[3].by: expected 3 numbers, found 2
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/editing/editor.h"

namespace seesaw {

inline constexpr int session_version = 1;

template <int Dim>
struct RecordedCommand {
  Command<Dim> command;
  std::string comment = {};
  /// Of the file it was read from, for messages; 0 for none.
  int line = 0;
};

template <int Dim>
struct Session {
  std::string title = {};
  std::string comment = {};
  Document<Dim> start = {};
  std::vector<RecordedCommand<Dim>> commands = {};
  /// The file it was read from, for messages; empty for none.
  std::string name = {};
};

using AnySession = std::variant<Session<2>, Session<3>>;

/// Starts a session with the editor's present document and makes it grow with every command that the editor
/// is given. An undo or redo that leaves what was recorded, to a document of before, is recorded as a
/// restore, and so are those after it. Takes the editor's listener; the session must outlive the editor, or
/// the listener be set to none. Throws Refused in the middle of a gesture.
template <int Dim>
void record(Editor<Dim>& editor, Session<Dim>& session);

/// Throws FileError. `name` is what errors call the text.
AnySession parse_session(std::string_view text, const std::string& name = "session");
AnySession read_session(const std::filesystem::path& path);
/// As above, and refuses a session of another dimension. For Dim 2 and 3.
template <int Dim>
Session<Dim> read_session(const std::filesystem::path& path);

/// The text of a file that holds `session`, one command a line. Throws Error, naming the path, for what a
/// reader would refuse.
template <int Dim>
std::string to_json_text(const Session<Dim>& session);
std::string to_json_text(const AnySession& session);

/// Writes that text over the file, all or nothing. Throws Error or FileError.
template <int Dim>
void write_session(const std::filesystem::path& path, const Session<Dim>& session);

}  // namespace seesaw
