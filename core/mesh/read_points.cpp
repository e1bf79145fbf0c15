// Points as text: .xyz, .pwn ("points with normals"), .csv and their relatives.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/mesh/mesh_readers.h"
#include "core/mesh/text_lines.h"

namespace seesaw {

namespace {

constexpr std::array<std::string_view, 6> names = {"x", "y", "z", "nx", "ny", "nz"};

class PointsReader {
 public:
  PointsReader(std::string_view text, const std::string& name)
      : lines_(text, name, {.comment = "#", .separators = separators_of(text)}), name_(name) {}

  PolygonSoup read() {
    if (!lines_.next()) throw FileError(name_, "is empty");
    if (const auto count = lone_count(lines_)) {
      promised_ = *count;
      // A point takes six characters or more: "0 0 0" and the end of its line.
      if (promised_ > static_cast<long long>(lines_.left() + 1) / 6)
        lines_.fail("the first line names " + counted(promised_, "point") + ", more than the file holds");
      if (!lines_.next()) lines_.fail("the file ends behind the number of its points");
      read_rows();
      split_promised();
    } else {
      if (!parse_number(lines_[0])) read_names();
      const bool named = columns_ > 0;
      read_rows();
      if (!named && are_colors(soup_.normals)) soup_.normals.clear();
    }
    return std::move(soup_);
  }

 private:
  // Where a comma can only be a decimal comma it separates nothing, and is refused as part of a number:
  // between semicolons ("0,5;1"), and in words that blanks already separate ("0,5 0,25 1,0", which would
  // otherwise pass for a point with its normal).
  static std::string_view separators_of(std::string_view text) {
    const auto has_semicolon = [](std::string_view word) { return word.find(';') != std::string_view::npos; };
    TextLines lines(text, {}, {});
    while (lines.next()) {
      if (std::any_of(lines.words().begin(), lines.words().end(), has_semicolon)) return ";";
      if (lines.size() == 1 || !parse_number(lines[0].substr(0, lines[0].find(',')))) continue;
      const auto inner_comma = [](std::string_view word) {
        const std::size_t at = word.find(',');
        return at != std::string_view::npos && at > 0 && at + 1 < word.size() &&
               word.find(',', at + 1) == std::string_view::npos;
      };
      const bool columns = lines.size() == 3 || lines.size() == 6;
      return columns && std::any_of(lines.words().begin(), lines.words().end(), inner_comma) ? "" : ",";
    }
    return ",";
  }

  static std::optional<long long> lone_count(const TextLines& lines) {
    if (lines.size() != 1) return std::nullopt;
    long long count = 0;
    const std::string_view word = lines[0];
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
    if (error != std::errc() || end != word.data() + word.size() || count < 0) return std::nullopt;
    return count;
  }

  // "NX", NormalX, normal_x and //X (CloudCompare's first line) in one spelling.
  static std::string plain_name(std::string_view written) {
    std::string word = lower_case(written);
    std::erase_if(word, [](char c) { return c == '"' || c == '/' || c == '_'; });
    return word.starts_with("normal") ? "n" + word.substr(6) : word;
  }

  // A line of column names: which column is x?
  void read_names() {
    columns_ = lines_.size();
    for (std::size_t k = 0; k < names.size(); ++k)
      for (std::size_t i = 0; i < columns_; ++i) {
        if (plain_name(lines_[i]) == names[k]) column_[k] = static_cast<int>(i);
      }
    if (column_[0] < 0 || column_[1] < 0 || column_[2] < 0)
      lines_.fail("expected numbers, or a line with the column names x, y, z (and nx, ny, nz), found " +
                  in_quotes(lines_[0]));
    normals_ = column_[3] >= 0 && column_[4] >= 0 && column_[5] >= 0;
    if (!lines_.next()) lines_.fail("there are no points below the column names");
  }

  void read_rows() {
    if (columns_ == 0) {
      columns_ = lines_.size();
      if (columns_ != 3 && columns_ != 6)
        lines_.fail("expected x y z or x y z nx ny nz, found " +
                    counted(static_cast<long long>(columns_), "column"));
      for (std::size_t k = 0; k < columns_; ++k) column_[k] = static_cast<int>(k);
      normals_ = columns_ == 6;
    }
    do {
      if (lines_.size() != columns_)
        lines_.fail("expected " + counted(static_cast<long long>(columns_), "column") + " as above, found " +
                    std::to_string(lines_.size()));
      // Behind as many points as were promised stand their normals.
      const bool second_block = promised_ >= 0 && !normals_ && soup_.vertices() >= promised_;
      for (std::size_t k = 0; k < (normals_ ? 6u : 3u); ++k) {
        const auto i = static_cast<std::size_t>(column_[k]);
        if (k >= 3)
          soup_.normals.push_back(lines_.number_or_nan(i, "a normal"));
        else if (second_block)
          soup_.coordinates.push_back(lines_.number_or_nan(i, "a normal"));
        else
          soup_.coordinates.push_back(lines_.number(i, "a coordinate"));
      }
    } while (lines_.next());
  }

  // Three whole numbers from 0 to 255 behind every point, some of them large: x y z r g b, and no normals.
  static bool are_colors(const std::vector<double>& columns) {
    double largest = 0;
    for (const double c : columns) {
      if (!(c >= 0 && c <= 255 && c == std::floor(c))) return false;
      largest = std::max(largest, c);
    }
    return largest >= 16;
  }

  // As many rows as promised; or twice as many of three columns, points first, then normals.
  void split_promised() {
    const long long rows = soup_.vertices();
    if (!normals_ && rows == 2 * promised_) {
      const auto middle =
          soup_.coordinates.begin() + static_cast<std::ptrdiff_t>(soup_.coordinates.size() / 2);
      soup_.normals.assign(middle, soup_.coordinates.end());
      soup_.coordinates.erase(middle, soup_.coordinates.end());
    } else if (rows != promised_) {
      throw FileError(name_, "its first line names " + counted(promised_, "point") + ", and " +
                                 counted(rows, "line") + " of numbers follow");
    }
  }

  TextLines lines_;
  std::string name_;
  PolygonSoup soup_;
  long long promised_ = -1;
  std::size_t columns_ = 0;
  std::array<int, 6> column_ = {-1, -1, -1, -1, -1, -1};
  bool normals_ = false;
};

}  // namespace

PolygonSoup read_points(std::string_view text, const std::string& name) {
  return PointsReader(without_byte_order_mark(text), name).read();
}

}  // namespace seesaw
