#include "core/editing/background_fit.h"

#include <system_error>

#include "core/base/parallel.h"

namespace seesaw {

template <int Dim>
BackgroundFit<Dim>::BackgroundFit(RefitJob<Dim> job, std::function<void()> arrived)
    : job_(std::move(job)), arrived_(std::move(arrived)) {
  try {
    thread_ = std::thread([this] { work(); });
  } catch (const std::system_error&) {
    work();
  }
}

template <int Dim>
BackgroundFit<Dim>::~BackgroundFit() {
  {
    const std::scoped_lock lock(mutex_);
    arrived_ = {};
  }
  if (thread_.joinable()) thread_.join();
}

template <int Dim>
void BackgroundFit<Dim>::work() {
  try {
    leaving_a_core([&] { result_.emplace(job_.run()); });
  } catch (...) {
    error_ = std::current_exception();
  }
  ready_ = true;
  const std::scoped_lock lock(mutex_);
  if (arrived_) arrived_();
}

template <int Dim>
void BackgroundFit<Dim>::wait() {
  if (thread_.joinable()) thread_.join();
}

template <int Dim>
FullFit<Dim> BackgroundFit<Dim>::take() {
  wait();
  if (error_) std::rethrow_exception(error_);
  return std::move(*result_);
}

template class BackgroundFit<2>;
template class BackgroundFit<3>;

}  // namespace seesaw
