// An edit session on a thread of its own, and on all cores but one, until it has caught up with what is
// edited meanwhile.
//
//     BackgroundSession<2> work({.constraints = constraints});      // begins with a full fit
//     ... frames ...
//     work.follow({.constraints = edited});
//     if (work.ready()) auto [session, refusal] = work.take();      // of `edited`, or nearly
//
// A full fit of some thousand rows takes a second, and by then some tens of rows have been edited: a tenth of
// a second's work to border. That is done here too, and what was edited during that, and so on, so that who
// takes the session has no more to do than for an edit.
//
// Before it: core/rbf/edit_session.h.  After it: core/editing/background_solver.h, which says when there is
// one.
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "core/rbf/edit_session.h"

namespace seesaw {

/// What a function is asked for.
template <int Dim>
struct Question {
  Constraints<Dim> constraints;
  FitOptions options = {};
};

/// Used by one thread, apart from its own.
template <int Dim>
class BackgroundSession {
 public:
  struct Result {
    /// None where there was none to begin with and its first full fit has failed.
    std::optional<EditSession<Dim>> session;
    /// Why the question has no answer: ConstraintError, std::bad_alloc; Cancelled. The session is then that
    /// of before. Of later questions nothing is said: they are only followed as far as that goes.
    std::exception_ptr refusal;
  };

  /// Begins: with `session`, or without one with a full fit of the question and `edit`. `arrived`, if any, is
  /// called once ready() is true, and four times a second until then since fraction() has grown; from the
  /// session's thread: it must not throw, nor wait for the thread that may be waiting in take() for it. Where
  /// the system has no thread left all is done here.
  explicit BackgroundSession(Question<Dim> question, const EditOptions& edit = {},
                             std::optional<EditSession<Dim>> session = std::nullopt,
                             std::function<void()> arrived = {});
  /// Cancels, and waits for that. `arrived` is not called any more.
  ~BackgroundSession();
  BackgroundSession(const BackgroundSession&) = delete;
  BackgroundSession& operator=(const BackgroundSession&) = delete;

  const Question<Dim>& question() const { return question_; }
  /// What is wanted by now. Never a full fit more.
  void follow(Question<Dim> latest);
  /// Ends the work in some 10 ms; the question is then refused by Cancelled.
  void cancel() { cancelled_ = true; }
  bool cancelled() const { return cancelled_; }
  /// How much is done of what was asked first, 0 to 1.
  double fraction() const { return fraction_; }
  bool ready() const { return ready_; }
  /// Until it is ready.
  void wait();
  /// Waits where it is not ready. Once.
  Result take();

 private:
  void work();
  void tell();
  void answer();
  void catch_up();

  Question<Dim> question_;
  EditOptions edit_;
  Result result_;
  std::mutex mutex_;
  std::function<void()> arrived_;        // under the mutex
  std::optional<Question<Dim>> latest_;  // under the mutex
  std::atomic<bool> cancelled_ = false, ready_ = false;
  std::atomic<double> fraction_ = 0.0;
  std::thread thread_;  // the last: it uses the others
};

extern template class BackgroundSession<2>;
extern template class BackgroundSession<3>;

}  // namespace seesaw
