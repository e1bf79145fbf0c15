#include "core/editing/background_solver.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "core/editing/background_fit.h"

namespace seesaw {

namespace {

bool same_options(const FitOptions& a, const FitOptions& b, int dimension) {
  const Kernel papers = papers_kernel(dimension);
  return a.kernel.value_or(papers) == b.kernel.value_or(papers) && a.smoothing == b.smoothing &&
         a.condition == b.condition;
}

template <int Dim>
bool same_constraint(const Constraint<Dim>& a, const Constraint<Dim>& b) {
  if (a.kind != b.kind || a.at != b.at || a.value != b.value || a.normal.has_value() != b.normal.has_value())
    return false;
  return !a.normal || (a.normal->direction == b.normal->direction && a.normal->offset == b.normal->offset &&
                       a.normal->value == b.normal->value);
}

template <int Dim>
bool same_question(const RefitJob<Dim>& a, const Constraints<Dim>& constraints, const FitOptions& options) {
  return same_options(a.options, options, Dim) &&
         std::ranges::equal(a.constraints, constraints, same_constraint<Dim>);
}

// Of the system, without solving it. Throws what can be refused already.
template <int Dim>
Rows<Dim> rows_to_solve(const Constraints<Dim>& constraints, const FitOptions& options) {
  const Rows<Dim> rows = rows_of(constraints);
  return options.smoothing == 0.0 ? merge_coincident(rows) : rows;
}

}  // namespace

template <int Dim>
struct BackgroundSolver<Dim>::State {
  using Question = RefitJob<Dim>;
  /// A question that a fit has refused elsewhere.
  struct Refusal {
    Question question;
    std::exception_ptr error;
  };

  BackgroundOptions options;
  std::optional<EditSession<Dim>> session;
  std::unique_ptr<BackgroundFit<Dim>> running;
  /// The last that was asked, while it has no answer.
  std::optional<Question> waiting;
  /// To be shown until then.
  std::optional<Fit<Dim>> newer;
  std::optional<Refusal> refusal;
  std::optional<double> difference;
  /// Grows with every answer. A refit that was declined is not repeated before it has grown, and a function
  /// that was begun before it grew is older than what is shown.
  std::uint64_t answers = 0, declined = ~std::uint64_t{0}, begun = 0;

  Fit<Dim> answer(const Constraints<Dim>& constraints, const FitOptions& fit_options);
  bool poll();

  /// Without a full fit of many rows; none where there would have to be one.
  std::optional<Fit<Dim>> at_once(const Question& question);
  void begin(Question question);
  void refit_where_due();
  /// Makes what has arrived the ground of further answers. True where the last answer has become another.
  bool take_in();
  bool adopt(FullFit<Dim> fresh);
  void show_meanwhile(const FullFit<Dim>& fresh);
};

template <int Dim>
std::optional<Fit<Dim>> BackgroundSolver<Dim>::State::at_once(const Question& question) {
  const auto& [constraints, fit_options] = question;
  if (refusal) {
    if (same_question(refusal->question, constraints, fit_options)) std::rethrow_exception(refusal->error);
    refusal.reset();
  }
  if (!session) {
    if (rows_to_solve(constraints, fit_options).values.size() > options.at_once) return std::nullopt;
    ++answers;
    return session.emplace(constraints, fit_options, options.edit).fit();
  }
  if (same_question({session->constraints(), session->options()}, constraints, fit_options)) {
    answers += waiting.has_value();
    return session->fit();
  }
  try {
    const Fit<Dim>& fit = session->update(constraints, fit_options);
    ++answers;
    return fit;
  } catch (const FullFitDue&) {
    return std::nullopt;
  }
}

template <int Dim>
void BackgroundSolver<Dim>::State::begin(Question question) {
  running = std::make_unique<BackgroundFit<Dim>>(std::move(question), options.arrived);
  begun = answers;
}

template <int Dim>
void BackgroundSolver<Dim>::State::refit_where_due() {
  if (!running && session->wants_refit() && session->fit().report.rows > options.at_once &&
      declined != answers)
    begin(session->refit_job());
}

template <int Dim>
bool BackgroundSolver<Dim>::State::adopt(FullFit<Dim> fresh) {
  try {
    const Handover handover = session->adopt(std::move(fresh));
    if (handover.adopted) {
      difference = handover.difference;
      return true;
    }
  } catch (const Error&) {  // FullFitDue: it is no better ground than the one there is
  }
  declined = answers;
  return false;
}

// Where it is newer than what is shown, and of nearly the same constraints: not another document's.
template <int Dim>
void BackgroundSolver<Dim>::State::show_meanwhile(const FullFit<Dim>& fresh) {
  newer.reset();
  if (begun != answers) return;
  try {
    const Rows<Dim> rows = rows_to_solve(waiting->constraints, waiting->options);
    if (RowFinder<Dim>(fresh.rows.centers).match(rows.centers).size() <= rows.values.size() / 2)
      newer = fresh.fit;
  } catch (const ConstraintError&) {  // the present ones are impossible: that is shown
  }
}

template <int Dim>
bool BackgroundSolver<Dim>::State::take_in() {
  Question question = running->job();
  std::optional<FullFit<Dim>> fresh;
  try {
    const std::unique_ptr<BackgroundFit<Dim>> done = std::move(running);
    fresh.emplace(done->take());
  } catch (...) {
    refusal = Refusal{std::move(question), std::current_exception()};
    return !waiting;
  }
  if (session && !waiting) return adopt(std::move(*fresh));
  if (waiting) show_meanwhile(*fresh);
  if (!session || (waiting && same_options(waiting->options, question.options, Dim)))
    session.emplace(std::move(*fresh), question.constraints, options.edit);
  return !waiting;
}

template <int Dim>
bool BackgroundSolver<Dim>::State::poll() {
  if (!running || !running->ready()) return false;
  if (!waiting) return take_in();
  try {
    take_in();
    if (!at_once(*waiting)) {
      begin(*waiting);
      return newer.has_value();
    }
  } catch (const std::exception&) {  // which is the answer, for when it is asked again
    refusal = Refusal{std::move(*waiting), std::current_exception()};
  }
  waiting.reset();
  return true;
}

template <int Dim>
Fit<Dim> BackgroundSolver<Dim>::State::answer(const Constraints<Dim>& constraints,
                                              const FitOptions& fit_options) {
  Question question{constraints, fit_options};
  if (waiting) waiting = question;
  if (running && running->ready() && !waiting) take_in();
  std::optional<Fit<Dim>> fit = at_once(question);
  if (!fit && waiting && running && running->ready()) {
    take_in();
    fit = at_once(question);
  }
  if (fit) {
    waiting.reset();
    newer.reset();
    refit_where_due();
    return std::move(*fit);
  }
  if (!running) begin(question);
  waiting = std::move(question);
  throw StillSolving<Dim>(std::exchange(newer, std::nullopt));
}

template <int Dim>
BackgroundSolver<Dim>::BackgroundSolver(BackgroundOptions options) : state_(std::make_shared<State>()) {
  options.edit.largest_full = options.at_once;
  state_->options = std::move(options);
}

template <int Dim>
Fit<Dim> BackgroundSolver<Dim>::operator()(const Constraints<Dim>& constraints,
                                           const FitOptions& options) const {
  return state_->answer(constraints, options);
}

template <int Dim>
bool BackgroundSolver<Dim>::poll() const {
  return state_->poll();
}

template <int Dim>
bool BackgroundSolver<Dim>::busy() const {
  return state_->running != nullptr;
}

template <int Dim>
bool BackgroundSolver<Dim>::wait() const {
  bool news = false;
  while (state_->running) {
    state_->running->wait();
    news |= state_->poll();
  }
  return news;
}

template <int Dim>
std::optional<double> BackgroundSolver<Dim>::last_difference() const {
  return state_->difference;
}

template <int Dim>
const EditSession<Dim>* BackgroundSolver<Dim>::session() const {
  return state_->session ? &*state_->session : nullptr;
}

template class BackgroundSolver<2>;
template class BackgroundSolver<3>;

}  // namespace seesaw
