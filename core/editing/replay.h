// A recorded session done again, without a window.
//
// Before it: core/editing/session.h.  After it: figures, tests, whoever wants the document of then.
//
//     Editor<3> end = replay(read_session<3>("torus.json"),
//                            {.at_label = [&](const std::string& name, Editor<3>& editor) { ... }});
#pragma once

#include "core/base/progress.h"
#include "core/editing/session.h"

namespace seesaw {

template <int Dim>
struct ReplayOptions {
  /// Without solve_at_once only what asks for the shape waits for it: a recorder's sessions never do.
  EditorOptions<Dim> editor = {};
  /// Called at each label with its text and the editor as it is then.
  std::function<void(const std::string& text, Editor<Dim>& editor)> at_label = {};
  /// Called after each command with its index.
  std::function<void(Index index, Editor<Dim>& editor)> after_each = {};
};

/// Does all commands on the session's start. What a recorder wrote gives the same document to the bit; the
/// history is there too, and can be undone. A command that is refused ends it with an Error that names the
/// line, where there is one, and the command: "torus.json:14: actions[5]: move: constraint 9 does not exist".
/// Progress is reported once a command; Cancelled.
template <int Dim>
Editor<Dim> replay(const Session<Dim>& session, const ReplayOptions<Dim>& options = {},
                   const Progress& progress = {});

}  // namespace seesaw
