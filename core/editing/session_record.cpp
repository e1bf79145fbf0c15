// record(): a session grows while its editor is used.

#include "core/editing/session.h"

namespace seesaw {

template <int Dim>
void record(Editor<Dim>& editor, Session<Dim>& session) {
  if (editor.in_gesture()) throw Refused("record: end or cancel the gesture first");
  session = {};
  session.start = editor.document();
  // States up to `newest` are older than the record. A replay can go back to the first of its own, which is
  // `first`, and to no other of them: from there on it is told the documents instead.
  const std::uint64_t first = editor.state(), newest = editor.newest_state();
  editor.listen(
      [&session, first, newest, beyond = false](const Command<Dim>& command, const Editor<Dim>& now) mutable {
        const bool travels = std::holds_alternative<Undo>(command) || std::holds_alternative<Redo>(command);
        if (travels && now.state() <= newest && now.state() != first) beyond = true;
        if (travels && beyond) {
          session.commands.push_back({Action<Dim>(Restore<Dim>{now.document()})});
        } else {
          session.commands.push_back({command});
        }
      });
}

template void record(Editor<2>&, Session<2>&);
template void record(Editor<3>&, Session<3>&);

}  // namespace seesaw
