#include "core/raytrace/csg_expression.h"

#include <algorithm>
#include <string>

#include "core/base/error.h"

namespace seesaw {

namespace {

// Dijkstra's shunting yard: operators wait on a stack of our own, so that no depth of brackets is too deep.
class Yard {
 public:
  Yard(std::string_view text, const std::vector<Solid>& solids) : text_(text), solids_(solids) {}

  Solid solid() {
    bool want_operand = true;
    for (at_ = 0; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == ' ' || c == '\t' || c == '\n' || c == '\r') continue;
      if (want_operand && c >= '0' && c <= '9') {
        operands_.push_back(solids_[number()]);
        want_operand = false;
      } else if (want_operand && c == '(') {
        waiting_.push_back({c, at_});
      } else if (want_operand) {
        fail("expected a number or \"(\" here", at_);
      } else if (c == '|' || c == '&' || c == '-') {
        while (!waiting_.empty() && waiting_.back().what != '(' && rank(waiting_.back().what) >= rank(c))
          apply();
        waiting_.push_back({c, at_});
        want_operand = true;
      } else if (c == ')') {
        while (!waiting_.empty() && waiting_.back().what != '(') apply();
        if (waiting_.empty()) fail("no \"(\" belongs to this \")\"", at_);
        waiting_.pop_back();
      } else {
        fail("expected \"|\", \"&\", \"-\" or \")\" here", at_);
      }
    }
    if (want_operand) fail("expected a number or \"(\" here", text_.size());
    while (!waiting_.empty()) {
      if (waiting_.back().what == '(') fail("no \")\" belongs to this \"(\"", waiting_.back().at);
      apply();
    }
    return operands_.back();
  }

 private:
  struct Waiting {
    char what;
    std::size_t at;
  };

  static int rank(char c) { return c == '&' ? 2 : 1; }

  [[noreturn]] void fail(const std::string& message, std::size_t at) const {
    std::string shown(text_);
    std::replace_if(
        shown.begin(), shown.end(), [](char c) { return c == '\t' || c == '\n' || c == '\r'; }, ' ');
    throw Error(message + "\n    " + shown + "\n    " + std::string(at, ' ') + "^");
  }

  // Leaves at_ on the last digit.
  std::size_t number() {
    const std::size_t first = at_;
    std::size_t value = 0;
    for (;; ++at_) {
      value = std::min<std::size_t>(10 * value + static_cast<std::size_t>(text_[at_] - '0'), 1000000000);
      if (at_ + 1 == text_.size() || text_[at_ + 1] < '0' || text_[at_ + 1] > '9') break;
    }
    if (value >= solids_.size())
      fail(solids_.size() == 1 ? "there is only number 0"
                               : "the numbers are 0 to " + std::to_string(solids_.size() - 1),
           first);
    return value;
  }

  void apply() {
    const Solid b = operands_.back();
    operands_.pop_back();
    Solid& a = operands_.back();
    const char what = waiting_.back().what;
    a = what == '|' ? a | b : what == '&' ? a & b : a - b;
    waiting_.pop_back();
  }

  std::string_view text_;
  const std::vector<Solid>& solids_;
  std::size_t at_ = 0;
  std::vector<Solid> operands_;
  std::vector<Waiting> waiting_;
};

}  // namespace

Solid csg_solid(std::string_view expression, const std::vector<Solid>& solids) {
  return Yard(expression, solids).solid();
}

}  // namespace seesaw
