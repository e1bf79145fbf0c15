// A recorded session, done again before one's eyes: a lecture that can be repeated.
//
//     playback.start(read_session<2>(path), desk, now);
//     if (playback.running()) playback.step(desk, now);        each frame
//
// A command every thirtieth of a second, as a hand does them; at a label it waits for a moment. What has been
// done is the desk's, and can be undone.
//
// Before it: core/editing/session.h. After it: Desk::do_again.
#pragma once

#include <string>

#include "core/editing/desk.h"

namespace seesaw {

class Playback {
 public:
  /// The session's start becomes the desk's document, without a file. `now` in seconds. Throws FileError
  /// where it has more constraints than the desk takes; nothing has changed then.
  void start(Session<2> session, Desk& desk, double now);
  bool running() const { return next_ < session_.commands.size(); }
  /// Does what is due. Ends where a command is refused: the desk says why.
  void step(Desk& desk, double now);
  /// Leaves the document as it is.
  void stop(Desk& desk);

 private:
  Session<2> session_;
  std::size_t next_ = 0;
  double due_ = 0;
};

}  // namespace seesaw
