#include "sandbox2d/message_boxes.h"

#include <algorithm>
#include <optional>

#include "core/base/check.h"
#include "core/window/ui.h"

namespace seesaw {

namespace {

/// Wide enough for the buttons, and for lines of a length that reads well.
double width_of(const Question& question) {
  std::vector<std::string> labels;
  for (const Answer& answer : question.answers) labels.push_back(answer.label);
  const double margins = 40 * ui::scale();
  const double wanted = std::max(420 * ui::scale(), ui::buttons_width(labels) + margins);
  return std::min(wanted, ui::window_width() - 16);
}

std::vector<std::string> paragraphs_of(const std::string& text) {
  std::vector<std::string> result(1);
  for (const char c : text)
    if (c == '\n')
      result.emplace_back();
    else
      result.back() += c;
  return result;
}

/// The number of the answer that was given in this frame.
std::optional<std::size_t> draw_question(const Question& question) {
  for (const std::string& each : paragraphs_of(question.text)) ui::paragraph(each);
  ui::gap(8 * ui::scale());
  std::vector<std::string> labels;
  for (const Answer& answer : question.answers) labels.push_back(answer.label);
  ui::flush_right(ui::buttons_width(labels));
  std::optional<std::size_t> given;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (i > 0) ui::same_line();
    if (i == 0 ? ui::main_button(labels[i]) : ui::button(labels[i])) given = i;
  }
  if (!given && ui::foremost() && ui::key_pressed(Key::escape)) given = labels.size() - 1;
  return given;
}

}  // namespace

void Questions::ask(Question question) {
  SEESAW_CHECK_LE(std::size_t{1}, question.answers.size());
  SEESAW_CHECK_LE(question.answers.size(), std::size_t{3});
  waiting_.push_back(std::move(question));
}

void Questions::frame() {
  if (waiting_.empty()) {
    // Cleared while it was shown.
    if (!shown_.empty())
      if (const auto dialog = ui::dialog(shown_, 0, false)) ui::close_dialog();
    shown_.clear();
    return;
  }
  const Question& question = waiting_.front();
  std::function<void()> then;
  bool answered = false;
  if (const auto dialog = ui::dialog(question.title, width_of(question), false)) {
    shown_ = question.title;
    if (const auto given = draw_question(question)) {
      then = question.answers[*given].then;
      answered = true;
      ui::close_dialog();
      shown_.clear();
    }
  } else {
    // Not shown yet, or pushed away by another dialog: questions come first.
    ui::open_dialog(question.title);
  }
  if (!answered) return;
  waiting_.pop_front();
  if (then) then();
}

}  // namespace seesaw
