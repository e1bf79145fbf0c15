#include "core/editing/background_session.h"

#include <chrono>
#include <system_error>
#include <utility>

#include "core/base/parallel.h"

namespace seesaw {

namespace {

// So few solves are as good as having caught up: whoever drags a constraint with its normal needs as many for
// every step.
constexpr Index few_solves = 4;

// Somebody who changes more in a hundredth of a second than can be bordered in it is never caught up with.
constexpr int rounds = 8;

}  // namespace

template <int Dim>
BackgroundSession<Dim>::BackgroundSession(Question<Dim> question, const EditOptions& edit,
                                          std::optional<EditSession<Dim>> session,
                                          std::function<void()> arrived)
    : question_(std::move(question)),
      edit_(edit),
      result_{std::move(session), nullptr},
      arrived_(std::move(arrived)) {
  try {
    thread_ = std::thread([this] { work(); });
  } catch (const std::system_error&) {
    work();
  }
}

template <int Dim>
BackgroundSession<Dim>::~BackgroundSession() {
  cancel();
  {
    const std::scoped_lock lock(mutex_);
    arrived_ = {};
  }
  wait();
}

template <int Dim>
void BackgroundSession<Dim>::follow(Question<Dim> latest) {
  const std::scoped_lock lock(mutex_);
  latest_ = std::move(latest);
}

template <int Dim>
void BackgroundSession<Dim>::work() {
  try {
    leaving_a_core([this] { answer(); });
    leaving_a_core([this] { catch_up(); });
  } catch (...) {
    result_.refusal = std::current_exception();
  }
  ready_ = true;
  tell();
}

template <int Dim>
void BackgroundSession<Dim>::tell() {
  const std::scoped_lock lock(mutex_);
  if (arrived_) arrived_();
}

template <int Dim>
void BackgroundSession<Dim>::answer() {
  auto told = std::chrono::steady_clock::now();
  const Progress progress = [this, &told](double fraction) {
    fraction_ = fraction;
    if (const auto now = std::chrono::steady_clock::now(); now - told > std::chrono::milliseconds(250)) {
      told = now;
      tell();
    }
    return !cancelled_;
  };
  std::optional<EditSession<Dim>>& session = result_.session;
  if (session)
    session->update(question_.constraints, question_.options, {}, progress);
  else
    session.emplace(question_.constraints, question_.options, edit_, progress);
}

template <int Dim>
void BackgroundSession<Dim>::catch_up() {
  const Progress progress = [this](double) { return !cancelled_; };
  for (int k = 0; k < rounds; ++k) {
    std::optional<Question<Dim>> latest;
    {
      const std::scoped_lock lock(mutex_);
      latest = std::exchange(latest_, std::nullopt);
    }
    if (!latest) return;
    try {
      result_.session->update(latest->constraints, latest->options, {.full = 0}, progress);
    } catch (const Error&) {  // impossible, another kernel, cancelled: whoever asks will hear of it
      return;
    }
    if (result_.session->last().solves <= few_solves) return;
  }
}

template <int Dim>
void BackgroundSession<Dim>::wait() {
  if (thread_.joinable()) thread_.join();
}

template <int Dim>
typename BackgroundSession<Dim>::Result BackgroundSession<Dim>::take() {
  wait();
  return std::move(result_);
}

template class BackgroundSession<2>;
template class BackgroundSession<3>;

}  // namespace seesaw
