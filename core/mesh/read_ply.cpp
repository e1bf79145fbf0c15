// Stanford PLY (Turk 1994), text and binary: the elements in the order of the header, of which the vertices
// and the faces are kept.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/base/error.h"
#include "core/mesh/mesh_readers.h"
#include "core/mesh/ply_header.h"
#include "core/mesh/text_lines.h"

namespace seesaw {

namespace {

// Where the numbers come from: both kinds of file answer the same three questions.
class TextNumbers {
 public:
  TextNumbers(std::string_view body, const std::string& name, int lines)
      : lines_(body, name, {.comment = {}, .separators = {}}, lines) {}

  // Each element has a line of its own, and each number two characters, with what stands between.
  bool has_room(const PlyElement& element) const {
    const std::size_t each = 2 * element.properties.size();
    return each == 0 || static_cast<std::size_t>(element.count) <= (lines_.left() + 1) / each;
  }
  void begin(const PlyElement& element, Index i) {
    if (i == 0) {
      what_ = element.name;
      property_ = "a property of " + in_quotes(what_);
    }
    number_ = i;
    word_ = 0;
    if (element.properties.empty()) return;
    if (!lines_.next())
      lines_.fail("the file ends after " + std::to_string(i) + " of the " + std::to_string(element.count) +
                  " elements " + in_quotes(what_) + " its header names");
  }
  void end(const PlyElement& element) {
    if (!element.properties.empty() && word_ < lines_.size())
      lines_.fail("more numbers than a " + in_quotes(what_) + " has by the header");
  }
  void end_of_file() {
    if (lines_.next()) lines_.fail("there is more in the file than its header names");
  }
  double real(PlyType) { return lines_.number_or_nan(word_++, property_); }
  long long integer(PlyType type) {
    const long long value = lines_.integer(word_++, property_);
    const auto bits = static_cast<int>(8 * size_of(type));
    const bool is_signed = type == PlyType::int8 || type == PlyType::int16 || type == PlyType::int32;
    const long long low = is_signed ? -(1LL << (bits - 1)) : 0,
                    high = (1LL << (is_signed ? bits - 1 : bits)) - 1;
    if (value < low || value > high)
      fail(std::to_string(value) + " does not fit into the type the header names");
    return value;
  }
  // Are there as many numbers left in this element as a list wants?
  void expect(long long n, PlyType) {
    if (n > static_cast<long long>(lines_.size() - word_))
      fail("a list names " + counted(n, "number") + ", but " + std::to_string(lines_.size() - word_) +
           " follow");
  }
  [[noreturn]] void fail(const std::string& message) const {
    lines_.fail(printable(what_) + " " + std::to_string(number_) + ": " + message);
  }

 private:
  TextLines lines_;
  std::string what_, property_;
  Index number_ = 0;
  std::size_t word_ = 0;
};

class BinaryNumbers {
 public:
  BinaryNumbers(std::string_view body, std::string name, bool big_endian)
      : bytes_(body), name_(std::move(name)), big_endian_(big_endian) {}

  bool has_room(const PlyElement& element) const {
    const std::size_t each = element.least_size();
    return each == 0 || static_cast<std::size_t>(element.count) <= bytes_.size() / each;
  }
  void begin(const PlyElement& element, Index i) {
    if (i == 0) what_ = element.name;
    number_ = i;
  }
  void end(const PlyElement&) {}
  void end_of_file() {
    // A last line feed is no data, and no harm.
    if (bytes_.find_first_not_of(std::string_view(" \t\r\n\0", 5)) != std::string_view::npos)
      throw FileError(name_, "there are " + counted(static_cast<long long>(bytes_.size()), "byte") +
                                 " in the file behind all that its header names");
  }
  double real(PlyType type) {
    if (is_integer(type)) return static_cast<double>(integer(type));
    const double value = type == PlyType::float32
                             ? static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits(4))))
                             : std::bit_cast<double>(bits(8));
    if (std::isinf(value)) fail("a number is not finite");
    return value;
  }
  long long integer(PlyType type) {
    const std::uint64_t value = bits(size_of(type));
    switch (type) {
      case PlyType::int8:
        return static_cast<std::int8_t>(value);
      case PlyType::int16:
        return static_cast<std::int16_t>(value);
      case PlyType::int32:
        return static_cast<std::int32_t>(value);
      default:
        return static_cast<long long>(value);
    }
  }
  void expect(long long n, PlyType type) {
    if (static_cast<std::size_t>(n) > bytes_.size() / size_of(type))
      fail("a list names " + counted(n, "number") + ", more than the file holds: it is cut short or damaged");
  }
  [[noreturn]] void fail(const std::string& message) const {
    throw FileError(name_, printable(what_) + " " + std::to_string(number_) + ": " + message);
  }

 private:
  std::uint64_t bits(std::size_t size) {
    if (bytes_.size() < size) fail("the file ends here: it is cut short");
    std::uint64_t value = 0;
    for (std::size_t k = 0; k < size; ++k)
      value = value << 8 | static_cast<unsigned char>(bytes_[big_endian_ ? k : size - 1 - k]);
    bytes_.remove_prefix(size);
    return value;
  }

  std::string_view bytes_;
  std::string name_;
  bool big_endian_;
  std::string what_;
  Index number_ = 0;
};

template <class Numbers>
class PlyReader {
 public:
  PlyReader(const PlyHeader& header, Numbers numbers, std::string name)
      : header_(header), numbers_(std::move(numbers)), name_(std::move(name)) {}

  PolygonSoup read() {
    for (const PlyElement& element : header_.elements)
      vertices_ += element.name == "vertex" ? element.count : 0;
    for (const PlyElement& element : header_.elements) {
      if (!numbers_.has_room(element))
        throw FileError(name_, "the header names " + std::to_string(element.count) + " elements " +
                                   in_quotes(element.name) + ", more than the file holds");
      // An element without properties takes no room at all, so that its number proves nothing.
      if (element.properties.empty() && element.name != "vertex") continue;
      if (element.name == "vertex")
        read_vertices(element);
      else if (element.name == "face")
        read_faces(element);
      else
        skip(element);
    }
    numbers_.end_of_file();
    return std::move(soup_);
  }

 private:
  void read_vertices(const PlyElement& element) {
    int axis[6];
    constexpr const char* names[] = {"x", "y", "z", "nx", "ny", "nz"};
    for (int k = 0; k < 6; ++k) {
      axis[k] = element.find(names[k]);
      const bool list = axis[k] >= 0 && element.properties[static_cast<std::size_t>(axis[k])].list;
      if (k < 3 && (axis[k] < 0 || list))
        throw FileError(name_, std::string("its vertices have no property ") + names[k]);
      if (list) axis[k] = -1;
    }
    const bool normals = axis[3] >= 0 && axis[4] >= 0 && axis[5] >= 0;
    std::vector<double> row(element.properties.size());
    for (Index i = 0; i < element.count; ++i) {
      numbers_.begin(element, i);
      for (std::size_t p = 0; p < row.size(); ++p) row[p] = value_of(element.properties[p]);
      numbers_.end(element);
      for (int k = 0; k < (normals ? 6 : 3); ++k) {
        const double value = row[static_cast<std::size_t>(axis[k])];
        if (k < 3 && !std::isfinite(value)) numbers_.fail(std::string(names[k]) + " is not a number (nan)");
        (k < 3 ? soup_.coordinates : soup_.normals).push_back(value);
      }
    }
  }

  void read_faces(const PlyElement& element) {
    int corners = element.find("vertex_indices");
    if (corners < 0) corners = element.find("vertex_index");
    const bool fits = corners >= 0 && element.properties[static_cast<std::size_t>(corners)].list &&
                      is_integer(element.properties[static_cast<std::size_t>(corners)].type);
    if (element.count > 0 && !fits)
      throw FileError(name_, "its faces have no property vertex_indices that is a list of whole numbers");
    for (Index i = 0; i < element.count; ++i) {
      numbers_.begin(element, i);
      for (std::size_t p = 0; p < element.properties.size(); ++p)
        if (static_cast<int>(p) == corners)
          read_corners(element.properties[p]);
        else
          value_of(element.properties[p]);
      numbers_.end(element);
    }
  }

  void read_corners(const PlyProperty& property) {
    for (long long n = length_of(property); n > 0; --n) {
      const long long v = numbers_.integer(property.type);
      if (v < 0 || v >= vertices_)
        numbers_.fail("vertex " + std::to_string(v) + " is out of range: the file has " +
                      counted(vertices_, "vertex") + ", counted from 0");
      soup_.corners.push_back(static_cast<int>(v));
    }
    soup_.end_polygon();
  }

  void skip(const PlyElement& element) {
    if (element.name == "tristrips" && element.count > 0)
      throw FileError(name_, "its faces are triangle strips, which are not read: save it with plain faces");
    if (element.name == "edge") soup_.lines_and_points += element.count;
    for (Index i = 0; i < element.count; ++i) {
      numbers_.begin(element, i);
      for (const PlyProperty& property : element.properties) value_of(property);
      numbers_.end(element);
    }
  }

  // Of a list: reads over it.
  double value_of(const PlyProperty& property) {
    if (!property.list) return numbers_.real(property.type);
    for (long long n = length_of(property); n > 0; --n) numbers_.real(property.type);
    return 0;
  }

  long long length_of(const PlyProperty& property) {
    const long long n = numbers_.integer(property.count_type);
    if (n < 0) numbers_.fail("a list of negative length");
    numbers_.expect(n, property.type);
    return n;
  }

  const PlyHeader& header_;
  Numbers numbers_;
  std::string name_;
  PolygonSoup soup_;
  Index vertices_ = 0;
};

}  // namespace

PolygonSoup read_ply(std::string_view bytes, const std::string& name) {
  bytes = without_byte_order_mark(bytes);
  const PlyHeader header = read_ply_header(bytes, name);
  const std::string_view body = bytes.substr(header.size);
  if (header.format == PlyHeader::Format::ascii)
    return PlyReader(header, TextNumbers(body, name, header.lines), name).read();
  const bool big = header.format == PlyHeader::Format::big_endian;
  return PlyReader(header, BinaryNumbers(body, name, big), name).read();
}

}  // namespace seesaw
