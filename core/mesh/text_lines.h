// A text file, line by line and word by word, with the number of the line for whoever has to complain.
//
// Before it: the bytes of a file.  After it: the readers of text formats (mesh_readers.h).
//
// Lines end in LF, CRLF or CR; blanks are spaces, tabs and the rarer kinds; a comment runs from `comment` to
// the end of the line; lines without a word are passed over.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace seesaw {

class TextLines {
 public:
  struct Options {
    std::string_view comment = "#";  ///< empty: there are no comments
    std::string_view separators;     ///< read like blanks
    bool continuation = false;       ///< a backslash at the end of a line joins the next one to it
  };

  /// `text` must outlive the words; `name` is what errors call the file, `line` the number before the first
  /// line.
  TextLines(std::string_view text, std::string name, Options options, int line = 0)
      : text_(text), name_(std::move(name)), options_(options), next_(line + 1) {}

  /// Goes on to the next line that has words; false at the end.
  bool next();

  /// The words of the line, and their number.
  const std::vector<std::string_view>& words() const { return words_; }
  std::size_t size() const { return words_.size(); }
  std::string_view operator[](std::size_t i) const { return words_[i]; }

  /// Of the line that words() are from, counted from 1.
  int line() const { return line_; }
  /// How many bytes have not been read yet.
  std::size_t left() const { return text_.size() - at_; }

  /// Throws FileError with name, line and `message`.
  [[noreturn]] void fail(const std::string& message) const;

  /// The finite number that word i holds, or FileError that calls it `what`.
  double number(std::size_t i, std::string_view what) const;
  /// The same, but "nan" is a number.
  double number_or_nan(std::size_t i, std::string_view what) const;
  /// The whole number that word i holds, or FileError.
  long long integer(std::size_t i, std::string_view what) const;

 private:
  std::string_view text_;
  std::string name_;
  Options options_;
  std::size_t at_ = 0;
  int line_ = 0, next_;
  std::vector<std::string_view> words_;
};

/// A word from a file as an error may show it: at most 40 characters, nothing but printable ASCII.
std::string printable(std::string_view word);
std::string in_quotes(std::string_view word);

/// "1 face", "2 faces".
std::string counted(long long n, const std::string& noun);

/// Without the byte order mark that some editors write before UTF-8.
std::string_view without_byte_order_mark(std::string_view text);

/// ASCII letters in lower case, whatever the locale.
std::string lower_case(std::string_view text);

}  // namespace seesaw
