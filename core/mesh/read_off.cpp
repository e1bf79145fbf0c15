// Geomview's OFF, in text (man 5 off): counts, vertices, polygons.
#include <algorithm>

#include "core/base/error.h"
#include "core/mesh/mesh_readers.h"
#include "core/mesh/text_lines.h"

namespace seesaw {

namespace {

class OffReader {
 public:
  OffReader(std::string_view text, const std::string& name) : lines_(text, name, {}), name_(name) {}

  PolygonSoup read() {
    header();
    for (Index i = 0; i < vertices_; ++i) vertex(i);
    for (Index i = 0; i < polygons_; ++i) polygon(i);
    if (lines_.next())
      lines_.fail("there is more in the file than the " + counted(vertices_, "vertex") + " and " +
                  counted(polygons_, "face") + " its header names");
    return std::move(soup_);
  }

 private:
  void header() {
    if (!lines_.next()) throw FileError(name_, "is empty");
    std::size_t first = 0;
    if (const std::string word(lines_[0]); word.ends_with("OFF")) {
      read_keyword(word.substr(0, word.size() - 3), word);
      first = 1;
      if (lines_.size() > 1 && lower_case(lines_[1]) == "binary")
        lines_.fail("binary OFF files are not read");
      if (lines_.size() == 1) {
        first = 0;
        if (!lines_.next()) lines_.fail("the file ends where its counts of vertices and faces should be");
      }
    }
    if (lines_.size() < first + 2) lines_.fail("expected the numbers of vertices, faces and edges");
    vertices_ = count(first, "the number of vertices");
    polygons_ = count(first + 1, "the number of faces");
    // A vertex takes six characters or more, "0 0 0" and the end of its line; a face two.
    const auto room = static_cast<Index>(lines_.left()) + 1;
    if (vertices_ > room / 6 || polygons_ > (room - 6 * vertices_) / 2)
      lines_.fail("the header names " + counted(vertices_, "vertex") + " and " + counted(polygons_, "face") +
                  ", more than the file holds");
    soup_.coordinates.reserve(3 * static_cast<std::size_t>(vertices_));
  }

  void read_keyword(std::string_view prefix, std::string_view word) {
    // In this order: texture coordinates, colors, normals, a fourth coordinate.
    if (prefix.starts_with("ST")) prefix.remove_prefix(2);
    if (prefix.starts_with("C")) prefix.remove_prefix(1);
    normals_ = prefix.starts_with("N");
    if (normals_) prefix.remove_prefix(1);
    if (prefix == "4" || prefix == "n" || prefix == "4n")
      lines_.fail(in_quotes(word) + " has points of other than three dimensions, which are not read");
    if (!prefix.empty()) lines_.fail("expected OFF, COFF, NOFF or the like, found " + in_quotes(word));
  }

  Index count(std::size_t i, const char* what) const {
    const long long n = lines_.integer(i, what);
    if (n < 0) lines_.fail(std::string(what) + " is negative");
    return n;
  }

  void next_line(const char* what, Index i, Index n) {
    if (!lines_.next())
      lines_.fail("the file ends after " + std::to_string(i) + " of the " + counted(n, what) +
                  " its header names");
  }

  void vertex(Index i) {
    next_line("vertex", i, vertices_);
    for (std::size_t k = 0; k < 3; ++k) soup_.coordinates.push_back(lines_.number(k, "a coordinate"));
    for (std::size_t k = 3; normals_ && k < 6; ++k)
      soup_.normals.push_back(lines_.number_or_nan(k, "a normal"));
    // Colors and textures stand behind, announced or not.
    for (std::size_t k = normals_ ? 6 : 3; k < lines_.size(); ++k) lines_.number_or_nan(k, "a color");
  }

  void polygon(Index i) {
    next_line("face", i, polygons_);
    const long long n = lines_.integer(0, "the number of corners");
    if (n < 0 || n > static_cast<long long>(lines_.size()) - 1)
      lines_.fail("the face has " + std::to_string(n) + " corners by its first number, and " +
                  counted(static_cast<long long>(lines_.size()) - 1, "number") + " behind it");
    for (std::size_t k = 1; k <= static_cast<std::size_t>(n); ++k) {
      const long long v = lines_.integer(k, "a vertex");
      if (v < 0 || v >= vertices_)
        lines_.fail("vertex " + std::to_string(v) + " is out of range: the file has " +
                    counted(vertices_, "vertex") + ", counted from 0");
      soup_.corners.push_back(static_cast<int>(v));
    }
    soup_.end_polygon();
  }

  TextLines lines_;
  std::string name_;
  PolygonSoup soup_;
  Index vertices_ = 0, polygons_ = 0;
  bool normals_ = false;
};

}  // namespace

PolygonSoup read_off(std::string_view text, const std::string& name) {
  return OffReader(without_byte_order_mark(text), name).read();
}

}  // namespace seesaw
