#include "core/mesh/text_lines.h"

#include <charconv>
#include <cmath>

#include "core/base/error.h"
#include "core/base/text.h"

namespace seesaw {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool is_line_end(char c) { return c == '\n' || c == '\r'; }

}  // namespace

bool TextLines::next() {
  words_.clear();
  while (words_.empty() && at_ < text_.size()) {
    line_ = next_;
    bool joined = true;
    while (joined) {
      joined = false;
      while (at_ < text_.size() && !is_line_end(text_[at_])) {
        const char c = text_[at_];
        const auto skip = [&](char d) {
          return is_blank(d) || options_.separators.find(d) != std::string_view::npos;
        };
        if (skip(c)) {
          ++at_;
        } else if (!options_.comment.empty() &&
                   text_.substr(at_, options_.comment.size()) == options_.comment) {
          while (at_ < text_.size() && !is_line_end(text_[at_])) ++at_;
        } else if (options_.continuation && c == '\\' &&
                   (at_ + 1 == text_.size() || is_line_end(text_[at_ + 1]))) {
          ++at_;
          joined = true;
        } else {
          const std::size_t begin = at_;
          while (at_ < text_.size() && !skip(text_[at_]) && !is_line_end(text_[at_]) &&
                 !(options_.continuation && text_[at_] == '\\'))
            ++at_;
          if (at_ == begin) ++at_;  // a backslash in mid-line is a word
          words_.push_back(text_.substr(begin, at_ - begin));
        }
      }
      if (at_ < text_.size()) {
        at_ += text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n' ? 2 : 1;
        ++next_;
      } else {
        joined = false;
      }
    }
  }
  return !words_.empty();
}

void TextLines::fail(const std::string& message) const { throw FileError(name_, line_, message); }

double TextLines::number_or_nan(std::size_t i, std::string_view what) const {
  if (i >= words_.size()) fail("expected " + std::string(what) + " but the line ends");
  const auto value = parse_number(words_[i]);
  if (!value) fail("expected a number for " + std::string(what) + ", found " + in_quotes(words_[i]));
  if (std::isinf(*value)) fail(std::string(what) + " is not finite: " + in_quotes(words_[i]));
  return *value;
}

double TextLines::number(std::size_t i, std::string_view what) const {
  const double value = number_or_nan(i, what);
  if (std::isnan(value)) fail(std::string(what) + " is not finite: " + in_quotes(words_[i]));
  return value;
}

long long TextLines::integer(std::size_t i, std::string_view what) const {
  if (i >= words_.size()) fail("expected " + std::string(what) + " but the line ends");
  const std::string_view word = words_[i];
  long long value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size())
    fail("expected a whole number for " + std::string(what) + ", found " + in_quotes(word));
  return value;
}

std::string printable(std::string_view word) {
  constexpr std::size_t most = 40;
  std::string result;
  for (const char c : word.substr(0, most)) result += c >= ' ' && c <= '~' ? c : '?';
  return result + (word.size() > most ? "..." : "");
}

std::string in_quotes(std::string_view word) { return '"' + printable(word) + '"'; }

std::string counted(long long n, const std::string& noun) {
  const bool vertex = noun.ends_with("vertex");
  if (n == 1) return "1 " + noun;
  return std::to_string(n) + " " + (vertex ? noun.substr(0, noun.size() - 2) + "ices" : noun + "s");
}

std::string_view without_byte_order_mark(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return text;
}

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

}  // namespace seesaw
