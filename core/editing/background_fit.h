// One full fit on a thread of its own, and on all cores but one: edits go on meanwhile.
//
//     BackgroundFit<2> fit({constraints, options}, [&] { window.wake(); });
//     ... frames ...
//     if (fit.ready()) session.emplace(fit.take(), fit.job().constraints);
//
// Before it: core/rbf/edit_session.h, the job. After it: core/editing/background_solver.h, which says when
// there is one.
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "core/rbf/edit_session.h"

namespace seesaw {

/// Used by one thread, apart from its own.
template <int Dim>
class BackgroundFit {
 public:
  /// Begins. `arrived`, if any, is called once ready() is true, from the thread of the fit: it must not
  /// throw, nor wait for the thread that may be waiting in take() for it. Where the system has no thread left
  /// the fit is made here.
  explicit BackgroundFit(RefitJob<Dim> job, std::function<void()> arrived = {});
  /// Waits for the end, since work on a matrix cannot be stopped: a second at 5000 rows. `arrived` is not
  /// called any more.
  ~BackgroundFit();
  BackgroundFit(const BackgroundFit&) = delete;
  BackgroundFit& operator=(const BackgroundFit&) = delete;

  const RefitJob<Dim>& job() const { return job_; }
  bool ready() const { return ready_; }
  /// Until it is ready.
  void wait();
  /// Waits where it is not ready. Once. Throws what the fit threw: ConstraintError, std::bad_alloc.
  FullFit<Dim> take();

 private:
  void work();

  RefitJob<Dim> job_;
  std::mutex mutex_;
  std::function<void()> arrived_;  // under the mutex
  std::optional<FullFit<Dim>> result_;
  std::exception_ptr error_;
  std::atomic<bool> ready_ = false;
  std::thread thread_;  // the last: it uses the others
};

extern template class BackgroundFit<2>;
extern template class BackgroundFit<3>;

}  // namespace seesaw
