#include "cli/points_file.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <optional>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/scene/json_text.h"

namespace seesaw {

namespace {

bool blank(char c) { return c == ' ' || c == '\t'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

// The columns of a trimmed line, one after the other.
class Columns {
 public:
  explicit Columns(std::string_view line) : rest_(line), more_(!line.empty()) {}

  /// Nothing behind the last column; an empty one before, between and behind commas that have nothing there.
  std::optional<std::string_view> next() {
    if (!more_) return std::nullopt;
    std::size_t end = 0;
    while (end < rest_.size() && !blank(rest_[end]) && rest_[end] != ',') ++end;
    const std::string_view column = rest_.substr(0, end);
    while (end < rest_.size() && blank(rest_[end])) ++end;
    more_ = end < rest_.size();
    if (more_ && rest_[end] == ',') do
        ++end;
      while (end < rest_.size() && blank(rest_[end]));
    rest_.remove_prefix(end);
    return column;
  }

 private:
  std::string_view rest_;
  bool more_;
};

// For messages: in quotes, escaped, and not a whole binary file.
std::string quoted(std::string_view text) {
  constexpr std::size_t most = 40;
  return text.size() <= most ? json_string(text) : json_string(text.substr(0, most)) + "...";
}

template <int Dim>
Point<Dim> parse_point(std::string_view line, const std::string& name, int number) {
  Point<Dim> point;
  std::array<std::string_view, Dim> found;
  int count = 0;
  Columns columns(line);
  while (const auto column = columns.next()) {
    if (count < Dim) found[static_cast<std::size_t>(count)] = *column;
    ++count;
  }
  if (count != Dim)
    throw FileError(name, number,
                    "expected " + std::to_string(Dim) + " columns (" + (Dim == 2 ? "x y" : "x y z") +
                        "), found " + std::to_string(count) + ": " + quoted(line));
  for (int d = 0; d < Dim; ++d) {
    const std::string_view column = found[static_cast<std::size_t>(d)];
    const std::optional<double> value = parse_number(column);
    if (!value || !std::isfinite(*value))
      throw FileError(name, number,
                      "column " + std::to_string(d + 1) + ": expected a finite number, found " +
                          (column.empty() ? "nothing" : quoted(column)));
    // As core/rbf/system.cpp has it for constraints: the cube of what is larger is no double.
    if (std::abs(*value) > 1e100)
      throw FileError(name, number,
                      "column " + std::to_string(d + 1) + ": " + quoted(column) +
                          " is beyond 1e100; choose another unit of length");
    point[d] = *value;
  }
  return point;
}

std::string read_standard_input() {
  std::string bytes;
  std::string block(std::size_t{1} << 16, '\0');
  for (;;) {
    const ::ssize_t n = ::read(STDIN_FILENO, block.data(), block.size());
    if (n == 0) return bytes;
    if (n > 0) {
      bytes.append(block, 0, static_cast<std::size_t>(n));
    } else if (errno != EINTR) {
      throw FileError("standard input", std::string("cannot be read: ") + std::strerror(errno));
    }
  }
}

}  // namespace

std::string read_text(const std::string& path) {
  return path == "-" ? read_standard_input() : read_file(path);
}

std::string name_of_input(const std::string& path) { return path == "-" ? "standard input" : path; }

template <int Dim>
PointsText<Dim> parse_points(std::string_view text, const std::string& name) {
  // The byte order mark that some spreadsheets write.
  if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
  PointsText<Dim> result;
  // Room for every line first; a million points are not worth growing a matrix for.
  result.points.resize(Dim, static_cast<Index>(std::count(text.begin(), text.end(), '\n')) + 1);
  Index n = 0;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    const std::string_view content = trimmed(line);
    if (content.empty() || content.front() == '#')
      result.remarks.push_back({n, line});
    else
      result.points.col(n++) = parse_point<Dim>(content, name, number);
  }
  result.points.conservativeResize(Dim, n);
  return result;
}

template PointsText<2> parse_points<2>(std::string_view, const std::string&);
template PointsText<3> parse_points<3>(std::string_view, const std::string&);

}  // namespace seesaw
