#include "core/editing/replay.h"

namespace seesaw {

template <int Dim>
Editor<Dim> replay(const Session<Dim>& session, const ReplayOptions<Dim>& options, const Progress& progress) {
  Editor<Dim> editor(session.start, options.editor);
  const std::size_t count = session.commands.size();
  for (std::size_t i = 0; i < count; ++i) {
    report(progress, static_cast<double>(i) / static_cast<double>(count));
    const RecordedCommand<Dim>& each = session.commands[i];
    try {
      editor.perform(each.command);
    } catch (const Refused& refused) {
      const std::string message = "actions[" + std::to_string(i) + "]: " + refused.what();
      if (session.name.empty()) throw Error(message);
      throw FileError(session.name, each.line, message);
    }
    if (const auto* label = std::get_if<Label>(&each.command); label && options.at_label)
      options.at_label(label->text, editor);
    if (options.after_each) options.after_each(static_cast<Index>(i), editor);
  }
  report(progress, 1.0);
  return editor;
}

template Editor<2> replay(const Session<2>&, const ReplayOptions<2>&, const Progress&);
template Editor<3> replay(const Session<3>&, const ReplayOptions<3>&, const Progress&);

}  // namespace seesaw
