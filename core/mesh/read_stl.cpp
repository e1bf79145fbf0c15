// STL: triangles, each with its own three corners, as text or as 50 bytes.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "core/base/error.h"
#include "core/mesh/mesh_readers.h"
#include "core/mesh/text_lines.h"

namespace seesaw {

namespace {

constexpr std::size_t header_size = 84, facet_size = 50;

std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 4; k-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  return value;
}

PolygonSoup read_binary(std::string_view bytes, const std::string& name) {
  if (bytes.size() < header_size)
    throw FileError(
        name,
        "is neither a text STL (its first word is not \"solid\") nor as long as the header of a binary one");
  const std::size_t n = little_endian(bytes, 80), room = (bytes.size() - header_size) / facet_size;
  if (n > room)
    throw FileError(name, "its header names " + counted(static_cast<long long>(n), "triangle") +
                              ", but only " + std::to_string(room) +
                              " follow: the file is cut short, or no STL");
  const std::string_view rest = bytes.substr(header_size + n * facet_size);
  if (rest.find_first_not_of(std::string_view("\0 \r\n\t", 5)) != std::string_view::npos)
    throw FileError(name, "there is more in the file than the " +
                              counted(static_cast<long long>(n), "triangle") +
                              " its header names: it is damaged, or no STL");
  PolygonSoup soup;
  soup.coordinates.reserve(9 * n);
  for (std::size_t f = 0; f < n; ++f)
    for (std::size_t k = 0; k < 9; ++k) {
      const std::size_t at = header_size + f * facet_size + 12 + 4 * k;
      const auto value = static_cast<double>(std::bit_cast<float>(little_endian(bytes, at)));
      if (!std::isfinite(value))
        throw FileError(name, "triangle " + std::to_string(f) + ": a coordinate is not finite");
      soup.coordinates.push_back(value);
    }
  return soup;
}

class TextReader {
 public:
  TextReader(std::string_view text, const std::string& name) : lines_(text, name, {}) {}

  PolygonSoup read() {
    bool in_solid = false;
    while (lines_.next()) {
      const std::string word = lower_case(lines_[0]);
      if (word == "solid") {
        in_solid = true;
      } else if (word == "endsolid") {
        in_solid = false;
      } else if (in_solid && word == "facet") {
        facet();
      } else {
        lines_.fail("expected \"facet\" or \"endsolid\", found " + in_quotes(lines_[0]));
      }
    }
    if (in_solid) lines_.fail("the file ends before \"endsolid\": it is cut short");
    return std::move(soup_);
  }

 private:
  // The normal behind "facet" is read over: programs write anything there.
  void facet() {
    expect("outer", 2);
    for (int k = 0; k < 3; ++k) {
      expect("vertex", 4);
      for (std::size_t i = 1; i <= 3; ++i) soup_.coordinates.push_back(lines_.number(i, "a coordinate"));
    }
    expect("endloop", 1);
    expect("endfacet", 1);
  }

  void expect(const std::string& word, std::size_t words) {
    if (!lines_.next()) lines_.fail("the file ends where " + in_quotes(word) + " should stand: it is cut short");
    if (lower_case(lines_[0]) != word)
      lines_.fail("expected " + in_quotes(word) + ", found " + in_quotes(lines_[0]));
    if (lines_.size() > words) lines_.fail("too many words behind " + in_quotes(word));
  }

  TextLines lines_;
  PolygonSoup soup_;
};

}  // namespace

bool is_binary_stl(std::string_view bytes) {
  return bytes.size() >= header_size &&
         bytes.size() == header_size + facet_size * std::size_t{little_endian(bytes, 80)};
}

PolygonSoup read_stl(std::string_view bytes, const std::string& name) {
  const std::string_view text = without_byte_order_mark(bytes);
  const std::size_t word = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  const bool solid = lower_case(text.substr(word, 5)) == "solid";
  // A binary header may begin with "solid" too; text has no zero bytes.
  const bool zero = text.substr(0, 1000).find('\0') != std::string_view::npos;
  PolygonSoup soup =
      is_binary_stl(bytes) || !solid || zero ? read_binary(bytes, name) : TextReader(text, name).read();
  const auto corners = static_cast<int>(soup.vertices());
  for (int v = 0; v < corners; ++v) {
    soup.corners.push_back(v);
    if (v % 3 == 2) soup.end_polygon();
  }
  return soup;
}

}  // namespace seesaw
