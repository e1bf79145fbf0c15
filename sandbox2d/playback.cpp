#include "sandbox2d/playback.h"

#include "core/base/error.h"

namespace seesaw {

namespace {

constexpr double between_commands = 1.0 / 30, at_a_label = 1.0;  // seconds

}  // namespace

void Playback::start(Session<2> session, Desk& desk, double now) {
  const auto count = static_cast<Index>(session.start.constraints.size());
  if (count > desk.most_constraints())
    throw FileError(session.name.empty() ? "the session" : session.name,
                    "begins with " + std::to_string(count) + " constraints; up to " +
                        std::to_string(desk.most_constraints()) + " can be edited");
  session_ = std::move(session);
  next_ = 0;
  due_ = now + at_a_label;
  desk.start(session_.start);
  desk.say("replaying " + std::to_string(session_.commands.size()) + " commands; Esc stops");
}

void Playback::step(Desk& desk, double now) {
  while (running() && now >= due_) {
    const RecordedCommand<2>& recorded = session_.commands[next_++];
    const auto* label = std::get_if<Label>(&recorded.command);
    due_ += label ? at_a_label : between_commands;
    if (label) desk.say(label->text);
    if (!desk.do_again(recorded.command)) return stop(desk);
    // A program that was busy does not race to catch up.
    if (due_ < now - 4 * between_commands) due_ = now;
  }
  if (!running() && !session_.commands.empty()) {
    desk.say("that was all of it: " + std::to_string(session_.commands.size()) + " commands");
    stop(desk);
  }
}

void Playback::stop(Desk& desk) {
  desk.let_go();
  session_ = {};
  next_ = 0;
}

}  // namespace seesaw
