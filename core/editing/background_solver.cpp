#include "core/editing/background_solver.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "core/editing/background_session.h"

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
bool same_question(const Constraints<Dim>& constraints, const FitOptions& options, const Question<Dim>& b) {
  return same_options(options, b.options, Dim) &&
         std::ranges::equal(constraints, b.constraints, same_constraint<Dim>);
}

// Of the system, without solving it. Throws what can be refused already.
template <int Dim>
Rows<Dim> rows_to_solve(const Question<Dim>& question) {
  const Rows<Dim> rows = rows_of(question.constraints);
  return question.options.smoothing == 0.0 ? merge_coincident(rows) : rows;
}

// Whether most rows of `b` are rows of `a`.
template <int Dim>
bool alike(const Constraints<Dim>& a, const Question<Dim>& b) {
  try {
    const Points<Dim> before = rows_of(a).centers, now = rows_to_solve(b).centers;
    return RowFinder<Dim>(before).match(now).size() <= now.cols() / 2;
  } catch (const ConstraintError&) {
    return false;
  }
}

}  // namespace

template <int Dim>
struct BackgroundSolver<Dim>::State {
  using Ask = Question<Dim>;
  /// A question that was refused elsewhere.
  struct Refusal {
    Ask question;
    std::exception_ptr error;
  };
  enum class Work { full, border, refit };

  BackgroundOptions options;
  std::optional<EditSession<Dim>> session;
  std::unique_ptr<BackgroundSession<Dim>> running;
  Work work = Work::full;  // of what is running
  /// The last that was asked, while it has no answer.
  std::optional<Ask> waiting;
  /// What it needs: a border or a full fit.
  Work due = Work::full;
  /// To be shown until then.
  std::optional<Fit<Dim>> newer;
  std::optional<Refusal> refusal;
  std::optional<double> difference;
  /// Grows with every answer. A refit that was declined is not repeated before it has grown, and a function
  /// that was begun before it grew is older than what is shown.
  std::uint64_t answers = 0, declined = ~std::uint64_t{0}, begun = 0;

  Fit<Dim> answer(const Constraints<Dim>& constraints, const FitOptions& fit_options);
  bool poll();

  Budget budget() const { return {.full = options.at_once, .border = options.border_at_once}; }
  /// What the budget allows for; none where that is not enough.
  std::optional<Fit<Dim>> at_once(const Ask& question);
  void begin(Work next, Ask question);
  void refit_where_due();
  /// Of work that the question `waiting` has no use for.
  void cancel_where_useless();
  /// Makes what has arrived the ground of further answers. True where the last answer has become another.
  bool take_in();
  bool adopt(EditSession<Dim> fresh);
};

template <int Dim>
std::optional<Fit<Dim>> BackgroundSolver<Dim>::State::at_once(const Ask& question) {
  if (refusal) {
    if (same_question(refusal->question.constraints, refusal->question.options, question))
      std::rethrow_exception(refusal->error);
    refusal.reset();
  }
  due = Work::full;
  if (!session) {
    if (rows_to_solve(question).values.size() > options.at_once) return std::nullopt;
    ++answers;
    return session.emplace(question.constraints, question.options, options.edit).fit();
  }
  if (same_question(session->constraints(), session->options(), question)) {
    answers += waiting.has_value();
    return session->fit();
  }
  try {
    const Fit<Dim>& fit = session->update(question.constraints, question.options, budget());
    ++answers;
    return fit;
  } catch (const OverBudget& over) {
    if (over.reason() == EditReport::Full::no) due = Work::border;
    return std::nullopt;
  }
}

template <int Dim>
void BackgroundSolver<Dim>::State::begin(Work next, Ask question) {
  std::optional<EditSession<Dim>> taken;
  if (next == Work::border) taken = std::exchange(session, std::nullopt);
  work = next;
  begun = answers;
  running = std::make_unique<BackgroundSession<Dim>>(std::move(question), options.edit, std::move(taken),
                                                     options.arrived);
}

template <int Dim>
void BackgroundSolver<Dim>::State::refit_where_due() {
  if (!running && session->wants_refit() && session->fit().report.rows > options.at_once &&
      declined != answers)
    begin(Work::refit, {session->constraints(), session->options()});
}

template <int Dim>
void BackgroundSolver<Dim>::State::cancel_where_useless() {
  if (running->cancelled()) return;
  // A document that grows or is dragged as a whole is still the same one: to begin anew with every step would
  // be never to show any.
  const Constraints<Dim>& constraints = running->question().constraints;
  const bool another_document =
      constraints.size() != waiting->constraints.size() && !alike(constraints, *waiting);
  if (work == Work::refit || another_document) running->cancel();
}

template <int Dim>
bool BackgroundSolver<Dim>::State::adopt(EditSession<Dim> fresh) {
  try {
    const Handover handover = session->adopt(std::move(fresh), budget());
    if (handover.adopted) {
      difference = handover.difference;
      return true;
    }
  } catch (const Error&) {  // it is no better ground than the one there is
  }
  declined = answers;
  return false;
}

template <int Dim>
bool BackgroundSolver<Dim>::State::take_in() {
  const bool cancelled = running->cancelled();
  Ask question = running->question();
  auto [fresh, error] = std::exchange(running, nullptr)->take();
  const bool is_back = work == Work::border && !session;
  if (is_back) session = std::move(fresh);
  if (error) {
    if (!cancelled) refusal = Refusal{std::move(question), error};
    return !waiting && !cancelled;
  }
  if (!waiting) return work == Work::refit && session && adopt(std::move(*fresh));

  // What was asked before is shown where it is newer than what is shown, and not of another document.
  const EditSession<Dim>& arrived = is_back ? *session : *fresh;
  newer.reset();
  if (begun == answers && alike(arrived.constraints(), *waiting)) newer = arrived.fit();
  if (!is_back && (!session || same_options(waiting->options, question.options, Dim)))
    session = std::move(fresh);
  return false;
}

template <int Dim>
bool BackgroundSolver<Dim>::State::poll() {
  if (!running || !running->ready()) return false;
  if (!waiting) return take_in();
  try {
    take_in();
    if (!at_once(*waiting)) {
      begin(due, *waiting);
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
  Ask question{constraints, fit_options};
  if (waiting) waiting = question;
  if (running) running->follow(question);
  std::optional<Fit<Dim>> fit = at_once(question);
  if (!fit && waiting && running && running->ready()) {
    take_in();
    fit = at_once(question);
  }
  if (fit) {
    waiting.reset();
    newer.reset();
    if (running && work != Work::refit) running->cancel();
    refit_where_due();
    return std::move(*fit);
  }
  waiting = std::move(question);
  if (running)
    cancel_where_useless();
  else
    begin(due, *waiting);
  throw StillSolving<Dim>(std::exchange(newer, std::nullopt));
}

template <int Dim>
BackgroundSolver<Dim>::BackgroundSolver(BackgroundOptions options) : state_(std::make_shared<State>()) {
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
std::optional<double> BackgroundSolver<Dim>::fraction() const {
  if (!state_->running || !state_->waiting) return std::nullopt;
  return state_->running->fraction();
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
