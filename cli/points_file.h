// Points as text: one a line, columns separated by blanks or commas.
//
// Before it: a file from a spreadsheet, a script, another program.  After it: one batch for a field to
// evaluate.
//
//     # x, y
//     0.5, 0.25
//     1e-3 -2
//
// Between two columns stands one comma, blanks (spaces, tabs), or both. Lines may end in LF or CRLF. Empty
// lines and lines that start with # are kept as they are, so that line numbers of what goes in and what comes
// out match.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/types.h"

namespace seesaw {

template <int Dim>
struct PointsText {
  Points<Dim> points;  ///< Dim x N
  /// A line that is not a point, without its line ending.
  struct Remark {
    Index before = 0;  ///< how many points stand above it
    std::string_view line;
  };
  std::vector<Remark> remarks;
};

/// Everything in `path`; "-" is standard input. Throws FileError.
std::string read_text(const std::string& path);

/// What errors call `path`: "standard input" for "-".
std::string name_of_input(const std::string& path);

/// The points in `text`, which must outlive the result. Throws FileError with `name`, the line and what was
/// expected.
template <int Dim>
PointsText<Dim> parse_points(std::string_view text, const std::string& name);

}  // namespace seesaw
