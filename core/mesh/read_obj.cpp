// Wavefront OBJ, appendix B1 of the Advanced Visualizer manual, as far as it speaks of polygons.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/error.h"
#include "core/mesh/mesh_readers.h"
#include "core/mesh/text_lines.h"

namespace seesaw {

namespace {

bool is_read_over(std::string_view word) {
  constexpr std::array<std::string_view, 18> words = {
      "vt",     "vp",         "g",         "o",   "s",     "mg",       "usemtl",   "mtllib", "usemap",
      "maplib", "shadow_obj", "trace_obj", "lod", "bevel", "c_interp", "d_interp", "ctech",  "stech"};
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_free_form(std::string_view word) {
  constexpr std::array<std::string_view, 14> words = {"cstype", "deg",  "bmat", "step", "curv",
                                                      "curv2",  "surf", "parm", "trim", "hole",
                                                      "scrv",   "sp",   "end",  "con"};
  return std::find(words.begin(), words.end(), word) != words.end();
}

class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& name)
      : lines_(text, name, {.comment = "#", .separators = {}, .continuation = true}), name_(name) {}

  PolygonSoup read() {
    while (lines_.next()) statement();
    check_forward_references();
    if (soup_.polygons() == 0 && soup_.lines_and_points == 0 && normals_.size() == soup_.coordinates.size())
      soup_.normals = normals_;
    else if (corners_agree_ && !normals_.empty())
      take_corner_normals();
    return std::move(soup_);
  }

 private:
  void statement() {
    const std::string_view word = lines_[0];
    if (word == "v") {
      vertex();
    } else if (word == "vn") {
      if (lines_.size() != 4) lines_.fail("expected vn and three numbers, found " + counted_words());
      for (std::size_t i = 1; i <= 3; ++i) normals_.push_back(lines_.number_or_nan(i, "a normal"));
    } else if (word == "f" || word == "fo") {
      for (std::size_t i = 1; i < lines_.size(); ++i) corner(lines_[i]);
      soup_.end_polygon();
    } else if (word == "l" || word == "p") {
      for (std::size_t i = 1; i < lines_.size(); ++i)
        resolve_vertex(lines_[i].substr(0, lines_[i].find('/')));
      ++soup_.lines_and_points;
    } else if (is_free_form(word)) {
      lines_.fail("free-form curves and surfaces (" + in_quotes(word) + ") are not read, only polygons");
    } else if (!is_read_over(word)) {
      lines_.fail("unknown statement " + in_quotes(word) +
                  "; expected v, vn, vt, f, g, o ... as in an OBJ file");
    }
  }

  // x y z, and behind them a weight (w), a color (r g b), or a color with opacity.
  void vertex() {
    const std::size_t n = lines_.size() - 1;
    if (n < 3 || n > 7 || n == 5)
      lines_.fail("expected v and 3, 4, 6 or 7 numbers, found " + counted_words());
    for (std::size_t i = 1; i <= n; ++i) {
      const double value = lines_.number(i, i <= 3 ? "a coordinate" : "a color");
      if (i <= 3) soup_.coordinates.push_back(value);
    }
  }

  std::string counted_words() const {
    return counted(static_cast<long long>(lines_.size()) - 1, "word") + " behind it";
  }

  // v, v/vt, v//vn or v/vt/vn.
  void corner(std::string_view word) {
    const std::size_t slash = word.find('/');
    const int v = resolve_vertex(word.substr(0, slash));
    soup_.corners.push_back(v);
    long long n = -1;
    if (slash != std::string_view::npos) {
      const std::string_view rest = word.substr(slash + 1);
      const std::size_t second = rest.find('/');
      const std::string_view texture = rest.substr(0, second);
      // Textures are not ours, and tools that strip them leave their numbers behind: any number will do.
      if (!texture.empty()) integer(texture);
      if (second != std::string_view::npos && second + 1 < rest.size())
        n = resolve(integer(rest.substr(second + 1)), normals_.size() / 3, "normal", last_normal_,
                    normal_line_);
    }
    note_normal(v, n);
  }

  int resolve_vertex(std::string_view word) {
    return static_cast<int>(
        resolve(integer(word), soup_.coordinates.size() / 3, "vertex", last_vertex_, vertex_line_));
  }

  long long integer(std::string_view word) const {
    long long value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size())
      lines_.fail("expected an index, found " + in_quotes(word));
    return value;
  }

  // Negative indices count back from the last one so far; positive ones may run ahead of the file, to be
  // checked at its end.
  long long resolve(long long index, std::size_t so_far, const char* what, long long& last, int& line) const {
    const auto n = static_cast<long long>(so_far);
    if (index == 0) lines_.fail(std::string(what) + " 0: indices count from 1");
    if (index < 0) {
      if (index < -n) lines_.fail(out_of_range(what, index, n));
      return n + index;
    }
    if (index > std::numeric_limits<int>::max()) lines_.fail(out_of_range(what, index, n));
    if (index > last) {
      last = index;
      line = lines_.line();
    }
    return index - 1;
  }

  static std::string out_of_range(const std::string& what, long long index, long long n) {
    return what + " " + std::to_string(index) + " is out of range: the file has " +
           counted(n, what == "vertex" ? "vertex" : "normal");
  }

  void check_forward_references() const {
    const auto vertices = static_cast<long long>(soup_.coordinates.size() / 3);
    const auto normals = static_cast<long long>(normals_.size() / 3);
    if (last_vertex_ > vertices)
      throw FileError(name_, vertex_line_, out_of_range("vertex", last_vertex_, vertices));
    if (last_normal_ > normals)
      throw FileError(name_, normal_line_, out_of_range("normal", last_normal_, normals));
  }

  // One normal a vertex is what a mesh has room for.
  void note_normal(int vertex, long long normal) {
    if (!corners_agree_) return;
    corner_normals_.push_back({vertex, normal});
    corners_agree_ = normal >= 0;
  }

  void take_corner_normals() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<long long> normal_of(soup_.coordinates.size() / 3, -1);
    const auto same = [&](long long a, long long b) {
      for (std::size_t k = 0; k < 3; ++k)
        if (normals_[3 * static_cast<std::size_t>(a) + k] != normals_[3 * static_cast<std::size_t>(b) + k])
          return false;
      return true;
    };
    for (const auto& [vertex, normal] : corner_normals_) {
      long long& known = normal_of[static_cast<std::size_t>(vertex)];
      if (known >= 0 && known != normal && !same(known, normal)) return;
      known = normal;
    }
    soup_.normals.assign(soup_.coordinates.size(), nan);
    for (std::size_t v = 0; v < normal_of.size(); ++v)
      for (std::size_t k = 0; k < 3 && normal_of[v] >= 0; ++k)
        soup_.normals[3 * v + k] = normals_[3 * static_cast<std::size_t>(normal_of[v]) + k];
  }

  TextLines lines_;
  std::string name_;
  PolygonSoup soup_;
  std::vector<double> normals_;
  struct CornerNormal {
    int vertex;
    long long normal;
  };
  std::vector<CornerNormal> corner_normals_;
  bool corners_agree_ = true;
  long long last_vertex_ = 0, last_normal_ = 0;  // the largest index so far, from 1, and its line
  int vertex_line_ = 0, normal_line_ = 0;
};

}  // namespace

PolygonSoup read_obj(std::string_view text, const std::string& name) {
  return ObjReader(without_byte_order_mark(text), name).read();
}

}  // namespace seesaw
